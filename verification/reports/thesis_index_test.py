"""thesis_index_test.py ROOT: the list of the thesis's figures and tables is whole, and agrees with what the report draws."""

import json
import pathlib
import re
import sys
import tempfile
import unittest

from small_project import INDEX, MANIFEST, Project

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "reports"))
import manifest as manifests  # noqa: E402
import page  # noqa: E402
import thesis_index  # noqa: E402

# The last number of every chapter, from the thesis's lists of figures and of tables.
FIGURES = {"1": 3, "2": 1, "3": 10, "4": 39, "5": 5, "6": 7, "A": 1, "B": 22, "D": 4}
TABLES = {"5": 2, "6": 4, "A": 3, "D": 2}


class Shipped(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = manifests.read(ROOT / "reports")
        cls.entries = thesis_index.read(ROOT, cls.whole)

    def test_has_every_number_of_the_thesis_once(self):
        wanted = [f"{kind} {chapter}.{k}" for kind, lasts in (("figure", FIGURES), ("table", TABLES))
                  for chapter, last in lasts.items() for k in range(1, last + 1)]
        self.assertEqual(sorted(e.number for e in self.entries), sorted(wanted))
        self.assertEqual((sum(FIGURES.values()), sum(TABLES.values())), (92, 11))

    def test_marks_as_reconstructed_what_rests_on_a_title(self):
        """Not what our copy describes elsewhere, nor what is wholly of our own program."""
        drawn = thesis_index.in_manifest(self.whole)
        figures = {f.name: f for f in self.whole.figures}
        for e in self.entries:
            for name in drawn.get(e.number, []) if e.known == "title" and not e.instead else []:
                self.assertTrue(figures[name].reconstructed, f"{e.number}: {name} does not say what of it is reconstructed")

    def test_chapter_6_makes_its_counterparts(self):
        sources = "".join((ROOT / "validation/chapter6" / f).read_text(encoding="utf-8") for f in ("lab_figures.py", "lab_tables.py"))
        made = {}
        for name, number in re.findall(r'"([a-z0-9-]+)",\s*"((?:figure|table) [0-9A-D.]+)"', sources):
            made[number] = name
        listed = {e.number: name for e in self.entries for kind, name in e.counterpart if kind == "chapter6"}
        self.assertEqual(listed, made)


class Refused(unittest.TestCase):
    """A wrong index or manifest is refused, with the file, the number and what was expected."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name)

    def assert_refused(self, *words, index=INDEX, manifest=MANIFEST):
        self.project.write("reports/thesis_index.toml", index)
        self.project.write("reports/manifest.toml", manifest)
        for arguments in ((), ("--check",), ("--quick",)):
            code, _, complaints = self.project.make(*arguments)
            self.assertEqual(code, 1, complaints)
            for word in ("reports/thesis_index.toml", *words):
                self.assertIn(word, complaints)
            self.assertNotIn("Traceback", complaints)

    def test_a_number_of_the_manifest_that_the_thesis_has_not(self):
        self.assert_refused("figure 5.3: manifest.toml draws it (first)", manifest=MANIFEST.replace('"5.2"', '"5.1 to 5.3"'))
        self.assert_refused("table 5.2: manifest.toml draws it", "figure 5.2: found nothing",
                            manifest=MANIFEST.replace('thesis = "5.2"', 'thesis = "5.2"\nform = "table"'))

    def test_an_entry_with_nothing_in_its_place(self):
        self.assert_refused("figure 5.1: found nothing, expected one", index=INDEX.replace('why = "A photograph."', ""))

    def test_a_counterpart_that_does_not_exist(self):
        for counterpart in ("figure second", "study none", "claim chapter5/none", "picture first", "figure"):
            self.assert_refused(f"figure 5.1: there is no counterpart {counterpart}",
                                index=INDEX.replace('why = "A photograph."', f'counterpart = ["{counterpart}"]\ninstead = "other"'))

    def test_a_gap_and_a_number_twice(self):
        self.assert_refused("figure 5.3: expected figure 5.2 here", index=INDEX.replace("5.2", "5.3"))
        self.assert_refused("figure 5.1: expected figure 5.2 here", index=INDEX.replace("5.2", "5.1"))


class Shown(unittest.TestCase):
    """The last list of the page states where each is shown."""

    def rows(self, manifest=MANIFEST, index=INDEX, arguments=()):
        with tempfile.TemporaryDirectory() as folder:
            project = Project(folder)
            project.write("reports/manifest.toml", manifest)
            project.write("reports/thesis_index.toml", index)
            code, _, complaints = project.make(*arguments)
            self.assertEqual((code, complaints), (0, ""))
            page = (project.build / "report-quick" if arguments else project.out) / "index.html"
            text = page.read_text(encoding="utf-8").split('id="thesis-index"')[1].split("</table>")[0]
            return text, re.findall(r"<tr><td>.*?</tr>", text, re.DOTALL)

    def test_what_is_drawn_and_what_is_not(self):
        text, [first, second] = self.rows()
        self.assertIn("2 figures: 1 regenerated, 0 counterpart, 1 not made", text)
        self.assertTrue("not made" in first and "A photograph." in first and "A &lt;line&gt;" in first, first)
        self.assertTrue(">regenerated<" in second and '<a href="#figure-first">first</a>' in second, second)

    def test_a_counterpart_by_number_and_by_name(self):
        named = INDEX.replace('why = "A photograph."', 'counterpart = ["claim chapter5/order"]\ninstead = "A number instead."')
        _, [first, second] = self.rows(index=named + 'instead = "Ours."\n')
        self.assertTrue(">counterpart<" in first and '<a href="#claim-chapter5/order">' in first and "A number instead." in first, first)
        self.assertTrue(">counterpart<" in second and '<a href="#figure-first">' in second and "Ours." in second, second)


class Contents(unittest.TestCase):
    """The page's table of contents."""

    def test_every_figure_and_claim_appears_once_in_the_report(self):
        whole = manifests.read(ROOT / "reports")
        chapters = page.chapters(whole)
        self.assertEqual(sorted(f.name for c in chapters for f in c.figures), sorted(f.name for f in whole.figures))
        self.assertEqual(sorted(c.slug for h in chapters for c in h.claims), sorted(c.slug for c in whole.claims))


class Forms(unittest.TestCase):
    """A table and a line drawing of the manifest are on the page and bitwise reproducible."""

    def made(self, form, script):
        with tempfile.TemporaryDirectory() as folder:
            project = Project(folder)
            project.write("reports/manifest.toml", MANIFEST.replace('thesis = "5.2"', f'thesis = ""\nform = "{form}"\nsources = ["cases/*.toml"]'))
            project.write("reports/thesis_index.toml", INDEX + 'why = "lost"\n')
            project.write("reports/figures/first.py", script)
            self.assertEqual(project.make()[2], "")
            [picture] = [f for f in (project.out / "figures").iterdir() if f.name.startswith("first.") and "made" not in f.name]
            first = picture.read_bytes()
            project.write("cases/two.toml", "")
            code, _, complaints = project.make("--check")
            self.assertTrue(code == 1 and "first" in complaints, complaints)  # a source came
            self.assertEqual(project.make()[2], "")
            return picture.name, first, picture.read_bytes(), (project.out / "index.html").read_text(encoding="utf-8")

    def test_a_table(self):
        name, first, _, page = self.made("table", 'def table(inputs):\n    return {"heads": ["file", "<n>"], "rows": [[f, len(t)] for f, t in inputs.texts().items()]}\n')
        self.assertEqual((name, json.loads(first)["heads"]), ("first.json", ["file", "<n>"]))
        self.assertTrue("<th>&lt;n&gt;</th>" in page and "<td>cases/two.toml</td><td>0</td>" in page)

    def test_a_line_drawing(self):
        script = "from matplotlib.figure import Figure\ndef draw(inputs):\n    f = Figure(figsize=(3, 2))\n    f.subplots().plot([0, 1], [1, 0])\n    return f\n"
        name, first, second, page = self.made("svg", script)
        self.assertEqual((name, first), ("first.svg", second))
        self.assertIn(b"<svg", first)
        self.assertRegex(page, r'<img alt="First" aria-describedby="shows-first" width="384" src="data:image/svg\+xml;base64,')


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
