"""stated_test.py ROOT: every number in the prose of studies comes from data or was chosen; one that was edited is named."""

import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "reports"))
import stated  # noqa: E402

TEXT = """# Does a snail keep its speed?

    snail --legs 8

Measured 2026-11-23, thesis 4.1.2, figs. 4.7 and 4.9, rock (12), `rk8`, 2^16 places; on edges of 2 mm. Its speed is 1.2 mm/s
over all days, within
7 % of what it was, and its defect 2e-7.
"""
MODULE = '''
[stated]
given = ["edges of 2 mm"]
numbers = [
    ["Its speed is {:.1f} mm/s over all days, within {:.0f} % of", "[1.24, 7.2]"],
    ["its defect {:.0e}", "2.1e-7"],
]
'''


class Shipped(unittest.TestCase):
    def test_all_numbers_come_from_somewhere(self):
        self.assertEqual(stated.problems(ROOT), [])
        self.assertGreater(len(stated.find(ROOT)[0]), 20)


class Made(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.study = self.root / "reports/studies/snail"
        self.study.mkdir(parents=True)
        self.readme = self.study / "README.md"
        self.write(TEXT, MODULE)

    def write(self, text, module=None):
        self.readme.write_text(text, encoding="utf-8")
        if module is not None:
            (self.study / "study.toml").write_text(module, encoding="utf-8")

    def problem(self):
        [problem] = stated.problems(self.root)
        return problem

    def test_what_the_data_say_is_right(self):
        self.assertEqual(stated.problems(self.root), [])

    def test_an_edited_number_is_named_with_its_line_and_rewritten(self):
        self.write(TEXT.replace("7 % of", "6 % of"))
        self.assertRegex(self.problem(), r"studies/snail/README.md, line 7: found 6 in .*, the data give 7; run scripts/report --readme")
        self.assertEqual(stated.write(self.root), [])
        self.assertEqual(self.readme.read_text(encoding="utf-8"), TEXT)

    def test_a_number_from_nowhere_is_named(self):
        self.write(TEXT + "\nIt weighs 12.5 g.\n")
        self.assertIn("line 9: 12.5 has no source", self.problem())

    def test_a_study_without_stated_numbers_is_named(self):
        (self.study / "study.toml").unlink()
        self.assertIn("4 numbers and no [stated]", self.problem())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
