"""chapter6_test.py TDBD ROOT: the counterparts of chapter 6 with coarse cut runs; the blind test is blind."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path[:0] = [str(ROOT / "validation/chapter6"), str(ROOT / "validation/blind")]
import blind  # noqa: E402
import lab_runs  # noqa: E402


class Chapter6(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name)
        subprocess.run([sys.executable, "-B", ROOT / "validation/chapter6/make.py", PROGRAM, cls.out, "--quick"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.items = json.loads((cls.out / "chapter6.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def rows(self, table):
        return lab_runs.read_rows(self.out / f"tables/{table}.csv")

    def test_makes_every_table_and_says_that_nothing_was_measured(self):
        wanted = {"table 6.1", "table 6.2", "table 6.3", "table 6.4", "table D.1", "table D.2"}
        self.assertEqual({i["counterpart"] for i in self.items} - {""}, wanted)
        for i in self.items:
            with self.subTest(i["name"]):
                text = (self.out / f"tables/{i['name']}.md").read_text()
                self.assertIn("Synthetic laboratory", i["caption"])
                self.assertIn(i["caption"], text)
                self.assertGreater(len(self.rows(i["name"])), 5)

    def test_compares_the_withheld_bit_beside_the_objectives(self):
        rows = self.rows("objectives")
        self.assertEqual(len(rows), 12)  # law, pairing, combined or separate
        for row in rows:
            self.assertGreater(row["withheld bit, WOB rms %"], 0.0)
            self.assertGreater(row["WOB objective"], 0.0)

    def test_extrapolates_in_the_pairings_of_appendix_d_alone(self):
        for row in self.rows("objectives"):
            self.assertEqual(row["extrapolates"], "no" if row["pairing"] == "B, C -> A" else "yes")

    def test_gives_the_calibration_no_reading_of_the_withheld_bit(self):
        files = sorted((self.out / "blind").glob("*/records.csv"))
        self.assertEqual(len(files), len(blind.LAWS) * len(lab_runs.PAIRINGS))
        for file in files:
            withheld = re.search(r"-([abc])-\d+$", file.parent.name)[1].upper()
            for row in lab_runs.read_rows(file):
                read = [row[load] != "" for load in blind.LOADS]
                self.assertEqual(read, [row["bit"] != withheld] * 2, file)

    def test_drills_the_withheld_bits_after_the_last_prediction(self):
        last = max(f.stat().st_mtime_ns for f in (self.out / "blind").glob("*/result/predictions.csv"))
        first = min(f.stat().st_mtime_ns for f in (self.out / "blind/truth").glob("*.csv"))
        self.assertLessEqual(last, first)

    def test_writes_nothing_into_the_source_tree(self):
        self.assertFalse(list((ROOT / "validation").rglob("cuts")))
        self.assertFalse(list((ROOT / "validation").rglob("cuts-*.nc")))

    def test_knows_records_that_differ(self):
        rows = lab_runs.read_rows(lab_runs.RECORDS)
        other = [dict(r) for r in rows]
        other[3]["wob"] *= 1.001
        self.assertFalse(lab_runs.differ(rows, [dict(r) for r in rows], 1e-6))
        self.assertTrue(lab_runs.differ(rows, other, 1e-6))
        self.assertTrue(lab_runs.differ(rows, rows[1:], 1e-6))

    def test_a_failure_of_the_program_is_told(self):
        done = subprocess.run([sys.executable, "-B", ROOT / "validation/chapter6/make.py", "/bin/false", self.out / "failed"],
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr.startswith("chapter6: exit code 1: tdbd laboratory")), (1, True), done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
