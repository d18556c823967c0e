"""`scripts/report --check` names each thing that is wrong with its file, and ends with exit code 1."""

import json
import pathlib
import subprocess
import tempfile
import unittest

from small_project import EVIDENCE, MANIFEST, Project

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/report"
PAGE = "docs/evidence/accuracy.md"
TABLE = """# Small
<!-- measured: scripts/report --readme writes what follows -->
<!-- end of measured -->
"""
ROWS = '\nROWS = [Row("order", "{:.2f}", (Measured("chapter5/order", "attitude"),), "test `Order.is_two`")]\n'


class Check(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.made.cleanup)
        project = Project(cls.made.name)
        project.write("scripts/report", SCRIPT.read_text(encoding="utf-8"))
        project.write(PAGE, TABLE)
        rows = project.root / "reports/readme_rows.py"
        rows.write_text(rows.read_text(encoding="utf-8") + ROWS, encoding="utf-8")
        subprocess.run(["/usr/bin/python3", "-B", project.root / "reports/readme.py", "--write"], check=True)
        code, _, complaints = project.make()
        assert code == 0, complaints

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name, copy_of=self.made.name)

    def assert_named(self, file, *words):
        """One complaint in all, of this file; exit code 1; nothing was built, run or drawn."""
        before = {f: f.stat().st_mtime_ns for f in self.project.root.rglob("*")}
        done = subprocess.run(["bash", "scripts/report", "--check"], cwd=self.project.root, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        [line] = done.stderr.splitlines()
        for word in (file, *words):
            self.assertIn(word, line)
        self.assertEqual({f: f.stat().st_mtime_ns for f in self.project.root.rglob("*")}, before)

    def test_has_nothing_to_say_of_a_report_that_is_current(self):
        done = subprocess.run(["bash", "scripts/report", "--check"], cwd=self.project.root, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_names_a_stale_figure(self):
        self.project.age("results/report/figures/first.png", 60)
        self.assert_named("results/report/figures/first.png", "older than its data")

    def test_names_a_limit_that_is_too_wide(self):
        self.project.measure(EVIDENCE | {"limit": "2 +- 0.05"})
        (self.project.out / "index.html").touch()  # newer than the evidence: its width alone is wrong
        self.assert_named("chapter5/order", "Order.is_two has the limit '2 +- 0.05'", "say why")

    def test_names_a_claim_of_no_chapter(self):
        claims = self.project.root / "reports/claims.toml"
        claims.write_text(claims.read_text(encoding="utf-8").replace("chapter5/order", "chapter9/order"), encoding="utf-8")
        manifest = self.project.root / "reports/manifest.toml"
        manifest.write_text(MANIFEST.replace("chapter5/order", "chapter9/order"), encoding="utf-8")
        self.assert_named("reports/claims.toml", "an orphan", "no chapter for chapter9/order")

    def test_names_a_number_of_no_row(self):
        file = self.project.root / "reports/readme.json"
        file.write_text(json.dumps(json.loads(file.read_text(encoding="utf-8")) | {"gone": 1.0}), encoding="utf-8")
        self.assert_named("reports/readme.json", "unused number", "'gone'")

    def test_names_a_figure_of_no_number_of_the_thesis(self):
        self.project.write("reports/manifest.toml", MANIFEST.replace('"5.2"', '"5.2, 5.9"'))
        self.assert_named("reports/thesis_index.toml", "figure 5.9", "first")

    def test_names_a_line_of_the_table_that_was_edited(self):
        file = self.project.root / PAGE
        file.write_text(file.read_text(encoding="utf-8").replace("2.00", "2.01"), encoding="utf-8")
        self.assert_named(f"{PAGE}, line 5", "2.01")

    def test_names_a_number_in_prose_that_comes_from_nowhere(self):
        self.project.write("benchmarks/README.md", "# A snail\n\nIt does 3.5 mm/s.\n")
        self.assert_named("benchmarks/README.md", "1 numbers and no [stated]")


if __name__ == "__main__":
    unittest.main()
