"""bit_page_test.py PROGRAM ROOT: the page of a bit from a design, of a cone bit and of a bit of meshes; bad folders."""

import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import balance
import numpy as np

PROGRAM, ROOT = map(pathlib.Path, sys.argv[1:3])
sys.path.insert(0, str(ROOT / "reports"))
import page_tables  # noqa: E402
from figures import bit_charts, bit_data, bit_pictures  # noqa: E402

ROUNDING = 1e-13  # of sums of some ten numbers of size 1
IMAGE = r'src="data:image/(?:png|svg\+xml);base64,[A-Za-z0-9+/]{2000,}=*"'
OF_ALL = ["The bit", "Its coordinate system", "Update directions", "In numbers", "Parts by kind"]
OF_CUTTERS = ["Profile", "Exposure", "Rakes", "Volume and cut area at 4 mm a revolution", "Redundancy", "Imbalance of the unit law",
              "Normals and update directions", "The cutters&#39; coordinate systems", "A cutter&#39;s mesh", "Blades", "Cutters"]
OF_CONES = ["Rows", "Cones", "Speeds of rolling", "Spacing of the teeth", "Meshes of teeth", "Rows of teeth", "Gaps between cones"]


def report(bit, folder):
    subprocess.run([PROGRAM, "bit", bit, "-o", folder, "--report", "--penetration", "4 mm", "--quiet"], check=True)


def draw(*arguments):
    return subprocess.run([sys.executable, "-B", ROOT / "reports/bit_page.py", *arguments], capture_output=True, text=True,
                          check=False)


class BitPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.made.name)
        report(ROOT / "cases/bits/generated.toml", cls.folder / "generated")
        report(ROOT / "cases/bits/bit-r.toml", cls.folder / "cones")
        report(ROOT / "cases/bits/bit-a.toml", cls.folder / "table")
        report(cls.folder / "table/bit.toml", cls.folder / "meshes")

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def page(self, name, titles, absent=()):
        done = draw(self.folder / name)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        page = (self.folder / name / "bit.html").read_text(encoding="utf-8")
        for title in [*OF_ALL, *titles]:
            if title != "In numbers":
                self.assertRegex(page, rf"<(h3|summary)>{re.escape(title)}</", title)
        for title in absent:
            self.assertNotRegex(page, rf"<(h3|summary)>{re.escape(title)}</", title)
        self.assertEqual(len(re.findall(IMAGE, page)), page.count("<img "))
        self.assertIsNone(re.search(r"(src|href)=.https?:", page), "the page fetches something")
        self.assertIsNone(re.search(r">\s*(nan|None|inf)\s*<", page))
        balance.check(page)
        return page

    def test_of_a_bit_from_a_design(self):
        page = self.page("generated", OF_CUTTERS, OF_CONES)
        self.assertIn("<td>215.900 mm</td>", page)
        self.assertIn("cutter-61", page)

    def test_the_numbers_have_the_planar_balance(self):
        page = self.page("table", OF_CUTTERS, OF_CONES)
        found = json.loads((self.folder / "table/analysis.json").read_text())["balance"]
        for key, words in (("planar", "imbalance of the planar model (Warren and Sinor 1986)"), ("normal_part", "its normal part"),
                           ("drag_part", "its drag part")):
            row = next(line for line in page.splitlines() if words in html.unescape(line))
            self.assertIn(f"{100 * found[f'{key}_over_weight']:.2f} % of the weight, towards", row)
        self.assertNotIn("planar_over_weight", page)

    def test_a_body_that_stands_proud_is_a_line(self):
        rows = dict(page_tables.body({"body": {"exposure_m": 8e-3, "slot_depth_m": 0.024, "junk_slot_area_m2": 0.01, "stands_proud_m": 0.5e-3}}))
        self.assertEqual(rows["blades stand proud of the cutters by"], "0.5 mm: they rub at any depth of cut")

    def test_of_a_cone_bit_and_twice_the_same_bytes(self):
        page = self.page("cones", OF_CONES, OF_CUTTERS)
        self.assertIn("cone-3", page)
        self.assertEqual(page, self.page("cones", OF_CONES, OF_CUTTERS))

    def test_of_a_bit_of_meshes(self):
        self.page("meshes", OF_CUTTERS, OF_CONES)

    def test_bad_folders_are_named_and_leave_no_page(self):
        table = self.folder / "table"
        cases = {"analysis.json": ["", "{", "[]", '{"name": "x"}'], "bit.vtp": [""], "profile.csv": ["", "r_m,z_m\na,b\n"]}
        for name, texts in cases.items():
            for k, text in enumerate(texts):
                bad = self.folder / f"bad-{name}-{k}"
                shutil.copytree(table, bad, ignore=shutil.ignore_patterns("parts", "bit.stl"))
                (bad / name).unlink() if not text and name != "profile.csv" else (bad / name).write_text(text)
                done = draw(bad)
                self.assertEqual(done.returncode, 2, (name, text, done))
                self.assertRegex(done.stderr, rf"^bit_page: .*{re.escape(name)}: ", (name, text))
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertEqual([p.name for p in bad.iterdir() if "html" in p.name], [])
        old = self.folder / "old"
        shutil.copytree(table, old, ignore=shutil.ignore_patterns("parts", "bit.stl"))
        analysis = json.loads((old / "analysis.json").read_text())
        del analysis["cutters"][3]["exposure_m"]
        (old / "analysis.json").write_text(json.dumps(analysis))
        done = draw(old)
        self.assertEqual(done.returncode, 2)
        self.assertIn("analysis.json: cannot be drawn: KeyError('exposure_m')", done.stderr)
        for missing in (self.folder / "nowhere", table / "bit.json"):
            done = draw(missing)
            self.assertEqual(done.returncode, 2)
            self.assertIn("found no folder, expected one that `tdbd bit", done.stderr)


class Charts(unittest.TestCase):
    """The charts show the output of the program."""

    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        report(ROOT / "cases/bits/bit-b.toml", pathlib.Path(cls.made.name) / "b")
        cls.bit = bit_data.read(pathlib.Path(cls.made.name) / "b")

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def test_pushes_head_to_tail_end_at_the_imbalance(self):
        _, pushes = bit_charts.forces(self.bit)
        found = pushes.sum(axis=0)
        np.testing.assert_allclose(found, self.bit.analysis["imbalance_vector_of_unit_law"][:2], atol=ROUNDING)
        self.assertAlmostEqual(np.hypot(*found), self.bit.analysis["imbalance_of_unit_law"], delta=ROUNDING)

    def test_frames_are_right_handed_and_tips_stand_below_their_faces(self):
        for c in self.bit.cutters:
            axes = np.array([c["x_axis"], c["y_axis"], c["z_axis"]])
            np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=ROUNDING)
            self.assertAlmostEqual(np.linalg.det(axes), 1.0, delta=ROUNDING)
            from_centre = axes @ (np.array(c["tip_m"]) - c["face_centre_m"])
            self.assertAlmostEqual(from_centre[2], -0.5 * c["diameter_m"], delta=ROUNDING)
            self.assertAlmostEqual(np.hypot(*c["tip_m"][:2]), c["tip_radius_m"], delta=ROUNDING)

    def test_update_directions_stand_in_the_plane_of_the_axis_and_the_place(self):
        for place, direction in bit_pictures.starts(self.bit):
            across = np.cross([0, 0, 1], [*place[:2], 0])
            self.assertAlmostEqual(np.dot(across, direction), 0.0, delta=ROUNDING)
            self.assertAlmostEqual(np.linalg.norm(direction), 1.0, delta=ROUNDING)
            self.assertGreaterEqual(np.dot(place[:2], direction[:2]), -ROUNDING)

    def test_mesh_and_parts_are_of_one_order(self):
        centres = {part["name"]: centre for part, centre in zip(self.bit.parts, self.bit.centres)}
        for c in self.bit.cutters:
            self.assertLess(np.linalg.norm(centres[f"{c['name']}/face"] - c["face_centre_m"]), 0.1 * c["diameter_m"])

    def test_the_body_stays_behind_the_tips(self):
        body = np.array(self.bit.analysis["body_profile_rz_m"])
        for c in self.bit.cutters:
            self.assertLess(np.interp(c["tip_radius_m"], body[:, 0], body[:, 1], right=-1.0), -c["tip_height_m"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
