"""page3d_test.py PROGRAM ROOT: the 3-D page of a run contains its frames, reports what is missing, and rejects other folders."""

import contextlib
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import balance
import numpy as np
import page3d_data

PROGRAM, ROOT = map(pathlib.Path, sys.argv[1:3])
sys.path.insert(0, str(ROOT / "reports"))
import page3d  # noqa: E402
import page3d_pack  # noqa: E402
from figures import bit_motion, rock_data  # noqa: E402

MOST_BYTES = 2e6  # of 25 frames of bit B with edges of 2.5 mm
POSE_DIGITS = 2e-7  # m: poses have a resolution of 1e-8 and rotate points 0.2 m from the axis
RUNS = {
    "b": ("bit-b-steady.toml", "rock.edge_length=2.5 mm", "time.step=5 ms", "time.revolutions=0.75", "output.frames_every=3"),
    "r": ("bit-r-rolling.toml", "rock.edge_length=8 mm", "time.step=5 ms", "time.revolutions=0.3", "output.frames_every=10"),
    "forces": ("drill-bit-b-whirl.toml", "rock.edge_length=6 mm", "time.duration=0.1 s", "output.frames_every=100"),
    "areas": ("bit-b-3000psi.toml", "rock.edge_length=10 mm", "time.step=5 ms", "time.revolutions=0.2", "output.means_from=0.03 s",
              "forces.areas.hard={kind='face', zone='shoulder', A1=1.5}", "bit.set.areas.steel={kind='gage-pad', density=7000}"),
    "short": ("bit-b-3000psi.toml", "rock.edge_length=10 mm", "time.step=5 ms", "time.revolutions=0.1", "output.means_from=1 s"),
    "end": ("bit-b-steady.toml", "rock.edge_length=10 mm", "time.step=5 ms", "time.revolutions=0.05"),
}


def run(folder, case, *settings):
    subprocess.run([PROGRAM, "run", ROOT / "cases" / case, "-o", folder, "--quiet", *(w for s in settings for w in ("--set", s))], check=True)


def make(*arguments):
    return subprocess.run([sys.executable, "-B", ROOT / "reports/page3d.py", *arguments], capture_output=True, text=True, check=False)


def make_here(*arguments):
    """The same without a new process, which takes a second to start."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code = page3d.main([str(a) for a in arguments])
        except SystemExit as end:
            code = end.code
    return subprocess.CompletedProcess(arguments, code, out.getvalue(), err.getvalue())


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.made.name)
        for name, (case, *settings) in RUNS.items():
            run(cls.folder / name, case, *settings)

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def page(self, name, output=None):
        path = output or self.folder / name / "result.html"
        done = make_here(self.folder / name, *(("-o", path) if output else ()))
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        return path.read_text(encoding="utf-8")

    def copy(self, name, of="r"):
        shutil.copytree(self.folder / of, self.folder / name, ignore=shutil.ignore_patterns("*.html"))
        return self.folder / name

    def test_25_frames_of_bit_b_are_small(self):  # how soon they are made: benchmarks/page3d.py
        done = make(self.folder / "b")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        page = (self.folder / "b/result.html").read_text(encoding="utf-8")
        self.assertEqual(len(page3d_data.header(page)["frames"]), 25)
        self.assertLess(len(page.encode()), MOST_BYTES)
        self.assertIn("page3d: 25 frames, ", done.stdout)
        few = make_here(self.folder / "b", "--most", "3", "-o", self.folder / "few.html")
        self.assertIn("page3d: 3 of the 25 frames of the run (--most 3), ", few.stdout)
        self.assertIn(", of which this page has ${shown}", page)

    def test_contains_every_frame_within_half_a_step_and_its_triangles_exactly(self):
        for name in ("b", "r"):
            page = self.page(name)
            head, (frames, _) = page3d_data.header(page), page3d_data.frames(page)
            names = head["colours"]["part"]["names"]
            parts = list(page3d_data.json.loads((self.folder / name / "summary.json").read_text())["removed_volume_by_part_m3"])
            for frame, entry, (time, path) in zip(frames, head["frames"], rock_data.frames(self.folder / name), strict=True):
                rock = rock_data.read(path)
                self.assertEqual(entry["time_s"], time)
                off = np.abs(page3d_data.placed(frame["points"], head["box"]) - rock.points)
                self.assertLessEqual((off / head["box"]["size"]).max(), (0.5 + 1e-6) / page3d_data.STEPS)
                np.testing.assert_array_equal(frame["corners"], rock.triangles)
                shown = [names[k] for k in frame["last"][:, 0]]
                last = rock.point_values["last_part"]
                np.testing.assert_array_equal(shown, [parts[k].rsplit("/", 1)[0] if k >= 0 else "not cut" for k in last])

    def test_colours_the_bit_by_its_areas(self):
        page, plain = self.page("areas"), self.page("end")
        self.assertIn('id="bit-colour"', page)
        self.assertNotIn('id="bit-colour"', plain)
        head, (_, bit) = page3d_data.header(page), page3d_data.frames(page)
        self.assertNotIn("areas", page3d_data.header(plain)["bit"])
        areas = head["bit"]["areas"]
        self.assertEqual(sorted(areas["names"]), ["hard (law)", "no area", "steel (density)"])
        self.assertEqual(len(set(areas["colours"])), 3)
        mesh = rock_data.final(self.folder / "areas", "bit")
        parts = json.loads((self.folder / "areas/bit.json").read_text(encoding="utf-8"))["parts"]
        kinds = [parts[int(p)]["kind"] for p in mesh.cell_values["part"]]
        shoulder = [parts[int(p)]["zone"] == "shoulder" for p in mesh.cell_values["part"]]
        count = [sum(k == "face" and s for k, s in zip(kinds, shoulder)), kinds.count("gage-pad")]
        self.assertGreater(min(count), 0)
        self.assertEqual([int((bit["area"] == areas["names"].index(n)).sum()) for n in ("hard (law)", "steel (density)")], count)

    def test_moves_the_bit_and_its_cones_to_where_they_are_in_each_frame(self):
        page = self.page("r")
        head, (_, bit) = page3d_data.header(page), page3d_data.frames(page)
        self.assertEqual(sorted({p["body"] for p in head["bit"]["pieces"]}), [0, 1, 2, 3])
        bodies = np.zeros(len(bit["points"]), int)
        first = 0
        for piece in head["bit"]["pieces"]:
            bodies[bit["corners"][first:first + piece["triangles"]]] = piece["body"]
            first += piece["triangles"]
        start, step = page3d_data.placed(bit["points"], head["bit"]["box"]), np.max(head["bit"]["box"]["size"]) / page3d_data.STEPS
        turned = 0.0
        folder = self.folder / "r"
        rest, _ = bit_motion.at_rest(rock_data.final(folder, "bit"), bit_motion.poses(folder)[-1][1])
        self.assertLess(np.abs(start - rest.points).max(), step)
        for entry, (_, poses) in zip(head["frames"], bit_motion.poses(folder), strict=True):
            now = bit_motion.moved(start, bodies, np.array(entry["poses"]).reshape(-1, 3, 4))
            self.assertLess(np.abs(now - bit_motion.moved(rest.points, bodies, poses)).max(), step + POSE_DIGITS)
            turned = max(turned, np.abs(now - start).max())
        self.assertGreater(turned, 0.01, "the bit stood still: nothing was tested")

    def test_is_the_same_twice_and_fetches_nothing(self):
        page = self.page("r")
        done = make(self.folder / "r", "-o", self.folder / "again.html")  # another process: another order of hashes
        self.assertEqual(done.returncode, 0, done)
        self.assertEqual(page, (self.folder / "again.html").read_text(encoding="utf-8"))
        self.assertNotRegex(page, r"(src|href)=.(https?:|//)|url\(|import\s|fetch\(|XMLHttp")
        self.assertIn("default-src 'none'", page)
        balance.check(page)

    def test_shows_weight_torque_rate_and_diagnosis(self):
        page = self.page("forces")
        summary = page3d_data.json.loads((self.folder / "forces/summary.json").read_text())
        self.assertEqual([t["name"] for t in page3d_data.header(page)["traces"]],
                         ["Weight on bit", "Torque on bit", "Rate of penetration", "Speed of the bit"])
        words = page3d_data.text_of(page)
        for said in (f"Diagnosis: {summary['diagnosis']['text']}", summary["case_hash"], summary["commit"], f"{summary['rock_triangles_end']} at the end"):
            self.assertIn(said, words)
        rows = np.genfromtxt(self.folder / "forces/history.csv", delimiter=",", names=True)
        weight = page3d_data.header(page)["traces"][0]
        self.assertAlmostEqual(max(weight["high"]), 1e-3 * rows["weight_on_bit_N"].max(), delta=1e-3 * max(weight["high"]))
        self.assertAlmostEqual(min(weight["low"]), 1e-3 * rows["weight_on_bit_N"].min(), delta=1e-3 * max(weight["high"]))

    def test_a_run_without_a_history_has_a_page_that_says_so(self):
        folder = self.copy("without-history", of="forces")
        (folder / "history.nc").unlink()
        page = self.page("without-history")
        self.assertEqual(page3d_data.header(page)["traces"], [])
        self.assertIn("This folder has no history.nc, so there are no traces.", page3d_data.text_of(page))
        self.assertNotIn('id="no-traces"', self.page("forces"))

    def test_states_the_mse_and_the_imbalance_of_the_run(self):
        summary = json.loads((self.folder / "forces/summary.json").read_text(encoding="utf-8"))
        words = page3d_data.text_of(self.page("forces"))
        self.assertIn(f"(MSE){1e-6 * summary['mechanical_specific_energy_pa']:.4g} MPa", words)
        self.assertIn(f"imbalance{100 * summary['imbalance']:.4g} % of the weight", words)
        self.assertNotIn("(MSE)", page3d_data.text_of(self.page("end")))
        self.assertIn("The run is too short for means", page3d_data.text_of(self.page("short")))

    def test_has_the_place_force_and_area_of_every_part(self):
        page, folder = self.page("areas"), self.folder / "areas"
        summary, layout = (json.loads((folder / f"{name}.json").read_text(encoding="utf-8")) for name in ("summary", "bit"))
        parts = page3d_data.header(page)["parts"]
        self.assertEqual([p["name"] for p in parts], list(dict.fromkeys(p.rsplit("/", 1)[0] for p in summary["removed_volume_by_part_m3"])))
        forces = sum(f["normal_mean_n"] for f in summary["forces"])
        self.assertAlmostEqual(sum(p["normal_n"] or 0.0 for p in parts), forces, delta=1e-9 * forces)
        cutter, place = next(dict(p["facts"]) for p in parts if p["name"] == "cutter-7"), next(c for c in layout["cutters"] if c["name"] == "cutter-7")
        area = next(s["mean_area_m2"] for s in summary["sections"] if s["name"] == "cutter-7")
        self.assertEqual(cutter["radius of the tip"], f"{1e3 * place['tip_radius_m']:.5g} mm")
        self.assertEqual(cutter["mean area of cut"], f"{1e6 * area:.4g} mm\u00b2")
        self.assertEqual({p["normal_n"] for p in page3d_data.header(self.page("end"))["parts"]}, {None})
        self.assertIn("There are no forces of parts", page3d_data.text_of(self.page("end")))

    def test_colours_and_names_every_kind_of_part(self):
        for name, wanted in (("b", ["faces of cutters", "chamfers", "bodies of cutters", "gage pads", "body of the bit"]),
                             ("r", ["gage pads", "body of the bit", "cones", "teeth of cone 1", "teeth of cone 2", "teeth of cone 3"])):
            page = self.page(name)
            head, (_, bit) = page3d_data.header(page), page3d_data.frames(page)
            self.assertEqual(head["bit"]["names"], wanted)
            self.assertEqual(len(set(head["bit"]["colours"])), len(wanted))
            mesh = rock_data.final(self.folder / name, "bit")
            parts = list(json.loads((self.folder / name / "summary.json").read_text(encoding="utf-8"))["removed_volume_by_part_m3"])
            groups = [head["parts"][k]["name"] for k in bit["part"][:, 0]]
            self.assertEqual(sorted(groups), sorted(parts[int(p)].rsplit("/", 1)[0] for p in mesh.cell_values["part"]))

    def test_of_a_run_without_frames_shows_its_end(self):
        page = self.page("end")
        self.assertEqual(len(page3d_data.header(page)["frames"]), 1)
        self.assertIn("no force law", page3d_data.text_of(page))

    def test_a_frame_that_is_missing_or_torn_is_named_and_left_out(self):
        folder = self.copy("holes", of="b")
        gone, torn = (folder / "frames" / f"{name}.vtp" for name in ("rock-000006", "rock-000012"))
        gone.unlink()
        torn.write_bytes(torn.read_bytes()[:200_000])
        done = make(folder)
        self.assertEqual(done.returncode, 0, done)
        page = (folder / "result.html").read_text(encoding="utf-8")
        head = page3d_data.header(page)
        self.assertEqual([f["number"] for f in head["frames"]], [k for k in range(1, 26) if k not in (2, 4)])
        self.assertEqual(page3d_data.frames(page)[0][1]["corners"].shape[1], 3)
        for number, path in ((2, gone), (4, torn)):
            self.assertRegex(done.stderr, rf"page3d: left out frame {number}: frames/{path.name}: found no")
            self.assertRegex(page3d_data.text_of(page), rf"frame {number}, .* s: frames/{path.name}: found no")
        self.assertEqual(done.stderr.count("\n"), 2, done.stderr)

    def refused(self, folder, pattern):
        done = make_here(folder)
        self.assertEqual(done.returncode, 2, (folder, done))
        self.assertRegex(done.stderr, rf"^page3d: .*{pattern}")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertFalse((folder / "result.html").exists())

    def test_other_folders_are_rejected(self):
        (self.folder / "empty").mkdir()
        for name in ("nowhere", "empty"):
            self.refused(self.folder / name, "found no summary.json, expected the result folder of `tdbd run`")
        for name, text in (("text", "{"), ("list", "[]"), ("rotate", '{"command": "rotate"}'), ("old", '{"command": "run"}')):
            folder = self.copy(f"bad-{name}")
            (folder / "summary.json").write_text(text)
            self.refused(folder, "summary.json: found .*, expected what `tdbd run` writes")
        torn = self.copy("torn-history")
        (torn / "history.nc").write_bytes(b"no history")
        self.refused(torn, "history.nc: found .*, expected the history that `tdbd run` writes")
        for file, pattern in (("rock.pvd", "rock.pvd: found no such file, expected"), ("bit_poses.csv", "bit_poses.csv: found no such file, expected")):
            folder = self.copy(f"without-{file}")
            (folder / file).unlink()
            self.refused(folder, pattern)
        folder = self.copy("without-frames")
        shutil.rmtree(folder / "frames")
        self.refused(folder, "frames/bit_final.vtp: found no such file, expected a frame that `tdbd run` writes")
        done = make_here(self.folder / "r", "--most", "0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("found '0', expected a whole number from 1", done.stderr)


class Packing(unittest.TestCase):
    """On meshes that no run has: some that shrink, grow, are shuffled, and numbers at the ends of what fits."""

    def packed(self, meshes):
        """(entries, deflated sizes of the frames) of meshes that come back."""
        entries, data, sizes = page3d_data.packed(page3d_pack, meshes)
        numbers, old = page3d_data.Numbers(f'<script type="text/plain" id="data">{data}</script>'), None
        for mesh, entry in zip(meshes, entries):
            old = page3d_data.next_frame(numbers, entry, old)
            for name, values in zip(("points", "corners", "last"), mesh):
                np.testing.assert_array_equal(old[name], values, name)
        return entries, sizes

    def test_meshes_come_back_exactly(self):
        entries, _ = self.packed(page3d_data.changing_meshes())
        self.assertEqual([e["over_time"] for e in entries[:5]], [False, True, True, True, False])

    def test_large_numbers_of_either_sign_come_back(self):
        points, corners, last = page3d_data.strip(200)
        ends = np.where(last % 2 == 0, 2**29, -(2**29))
        self.packed([(points, corners, ends), (points, corners, -ends), (points, corners, ends)])

    def test_a_point_that_goes_costs_little(self):
        random = np.random.default_rng(2)
        points, corners, last = page3d_data.strip(20_000)
        mesh = random.integers(0, 65536, points.shape), corners, last
        entries, sizes = self.packed([mesh, page3d_data.without(mesh, [17, 9000, 15_000])])
        self.assertTrue(entries[1]["over_time"])
        self.assertLess(sizes[1], 0.02 * sizes[0])

    def test_a_trace_keeps_its_peaks(self):
        values = np.sin(np.arange(10_000.0))
        values[[1234, 7001]] = 9.0, -9.0
        trace = page3d.of_run.trace("x", "m", np.arange(10_000.0), values)
        self.assertEqual((max(trace["high"]), min(trace["low"])), (9.0, -9.0))
        self.assertEqual((len(trace["time"]), len(trace["high"]), len(trace["low"])), (400, 400, 400))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
