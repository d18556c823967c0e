"""studies_test.py ROOT: every study makes a table or a figure of its data; broken studies are named."""

import pathlib
import sys
import tempfile
import unittest

from small_project import Project

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "reports"))
import studies  # noqa: E402

PNG = b"\x89PNG\r\n\x1a\n"
MAKE = """
import pathlib, sys
data = (pathlib.Path(__file__).parent / "data.csv").read_text()
(pathlib.Path(sys.argv[1]) / "table.md").write_text(f"| n |\\n|---|\\n| {data} |\\n")
"""


class Shipped(unittest.TestCase):
    def test_every_study_makes_what_it_shows(self):
        found = studies.find(ROOT)
        self.assertTrue(found)
        with tempfile.TemporaryDirectory() as folder:
            made = studies.Studies(ROOT, folder)
            for study in found:
                with self.subTest(study.name):
                    self.assertTrue(made.update(study))
                    self.assertFalse(made.update(study))
                    self.assertTrue(study.title and study.text.strip(), "README.md explains nothing")
                    if table := made.table(study):
                        self.assertIn("<td", table)
                    if figure := made.figure(study):
                        self.assertTrue(figure.read_bytes().startswith(PNG))

    def test_making_writes_nothing_beside_the_data(self):
        files = lambda: sorted((ROOT / "reports/studies").rglob("*"))
        before = files()
        with tempfile.TemporaryDirectory() as folder:
            made = studies.Studies(ROOT, folder)
            for study in made.runs():
                made.update(study)
        self.assertEqual(files(), before)


class Made(unittest.TestCase):
    """A project with one study: made once, again when it changed, an error when it is broken."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name)
        self.write("README.md", "# Why <n>\n\nBecause `n`.\n\n## How\n\n    tdbd run\n")
        self.write("make.py", MAKE)
        self.write("data.csv", "17")

    def write(self, file, text):
        return self.project.write(f"reports/studies/why/{file}", text)

    def make(self, *words, arguments=()):
        return "made why (" in self.project.make_or_complain(self, words, arguments)

    def test_is_made_once_and_shown(self):
        self.assertTrue(self.make())
        self.assertFalse(self.make())
        page = (self.project.out / "index.html").read_text(encoding="utf-8")
        section = page[page.index('<section id="study-why">'):].split("</section>")[0]
        for words in ("<h3>Why &lt;n&gt;</h3>", "<p>Because <code>n</code>.</p>", "<h4>How</h4>", "<pre><code>tdbd run\n</code></pre>",
                      "<td>17</td>"):
            self.assertIn(words, section)

    def test_is_made_again_when_its_data_changed(self):
        self.make()
        self.write("data.csv", "18")
        self.make("study why: its table or figure is missing, or its files changed", arguments=("--check",))
        self.assertTrue(self.make())
        self.assertIn("<td>18</td>", (self.project.out / "index.html").read_text(encoding="utf-8"))
        self.make(arguments=("--check",))

    def test_is_made_again_when_its_table_went(self):
        self.make()
        (self.project.out / "studies/why/table.md").unlink()
        self.make("study why", arguments=("--check",))
        self.assertTrue(self.make())

    def test_that_is_broken_leaves_no_report(self):
        self.write("make.py", "raise SystemExit('no column n')\n")
        self.make("study why: make.py failed with exit code 1", "no column n")
        self.assertFalse((self.project.out / "index.html").exists())
        self.write("make.py", "pass\n")
        self.make("study why: make.py wrote neither table.md nor figure.png")
        self.write("make.py", MAKE)
        self.write("README.md", "Because.\n")
        self.make("study why: README.md begins with 'Because.', expected \"# TITLE\"")
        (self.project.root / "reports/studies/why/README.md").unlink()
        self.make("README.md is missing")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
