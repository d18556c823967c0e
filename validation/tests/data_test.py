"""data_test.py ROOT: the rows agree with the descriptions of their sources, and the records are made from them."""

import csv
import hashlib
import pathlib
import shutil
import sys
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(sys.argv[1]) / "validation"
sys.path.insert(0, str(ROOT))
import bit_rows  # noqa: E402
import cutter_rows  # noqa: E402
import records  # noqa: E402
import zijsling  # noqa: E402


def source(folder):
    return tomllib.loads((folder / "source.toml").read_text(encoding="utf-8"))


class Data(unittest.TestCase):
    def test_rows_are_unchanged(self):
        for folder in (ROOT / "data" / name for name in ("single-cutters", "full-bits")):
            with self.subTest(folder.name):
                described = source(folder)
                self.assertEqual(hashlib.sha256((folder / "rows.csv").read_bytes()).hexdigest(), described["sha256"])
                self.assertEqual(len(records.data_rows(folder.name)), described["rows"])

    def test_sources_say_whose_they_are_and_what_is_wrong_with_them(self):
        for folder in (ROOT / "data" / name for name in ("single-cutters", "full-bits")):
            with self.subTest(folder.name):
                described = source(folder)
                for key in ("title", "kind", "address", "author", "year", "licence", "what", "quality", "warnings"):
                    self.assertTrue(described[key], key)
                text = (folder / "LICENSE").read_text(encoding="utf-8")
                for line in described["licence"].split("MIT, ")[1].split("; text in")[0].split("; "):
                    self.assertIn(line + "\n", text)


class Records(unittest.TestCase):
    def test_are_what_the_data_give(self):
        self.assertEqual(records.stale(ROOT / "records"), [])

    def test_that_were_edited_or_are_missing_are_stale(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            shutil.copytree(ROOT / "records", folder, dirs_exist_ok=True)
            edited = folder / "full-bits.csv"
            edited.write_text(edited.read_text(encoding="utf-8").replace("2543.8", "2543.9"), encoding="utf-8")
            (folder / "floors.csv").unlink()
            self.assertEqual(records.stale(folder), ["full-bits.csv", "floors.csv"])

    def test_hold_no_row_twice(self):
        for file in ("single-cutters.csv", "full-bits.csv"):
            with (ROOT / "records" / file).open(newline="", encoding="utf-8") as text:
                rows = [tuple(row[2:]) for row in csv.reader(text)]
            self.assertEqual(len(rows), len(set(rows)), file)

    def test_leave_out_texas_granite_and_the_shallowest_turns(self):
        cutters = records.data_rows("single-cutters")
        self.assertEqual(len(cutter_rows.records(cutters)), sum("TX" not in r["case"] for r in cutters))
        kept = bit_rows.records(records.data_rows("full-bits"))
        self.assertTrue(0 < len(kept) < 153)

    def test_depth_of_cut_is_rate_over_speed(self):
        """10 ft/h at 100 rpm are 3048 mm in 6000 turns."""
        self.assertAlmostEqual(bit_rows.depth({"ROP_ft_hr": "10", "rpm": "100"}), 3.048 / 6000.0, delta=1e-15)


class Floors(unittest.TestCase):
    def test_of_a_factor_between_two_campaigns_is_that_factor(self):
        def row(year, rate, weight):
            return {"year": year, "n_blades": "4", "rpm": "80", "ROP_ft_hr": rate, "WOB_lbf": weight}
        rows = [row("2019", x, 100.0 * x) for x in (10.0, 20.0, 40.0)] + [row("2020", x, 110.0 * x) for x in (15.0, 30.0, 50.0)]
        ratios = bit_rows.ratios(rows, "4")
        self.assertEqual(len(ratios), 2)  # the third one is beyond the range of 2019
        for ratio in ratios:
            self.assertAlmostEqual(ratio, 0.1, delta=1e-12)

    def test_of_rows_on_a_power_law_is_none(self):
        rows = [{"doc_in": str(d), "Fn_lbf": str(7.0 * d ** 1.5)} for d in (0.02, 0.03, 0.05, 0.08)]
        self.assertLess(cutter_rows.about_own_curve(rows, "Fn_lbf"), 1e-12)


class Zijsling(unittest.TestCase):
    def test_formula_gives_the_published_range(self):
        """0 to 3 kN of drag for 10 mm by 0.15 and 0.30 mm up to 100 MPa; 1.35 times from 3000 to 6000 psi."""
        numbers = tomllib.loads((ROOT / "data/zijsling-1987/model.toml").read_text(encoding="utf-8"))["numbers"]
        drag = lambda pressure: zijsling.forces(numbers, pressure, 3.0)[1]
        self.assertAlmostEqual(drag(100.0), 3000.0, delta=15.0)
        self.assertAlmostEqual(drag(41.369) / drag(20.684), 1.35, delta=0.01)

    def test_groove_of_a_depth_has_its_area(self):
        self.assertAlmostEqual(zijsling.groove_area(zijsling.groove_depth(3.0, 0.35), 0.35), 3.0, delta=1e-12)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
