"""tdbd.bit, tdbd.mesh and tdbd.sweep: values and files of the command line, names, messages of wrong input."""

import csv
import functools
import json
import os
import pickle
import unittest

from common import BIT, DRILLING, QUICK, ROOT, FolderTest, command

import numpy as np
import tdbd
import xarray

CONE_BIT = ROOT / "cases/bits/bit-r.toml"
CUBE_VERTICES = np.array([[x, y, z] for x in (0.0, 0.01) for y in (0.0, 0.01) for z in (0.0, 0.01)])
CUBE_FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
                       [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
CUBE = tdbd.mesh.Solid("cube", CUBE_VERTICES, CUBE_FACES)
DESIGN = """title = "two rates"
[sweep]
case = "{case}"
figures = ["removed_volume_m3"]
[set]
rock.edge_length = "8 mm"
time.step = "5 ms"
time.revolutions = 0.2
[[factors]]
key = "motion.rate_of_penetration"
values = [{values}]
"""


@functools.cache
def bit_b():
    """Bit B, read once: its body takes seconds."""
    return tdbd.bit.read(BIT)


class Bits(FolderTest):
    def test_cutters_are_those_of_the_table(self):
        bit = bit_b()
        with open(ROOT / "cases/bits/bit-b.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertEqual(bit.cutters.sizes["cutter"], len(rows))
        for row in rows:
            one = bit.cutters.sel(cutter=f"cutter-{row['cutter']}")
            self.assertAlmostEqual(float(one.tip_radius), 1e-3 * float(row["r_tip_mm"]), 12)
            self.assertAlmostEqual(float(one.back_rake), np.deg2rad(float(row["back_rake_deg"])), 12)
            self.assertEqual((str(one.zone.values), int(one.blade)), (row["zone"], int(row["blade"])))
        self.assertEqual(bit.cutters.diameter.attrs["units"], "m")

    def test_facts_are_those_of_the_analysis(self):
        done = command("bit", BIT, "-o", self.folder / "a", "--report", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        written = json.loads((self.folder / "a/analysis.json").read_text())
        bit = bit_b()
        self.assertEqual(bit.analysis(), written)
        self.assertEqual(bit.facts["mass_kg"], written["mass_kg"])
        self.assertEqual(list(bit.facts["centre_m"]), written["centre_m"])
        self.assertEqual((bit.facts["cutters"], bit.facts["parts"]), (len(written["cutters"]), len(written["parts"])))
        found = bit.imbalance()
        self.assertEqual((found.unit_law, found.mean_redundancy), (written["imbalance_of_unit_law"], written["mean_redundancy"]))
        self.assertEqual(list(found.areas), [cutter["area_m2"] for cutter in written["cutters"]])
        self.assertEqual(list(bit.parts.part.values), [part["name"] for part in written["parts"]])
        self.assertGreater(found.planar, 0)

    def test_parts_are_those_of_a_run(self):
        bit, case = bit_b(), tdbd.case(DRILLING)
        self.assertEqual(list(bit.parts.part.values), case.parts)
        self.assertEqual(str(bit.parts.kind.sel(part="cutter-5/face").values), "face")
        self.assertEqual(len(bit.surface.faces), int(bit.parts.triangles.sum()))
        radii, heights = bit.profile
        self.assertAlmostEqual(radii.max(), bit.gage_radius, delta=1e-5)
        self.assertEqual(radii.shape, heights.shape)

    def test_overrides(self):
        turned = tdbd.bit.read(BIT, adjust__back_rake="3 deg")
        change = turned.cutters.back_rake - bit_b().cutters.back_rake
        np.testing.assert_allclose(change, np.deg2rad(3), atol=1e-12)
        back = turned.replace(adjust__back_rake="0 deg").cutters.back_rake
        np.testing.assert_array_equal(back, bit_b().cutters.back_rake)
        again = pickle.loads(pickle.dumps(turned))
        np.testing.assert_array_equal(again.cutters.back_rake, turned.cutters.back_rake)

    def test_export(self):
        command("bit", BIT, "-o", self.folder / "a", "--quiet")
        bit_b().export(self.folder / "b")
        self.assertIn("cutters.csv", self.same_files(self.folder / "a", self.folder / "b"))
        again = tdbd.bit.read(self.folder / "b/bit.toml")
        self.assertAlmostEqual(again.gage_radius, bit_b().gage_radius, 12)
        with self.assertRaisesRegex(tdbd.FolderError, "b: exists; force=True overwrites"):
            again.export(self.folder / "b")
        with self.assertRaisesRegex(ValueError, "format: found 'step', expected 'ply', 'off', 'obj' or 'stl'"):
            again.export(self.folder / "c", format="step")
        with self.assertRaisesRegex(ValueError, "unit: found 'kg', expected a length unit such as 'mm' or 'in'"):
            again.export(self.folder / "c", unit="kg")
        self.assertFalse((self.folder / "c").exists())

    def test_cones(self):
        bit = tdbd.bit.read(CONE_BIT)
        self.assertEqual((bit.facts["cones"], bit.facts["cutters"]), (3, 0))
        self.assertIn("tracking", bit.analysis())

    def test_wrong_input(self):
        with self.assertRaises(tdbd.CaseError) as raised:
            tdbd.bit.read(BIT, adjust__back_rale="3 deg")
        error = raised.exception
        self.assertEqual((error.file, error.line, error.key, error.expected), ("", 0, "adjust.back_rale", "back_rake"))
        with self.assertRaisesRegex(tdbd.CaseError, "found a case to drill, .*expected a bit; try: tdbd.run"):
            tdbd.bit.read(DRILLING)
        with self.assertRaisesRegex(ValueError, "penetration: found 0, expected a length > 0 in m"):
            bit_b().imbalance(penetration=0)


class Meshes(FolderTest):
    def test_a_cube(self):
        found = tdbd.mesh.check(CUBE)
        self.assertTrue(found.sound, found.defects)
        self.assertEqual((found.vertices, found.faces, found.pieces, found.closed, found.manifold), (8, 12, 1, True, True))
        self.assertAlmostEqual(found.volume, 1e-6, 18)
        repaired = tdbd.mesh.repair(CUBE)
        self.assertEqual(repaired.steps, [])
        np.testing.assert_array_equal(repaired.solid.vertices, CUBE_VERTICES)

    def test_defects_and_repair(self):
        holed = CUBE._replace(faces=np.vstack([CUBE_FACES[1:11], CUBE_FACES[11:, ::-1]]))
        found = tdbd.mesh.check(holed)
        self.assertFalse(found.sound)
        self.assertIn("hole", {defect.kind for defect in found.defects})
        repaired = tdbd.mesh.repair(holed)
        self.assertTrue(tdbd.mesh.check(repaired.solid).sound)
        self.assertAlmostEqual(tdbd.mesh.check(repaired.solid).volume, 1e-6, 18)
        self.assertIn(("holes filled", 1), repaired.steps)
        moved = CUBE._replace(vertices=CUBE_VERTICES[CUBE_FACES].reshape(-1, 3) + 1e-6 * (np.arange(36) % 3)[:, None],
                              faces=np.arange(36).reshape(12, 3))
        self.assertTrue(tdbd.mesh.check(tdbd.mesh.repair(moved, weld="0.01 mm").solid).sound)
        fan = CUBE._replace(vertices=np.vstack([CUBE_VERTICES, [[0.02, 0.02, 0.03]]]), faces=np.vstack([CUBE_FACES, [[0, 1, 8]]]))
        for faces in (np.array([[0, 1, 2]]), fan.faces):
            broken = fan._replace(faces=faces)
            try:
                self.assertTrue(tdbd.mesh.check(tdbd.mesh.repair(broken).solid).sound)
            except tdbd.CaseError as error:
                self.assertTrue(str(error).startswith("solid cube: cannot be repaired: "), error)

    def test_files(self):
        for name in ("a.stl", "a.obj", "a.ply", "a.off"):
            tdbd.mesh.write(self.folder / name, [CUBE])
            (again,) = tdbd.mesh.read(self.folder / name)
            self.assertEqual(again.name, "cube" if name in ("a.stl", "a.obj") else "solid-1")
            np.testing.assert_allclose(np.sort(again.vertices, axis=0), np.sort(CUBE_VERTICES, axis=0), atol=1e-15)
        self.assertIn("vertex 10 10 10", (self.folder / "a.stl").read_text())  # millimetres
        tdbd.mesh.write(self.folder / "inch.obj", CUBE, unit="1 in")
        (again,) = tdbd.mesh.read(self.folder / "inch.obj")  # the header states the unit
        with self.assertRaisesRegex(tdbd.CaseError, "unit: found 1 mm, but the header of .*inch.obj states the unit in, expected"):
            tdbd.mesh.read(self.folder / "inch.obj", unit="mm")
        self.assertAlmostEqual(tdbd.mesh.check(again).volume, 1e-6, 15)
        with self.assertRaisesRegex(FileExistsError, "a.stl: exists; force=True replaces it"):
            tdbd.mesh.write(self.folder / "a.stl", CUBE)
        tdbd.mesh.write(self.folder / "a.stl", CUBE, force=True)

    def test_welds_triangles_that_share_no_points(self):
        corners = CUBE_VERTICES[np.asarray(CUBE_FACES)].reshape(-1, 3)
        cracked = corners + 1e-7 * np.sin(np.arange(corners.size)).reshape(corners.shape)
        tdbd.mesh.write(self.folder / "cracked.off", tdbd.mesh.Solid("soup", cracked, np.arange(len(corners)).reshape(-1, 3)))
        self.assertEqual(len(tdbd.mesh.read(self.folder / "cracked.off")), 12)
        (whole,) = tdbd.mesh.read(self.folder / "cracked.off", weld="0.001 mm")
        self.assertTrue(tdbd.mesh.check(whole).closed)
        self.assertAlmostEqual(tdbd.mesh.check(whole).volume, 1e-6, 9)

    def test_the_rock_of_a_run_is_in_metres(self):
        result = tdbd.run(tdbd.case(DRILLING, set=QUICK), self.folder / "run")
        (rock,) = tdbd.mesh.read(self.folder / "run/rock_final.ply")
        np.testing.assert_array_equal(rock.vertices, result.rock.vertices)
        self.assertFalse(tdbd.mesh.check(result.rock).closed)

    def test_wrong_input(self):
        for text, call in (("vertices: found 1 dimensions, expected an array",
                            lambda: tdbd.mesh.check(CUBE._replace(vertices=np.zeros(3)))),
                           ("faces: found vertex 8 in face 0, expected 0 to 7",
                            lambda: tdbd.mesh.check(CUBE._replace(faces=CUBE_FACES + 5))),
                           ("vertices: found vertex 0 that is not finite",
                            lambda: tdbd.mesh.check(CUBE._replace(vertices=CUBE_VERTICES * np.nan))),
                           ("weld: found -1, expected a length >= 0", lambda: tdbd.mesh.repair(CUBE, weld=-1)),
                           ("weld: found .*kg", lambda: tdbd.mesh.repair(CUBE, weld="1 kg")),
                           ("unit: found 0, expected a length > 0",
                            lambda: tdbd.mesh.write(self.folder / "a.stl", CUBE, unit=0))):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                call()
        (self.folder / "no.obj").write_text("v 0 0 x\n")
        with self.assertRaises(tdbd.CaseError) as raised:
            tdbd.mesh.read(self.folder / "no.obj")
        self.assertEqual((raised.exception.file, raised.exception.line), (str(self.folder / "no.obj"), 1))


class Sweeps(FolderTest):
    def design(self, values='"10 m/h", "20 m/h"'):
        path = self.folder / "design.toml"
        path.write_text(DESIGN.format(case=DRILLING, values=values))
        return path

    def test_the_table_is_that_of_the_command(self):
        design, heard = self.design(), []
        done = command("sweep", design, "-o", self.folder / "a.nc", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.demand_one_commit()
        result = tdbd.sweep.run(design, self.folder / "b.nc", threads=2, progress=lambda *at: heard.append(at))
        self.assertEqual((self.folder / "a.csv").read_bytes(), (self.folder / "b.csv").read_bytes())
        self.assertEqual((result.points, result.done, result.failed, result.complete), (2, 2, 0, True))
        self.assertIsInstance(result.data, xarray.Dataset)
        self.assertEqual(result.data.sizes, {"point": 2})
        drilled = tdbd.run(tdbd.case(DRILLING, set=QUICK | {"motion.rate_of_penetration": "20 m/h"}))
        self.assertEqual(result.records[1]["removed_volume_m3"], drilled.summary["removed_volume_m3"])
        self.assertEqual((result.records[1]["status"], result.records[1]["motion.rate_of_penetration"]), ("done", 20.0))
        self.assertEqual(heard[-1], (2, 2))
        self.assertEqual(tdbd.sweep.run(design, self.folder / "b.nc").found, 2)
        self.assertEqual(tdbd.sweep.load(self.folder / "b.nc").records, result.records)

    def test_without_a_table(self):
        result = tdbd.sweep.run(self.design())
        folder = result.table.parent
        self.assertEqual(len(result.records), 2)
        del result
        self.assertFalse(folder.exists())

    def test_points_and_figures(self):
        points = tdbd.sweep.points(self.design())
        self.assertEqual([point["motion.rate_of_penetration"] for point in points], ['"10 m/h"', '"20 m/h"'])
        self.assertIn("removed_volume_m3", tdbd.sweep.figures(self.design()))

    def test_shards_and_interruption(self):
        design = self.design()
        part = tdbd.sweep.run(design, self.folder / "a.nc", shard=(1, 2))
        self.assertEqual((part.done, part.complete), (1, False))
        with self.assertRaisesRegex(tdbd.RunError, "1 of 2 points are done"):
            part.records

        def stop(done, total):
            raise KeyboardInterrupt

        self.assertRaises(KeyboardInterrupt, tdbd.sweep.run, design, self.folder / "b.nc", progress=stop)
        self.assertEqual(tdbd.sweep.run(design, self.folder / "a.nc").found, 1)

    def test_a_point_that_fails(self):
        with self.assertWarnsRegex(tdbd.CaseWarning, "1 of 2 points failed, the first with: .*rate_of_penetration"):
            result = tdbd.sweep.run(self.design('"10 m/h", "10 kg"'))
        self.assertEqual([record["status"] for record in result.records], ["done", "failed"])

    def test_wrong_input(self):
        design = self.design()
        (self.folder / "mine.nc").write_text("mine")
        for kind, text, call in ((tdbd.FolderError, "mine.nc: exists and was not written by a sweep; force=True",
                                  lambda: tdbd.sweep.run(design, self.folder / "mine.nc")),
                                 (ValueError, "table: found a.csv, expected a file NAME.nc",
                                  lambda: tdbd.sweep.run(design, "a.csv")),
                                 (ValueError, r"shard: found 3 of 2", lambda: tdbd.sweep.run(design, shard=(3, 2))),
                                 (tdbd.CaseError, "try: tdbd.run", lambda: tdbd.sweep.run(DRILLING)),
                                 (tdbd.CaseError, "try: tdbd.sweep.run", lambda: tdbd.case(design)),
                                 (FileNotFoundError, "no table of a sweep", lambda: tdbd.sweep.load(self.folder / "none.nc"))):
            with self.subTest(text), self.assertRaisesRegex(kind, text):
                call()
        design.write_text(design.read_text().replace("rate_of_penetration", "rate_of_penetratoin"))
        with self.assertRaises(tdbd.CaseError) as raised:
            tdbd.sweep.run(design)
        self.assertIn("rate_of_penetration", raised.exception.expected)
        self.assertEqual((self.folder / "mine.nc").read_text(), "mine")


class Reprs(FolderTest):
    def test_objects_describe_themselves(self):
        case = tdbd.case(DRILLING, set=QUICK)
        sim = tdbd.Simulation(case)
        sim.step(3)
        top = tdbd.Rotation(tdbd.case(ROOT / "cases/slow-top.toml", time__duration="1 s"))
        holed = CUBE._replace(faces=CUBE_FACES[1:])
        for one, text in ((case, r"<tdbd.Case of .*bit.*, drilling: .*bit-b-steady.toml, rock.edge_length=8 mm, "),
                          (sim, r"<tdbd.Simulation of .*: step 3 of 20, t = 0.015 s, [\d.e-]+ cm3 removed>"),
                          (top, r"<tdbd.Rotation of .*: step 0 of 100, t = 0 s>"),
                          (sim.rock, r"<tdbd.Surface: \d+ vertices, \d+ faces, [\d.]+ x [\d.]+ x [\d.]+ mm>"),
                          (bit_b(), r"<tdbd.bit.Bit .*: 28 cutters, \d+ parts, gage [\d.]+ mm>"),
                          (CUBE, "<tdbd.mesh.Solid 'cube': 8 vertices, 12 faces>"),
                          (tdbd.mesh.check(CUBE), "<tdbd.mesh.Check of 12 faces, 1 pieces: sound, 1000 mm3>"),
                          (tdbd.mesh.check(holed), r"<tdbd.mesh.Check of 11 faces, 1 pieces: hole: 3>"),
                          (tdbd.mesh.repair(holed), r"<tdbd.mesh.Repaired 'cube': 1 holes filled>"),
                          (tdbd.converge(ROOT / "cases/slow-top.toml", "time.step", 3),
                           r"<tdbd.Convergence over time.step, 3 levels: .*>"),
                          (tdbd.FilesLock(), "<tdbd.FilesLock>")):
            self.assertRegex(repr(one), text)


if __name__ == "__main__":
    os.environ.setdefault("MPLBACKEND", "Agg")
    unittest.main(warnings="ignore")
