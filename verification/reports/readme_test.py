"""readme_test.py ROOT: docs/evidence/accuracy.md contains the measurements of tests and studies; a line that was edited is reported."""

import pathlib
import sys
import tempfile
import types
import unittest

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "reports"))
import readme  # noqa: E402
from readme_rows import ROWS, Kept, Measured, Row  # noqa: E402


class Shipped(unittest.TestCase):
    def test_states_what_was_measured(self):
        self.assertTrue(readme.has_block(ROOT))
        self.assertEqual(readme.problems(ROOT), [])

    def test_rows_name_tests_that_exist(self):
        sources = "".join(f.read_text(encoding="utf-8") for f in (ROOT / "verification").rglob("*_test.cpp"))
        for row in ROWS:
            if row.by.startswith("test `"):
                suite, test = row.by.removeprefix("test `").rstrip("`").split(".")
                self.assertRegex(sources, rf"TEST\w*\({suite}, {test}\b|TEST_F\({suite}, {test}\b")


def evidence_of(measured):
    return {"ours/speed": [types.SimpleNamespace(what="speed of a snail", measured=measured),
                           types.SimpleNamespace(what="speed of a slow snail", measured=0.5 * measured)]}


class Made(unittest.TestCase):
    """A page with two rows: of a test, and of a study."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "reports").mkdir()
        self.study = self.root / "study"
        self.study.write_text("7", encoding="utf-8")
        self.rows = (Row("speed", "{:.1f} mm/s", (Measured("ours/speed", "snail", 1e3),), "test `A.b`"),
                     Row("legs", "{:.0f}", (Kept("study", "legs", lambda file: int(file.read_text(encoding="utf-8"))),), "study"))
        self.page = self.root / readme.PAGE
        self.page.parent.mkdir(parents=True)
        self.page.write_text(f"# Title\n{readme.BEGIN}\n{readme.END}\nEnd.\n", encoding="utf-8")

    def write(self, measured=1.25e-3):
        numbers = readme.measure(self.root, evidence_of(measured), self.rows)
        readme.write(self.root, numbers, self.rows)
        return numbers

    def test_has_the_largest_of_what_was_measured(self):
        self.write()
        self.assertEqual(self.page.read_text(encoding="utf-8").split("\n")[4:6], ["| speed | 1.2 mm/s | test `A.b` |", "| legs | 7 | study |"])
        self.assertTrue(self.page.read_text(encoding="utf-8").endswith("\nEnd.\n"))

    def test_an_edited_line_is_named(self):
        numbers = self.write()
        self.page.write_text(self.page.read_text(encoding="utf-8").replace("1.2 mm/s", "1.0 mm/s"), encoding="utf-8")
        [problem] = readme.edited_lines(self.root, numbers, self.rows)
        self.assertIn(f"{readme.PAGE}, line 5: found '| speed | 1.0 mm/s", problem)
        self.assertIn("scripts/report --readme", problem)

    def test_what_is_measured_otherwise_now_is_stale(self):
        numbers = self.write()
        self.assertEqual(readme.stale_numbers(self.root, numbers, evidence_of(1.249e-3), self.rows), [])
        [problem] = readme.stale_numbers(self.root, numbers, evidence_of(1.5e-3), self.rows)
        self.assertIn("1.5 mm/s", problem)
        self.study.write_text("8", encoding="utf-8")
        [problem] = readme.stale_numbers(self.root, numbers, None, self.rows)
        self.assertIn("legs", problem)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
