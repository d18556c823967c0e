"""studies_test.py ROOT: every study makes a table or a figure of its data; broken studies are named."""

import pathlib
import shutil
import sys
import tempfile
import unittest

from small_project import Project

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "reports"))
import studies  # noqa: E402
import study  # noqa: E402
import study_runs  # noqa: E402

PNG = b"\x89PNG\r\n\x1a\n"
MAKE = """
[[tables]]
file = "data.csv"
"""


class Shipped(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.made, cls.before = studies.Studies(ROOT, folder.name), cls.files()
        cls.was_stale = {study.name: cls.made.update(study) for study in cls.made.runs()}

    @staticmethod
    def files():
        return sorted((ROOT / "reports/studies").rglob("*"))

    def test_every_study_makes_what_it_shows(self):
        self.assertTrue(self.was_stale)
        for study in self.made.runs():
            with self.subTest(study.name):
                self.assertTrue(self.was_stale[study.name])
                self.assertFalse(self.made.update(study))
                self.assertTrue(study.title and study.text.strip(), "README.md explains nothing")
                if table := self.made.table(study):
                    self.assertIn("<td", table)
                if figure := self.made.figure(study):
                    self.assertTrue(figure.read_bytes().startswith(PNG))

    def test_making_writes_nothing_beside_the_data(self):
        self.assertEqual(self.files(), self.before)


class Made(unittest.TestCase):
    """A project with one study: made once, again when it changed, an error when it is broken."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name)
        self.write("README.md", "# Why <n>\n\nBecause `n`.\n\n## How\n\n    tdbd run\n")
        self.write("study.toml", MAKE)
        self.write("data.csv", "n\n17\n")

    def write(self, file, text):
        return self.project.write(f"reports/studies/why/{file}", text)

    def page(self, name="why"):
        return (self.project.out / f"studies/{name}.html").read_text(encoding="utf-8")

    def make(self, *words, arguments=()):
        return "made why (" in self.project.make_or_complain(self, words, arguments)

    def test_is_made_once_and_shown(self):
        self.assertTrue(self.make())
        self.assertFalse(self.make())
        section = self.page()
        for words in ("<h1>Why &lt;n&gt;</h1>", "<p>Because <code>n</code>.</p>", "<h2>How</h2>", "<pre><code>tdbd run\n</code></pre>",
                      "<td>17</td>", '<a href="../index.html#studies">'):
            self.assertIn(words, section)
        self.assertIn('<a href="studies/why.html">Why &lt;n&gt;</a>', (self.project.out / "index.html").read_text(encoding="utf-8"))

    def test_its_page_is_made_again_when_it_went_and_removed_with_the_study(self):
        self.make()
        (self.project.out / "studies/why.html").unlink()
        self.make("studies/why.html: has not been made", arguments=("--check",))
        self.make()
        shutil.copytree(self.project.root / "reports/studies/why", self.project.root / "reports/studies/how")
        self.make()
        self.assertTrue((self.project.out / "studies/how.html").is_file())
        shutil.rmtree(self.project.root / "reports/studies/how")
        self.make()
        self.assertFalse((self.project.out / "studies/how.html").exists())

    def test_links_to_studies_and_files_of_the_project_and_to_nothing_else(self):
        self.project.write("reports/studies/how/README.md", "# How\n\nSee [why](../why/README.md) and [the case](../../../cases/one.toml).\n")
        self.project.write("reports/studies/how/study.toml", MAKE)
        self.project.write("reports/studies/how/data.csv", "n\n17\n")
        self.make()
        self.assertIn('See <a href="why.html">why</a> and the case (<code>cases/one.toml</code>).', self.page("how"))
        self.write("README.md", "# Why\n\nSee [how](../hwo/README.md) and [below](#below).\n")
        self.make("studies/why.html: found a link to ../hwo/README.md, expected a file of the report",
                  "studies/why.html: found a link to #below, expected an element with the id below on studies/why.html")
        self.assertFalse((self.project.out / "index.html").exists())

    def test_is_made_again_when_its_data_changed(self):
        self.make()
        self.write("data.csv", "n\n18\n")
        self.make("study why: its table or figure is missing, or its files changed", arguments=("--check",))
        self.assertTrue(self.make())
        self.assertIn("<td>18</td>", self.page())
        self.make(arguments=("--check",))

    def test_is_made_again_when_its_table_went(self):
        self.make()
        (self.project.out / "studies/why/table.md").unlink()
        self.make("study why", arguments=("--check",))
        self.assertTrue(self.make())

    def test_that_is_broken_leaves_no_report(self):
        self.write("study.py", "raise SystemExit('no column n')\n")
        self.make("study why: making failed with exit code 1", "no column n")
        self.assertFalse((self.project.out / "index.html").exists())
        self.write("study.py", "")
        self.write("study.toml", "")
        self.make("study why: made neither table.md nor figure.png")
        self.write("study.toml", '[[tables]]\nrows = "data"\ncolumns = [["m", "r[\'m\']"]]\n')
        self.make("study why: \"r['m']\" failed: KeyError: 'm'")
        self.write("study.toml", "[figures]\n")
        self.make("study.toml: found figures, expected figure, let, measure, stated, tables")
        self.write("study.toml", MAKE)
        self.write("README.md", "Because.\n")
        self.make("study why: README.md begins with 'Because.', expected \"# TITLE\"")
        (self.project.root / "reports/studies/why/README.md").unlink()
        self.make("README.md is missing")


MEASURED = """
[[measure.runs]]
file = "speeds.csv"
case = "/dev/null"
set = {"rock.wall" = "2 mm"}
grid = [["edge, mm", "rock.edge_length", [2, 1], "mm"], ["step, ms", "time.step", [0.5]]]
columns = [["speed, mm/s", "1e3 * s['speed']", ".1f"]]

[[measure.printed]]
file = "forces.csv"
program = "verify"
tests = "Snail.*"
pattern = "force {n} N, (\\\\w+)"
columns = [["force, N", ".2f"], ["verdict", ""]]
"""
TDBD = """#!/bin/sh
echo "$@" >> "$(dirname "$0")/calls"
mkdir -p "$4" && echo '{"speed": 0.0125}' > "$4/summary.json"
"""


class Measured(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for file, text in {"study.toml": MEASURED, "tdbd": TDBD, "verification/verify": "#!/bin/sh\necho force 1.5 N, holds\necho force -2 N, fails\n"}.items():
            path = self.root / file
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
            path.chmod(0o755)

    def text(self, file):
        return (self.root / file).read_text(encoding="utf-8")

    def test_writes_a_row_for_each_run_and_each_line_that_tests_print(self):
        study_runs.measure(study.load(self.root), self.root)
        self.assertEqual(self.text("speeds.csv"), '"edge, mm","step, ms","speed, mm/s"\n2,0.5,12.5\n1,0.5,12.5\n')
        self.assertEqual(self.text("forces.csv"), '"force, N",verdict\n1.50,holds\n-2.00,fails\n')
        self.assertIn('--set rock.wall="2 mm" --set rock.edge_length="1 mm" --set time.step=0.5', self.text("calls"))

    def test_keeps_runs_and_measures_parts(self):
        for _ in range(2):
            study_runs.measure(study.load(self.root), self.root, self.root / "kept", ["speeds.csv"])
        self.assertEqual(len(self.text("calls").splitlines()), 2)
        self.assertFalse((self.root / "forces.csv").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
