"""quick_test.py TDBD ROOT: runs comparisons of single cutters twice, with bitwise identical results."""

import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

TDBD, ROOT = map(pathlib.Path, sys.argv[1:])
NAMES = ("cutter-small-to-large", "zijsling-pressures")


def validate(folder, *names):
    command = ["/usr/bin/python3", "-B", ROOT / "validation/validate.py", "-o", folder, "--program", TDBD, *names]
    return subprocess.run(command, capture_output=True, text=True)


def files():
    return sorted((ROOT / "validation").rglob("*"))


class Quick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.folder = pathlib.Path(made.name)
        cls.before = files()
        cls.done = validate(cls.folder, *NAMES)

    def test_verdicts_are_the_expected_ones(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)

    def test_size_effect_is_nearer_than_the_laws_of_the_area(self):
        with (self.folder / "comparisons.csv").open(newline="", encoding="utf-8") as file:
            rows = {(r["name"], r["law"], r["load"]): r for r in csv.DictReader(file)}
        error = lambda law: float(rows["cutter-small-to-large", law, "normal"]["mean_error"])
        self.assertGreater(error("detournay"), 0.2)
        self.assertAlmostEqual(error("hanson-hansen"), error("detournay"), delta=1e-3)
        self.assertLess(error("glowka"), 0.5 * error("detournay"))

    def test_program_finds_the_formula_that_made_the_records(self):
        with (self.folder / "comparisons.csv").open(newline="", encoding="utf-8") as file:
            errors = [float(r["rms_error"]) for r in csv.DictReader(file) if r["law"] == "thin-cut"]
        self.assertEqual(len(errors), 2)
        self.assertLess(max(errors), 0.003)
        self.assertTrue((self.folder / "pressures.png").read_bytes().startswith(b"\x89PNG"))

    def test_same_bytes_twice(self):
        kept = {f: f.read_bytes() for f in self.folder.glob("comparisons.*")}
        self.assertEqual(len(kept), 3)
        self.assertEqual(validate(self.folder, *NAMES).returncode, 0)
        for file, content in kept.items():
            self.assertEqual(file.read_bytes(), content, file.name)

    def test_source_tree_stays_clean(self):
        self.assertEqual(files(), self.before)

    def test_an_unknown_name_ends_with_2(self):
        done = validate(self.folder, "nothing")
        self.assertEqual(done.returncode, 2)
        self.assertIn("found no comparison 'nothing'", done.stderr)


class Tutorial(unittest.TestCase):
    def test_example_of_five_rows_works_as_it_stands(self):
        """In a folder of its own, with the bit beside it."""
        text = (ROOT / "docs/tutorials/calibrate.md").read_text(encoding="utf-8")
        block = lambda kind: re.search(f"```{kind}\n(.*?)```", text, re.DOTALL).group(1).replace("validation/bits/nov4.toml", "my-bit.toml")
        self.assertEqual(len(block("text").splitlines()), 7)  # a header, five readings, a row to predict
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "my-tests.csv").write_text(block("text"), encoding="utf-8")
            (folder / "my-fit.toml").write_text(block("toml"), encoding="utf-8")
            (folder / "my-bit.toml").write_bytes((ROOT / "validation/bits/nov4.toml").read_bytes())
            subprocess.run([TDBD, "calibrate", folder / "my-fit.toml", "-o", folder / "mine", "--quiet"], check=True,
                           capture_output=True)
            found = json.loads((folder / "mine/calibration.json").read_text(encoding="utf-8"))
            self.assertEqual(set(found["coefficients"]), {"A1", "A3", "A4"})
            self.assertLess(found["fitted_bit_error_wob_rms"], 0.1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
