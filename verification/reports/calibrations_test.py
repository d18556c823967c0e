"""calibrations_test.py ROOT: what validation/ makes is shown, made once, made again when it changed, and no report without it."""

import pathlib
import sys
import unittest
import tempfile

from small_project import INDEX, PROGRAM, Project

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "reports"))
from calibrations import CHAPTER_6, MEASURED  # noqa: E402

CHAPTER = """
import json, pathlib, sys
from matplotlib.figure import Figure
own, out = pathlib.Path(__file__).parent, pathlib.Path(sys.argv[2])
for folder in ("tables", "figures"):
    (out / folder).mkdir(parents=True, exist_ok=True)
n = (own.parent / "cases/lab-bc-a.toml").read_text()
(out / "tables/starts.md").write_text(f"## Starts\\n\\nA caption.\\n\\n| n |\\n|---|\\n| {n} |\\n")
Figure(figsize=(2, 2)).savefig(out / "figures/fit.png", dpi=200)
items = [("table", "starts", "table 6.1"), ("figure", "fit", "figure 6.3")]
(out / "chapter6.json").write_text(json.dumps(
    [{"kind": k, "name": n, "counterpart": c, "title": f"The <{n}>", "caption": "Synthetic laboratory."} for k, n, c in items]))
"""
COMPARE = """
import pathlib, sys
out = pathlib.Path(sys.argv[sys.argv.index("-o") + 1])
(out / "comparisons.md").write_text("## One\\n\\nmeasured\\n\\n| law |\\n|---|\\n| glowka |\\n")
"""


class Made(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name)
        self.project.write("validation/chapter6/make.py", CHAPTER)
        self.project.write("validation/validate.py", COMPARE)
        self.project.write("validation/cases/lab-bc-a.toml", "17")

    def make(self, *words, arguments=()):
        """The names of what was made; complaints contain these words."""
        made = self.project.make_or_complain(self, words, arguments)
        return [name for name in ("chapter6", "measured") if f"made {name} (" in made]

    def page(self, folder=None):
        return ((folder or self.project.out) / "index.html").read_text(encoding="utf-8")

    def section(self, place):
        return self.page().split(f'<section id="calibration-{place}">')[1].split("</section>")[0]

    def test_is_made_once_and_shown(self):
        self.assertEqual(self.make(), ["chapter6", "measured"])
        self.assertEqual(self.make(), [])
        self.assertEqual(self.make(arguments=("--check",)), [])
        table, figure = self.section("chapter6-table-starts"), self.section("chapter6-figure-fit")
        for words in ("Counterpart of table 6.1: The &lt;starts&gt;", "<p>Synthetic laboratory.</p>", "<td>17</td>"):
            self.assertIn(words, table)
        self.assertNotIn("A caption", table)  # the page has its own
        self.assertIn("Counterpart of figure 6.3", figure)
        self.assertIn('src="data:image/png;base64,', figure)
        self.assertIn("<td>glowka</td>", self.section("measured-table-comparisons"))

    def test_is_made_again_when_a_case_a_bit_or_the_program_changed(self):
        self.make()
        for file, text in (("validation/cases/lab-bc-a.toml", "18"), ("cases/bits/bit-a.toml", "[bit]\n"),
                           ("build/release/tdbd", PROGRAM + "# another\n")):
            with self.subTest(file):
                self.project.write(file, text)
                if file.startswith("validation"):
                    self.make("chapter6: the program, a case, a record or a script changed", arguments=("--check",))
                self.assertIn("chapter6", self.make())
                self.assertEqual(self.make(), [])
        self.assertIn("<td>18</td>", self.section("chapter6-table-starts"))

    def test_that_fails_leaves_no_report(self):
        self.project.write("validation/validate.py", "raise SystemExit('validate: a verdict is another')\n")
        self.make("measured: exit code 1", "a verdict is another")
        self.assertFalse((self.project.out / "index.html").exists())

    def test_the_list_of_the_thesis_names_only_what_was_made(self):
        index = INDEX + '[[entries]]\nnumber = "figure 6.1"\ntitle = "Fit"\nknown = "title"\ninstead = "ours"\ncounterpart = ["chapter6 fit"]\n'
        self.project.write("reports/thesis_index.toml", index)
        self.make()
        self.assertIn('<a href="#calibration-chapter6">fit</a>', self.page().split('id="thesis-index"')[1])
        self.project.write("reports/thesis_index.toml", index.replace("chapter6 fit", "chapter6 other"))
        for arguments in ((), ("--check",)):
            self.make("thesis_index.toml: figure 6.1: there is no counterpart chapter6 other", arguments=arguments)

    def test_finds_every_file_behind_a_set(self):
        for made, file in ((CHAPTER_6, "blind/blind.py"), (CHAPTER_6, "chapter6/records.csv"), (CHAPTER_6, "cases/lab-bc-a.toml"),
                           (CHAPTER_6, "cases/laboratory.toml"), (MEASURED, "split.toml"), (MEASURED, "records/single-cutters.csv")):
            with self.subTest(file):
                found = {f for pattern in made.own for f in (ROOT / "validation").glob(pattern)}
                self.assertIn(ROOT / "validation" / file, found)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
