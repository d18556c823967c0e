"""What changed is made again, what did not is left alone, what is stale is an error."""

import tempfile
import unittest

from small_project import CLAIMS, EVIDENCE, FIGURE, MANIFEST, PROGRAM, Project


class OfOneProject(unittest.TestCase):
    """Each test has a copy of a project that was made once."""

    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.made = made.name
        cls.make_first(Project(cls.made))

    @classmethod
    def make_first(cls, project):
        code, _, complaints = project.make()
        assert (code, complaints) == (0, ""), complaints

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name, copy_of=self.made)


class Report(OfOneProject):
    def assert_made(self):
        code, _, complaints = self.project.make()
        self.assertEqual((code, complaints), (0, ""))

    def assert_stale(self, *words, arguments=("--check",)):
        self.assertTrue(words)
        self.project.make_or_complain(self, words, arguments)

    def picture_time(self):
        return (self.project.out / "figures/first.png").stat().st_mtime_ns

    def assert_remade(self, runs, drawn):
        """So many further runs, and whether the figure was drawn again."""
        calls, picture = len(self.project.calls()), self.picture_time()
        self.assert_made()
        self.assertEqual(len(self.project.calls()) - calls, runs)
        self.assertEqual(self.picture_time() != picture, drawn)
        self.assertEqual(self.project.make("--check"), (0, "", ""))

    def test_nothing_changed_nothing_is_made(self):
        self.assertEqual(len(self.project.calls()), 1)
        self.assertIn("rotate cases/one.toml --set time.step=0.1 s -o", self.project.calls()[0])
        self.assert_remade(runs=0, drawn=False)

    def test_a_changed_case(self):
        self.project.write("cases/one.toml", "[time]\nstep = 2.0\n")
        self.assert_stale("one: the result does not match the manifest")
        self.assert_remade(runs=1, drawn=True)

    def test_a_file_that_the_case_names(self):
        self.project.write("cases/one.toml", 'mesh = "body.stl"\n')
        self.project.write("cases/body.stl", "one")
        self.assert_remade(runs=1, drawn=True)
        self.project.write("cases/body.stl", "two")
        self.assert_stale("one: the result does not match")
        self.assert_remade(runs=1, drawn=True)

    def test_a_changed_program(self):
        self.project.write("build/release/tdbd", PROGRAM + "# another\n")
        self.assert_stale("one: the result does not match")
        self.assert_remade(runs=1, drawn=True)

    def test_objects_stand_for_the_program_and_the_commit_does_not(self):
        self.project.write("build/release/src/a.cpp.o", "machine code")
        self.assert_remade(runs=1, drawn=True)
        self.project.write("build/release/tdbd", PROGRAM + "# linked again\n")
        self.project.write("build/release/src/provenance.cpp.o", "commit 1")
        self.assert_remade(runs=0, drawn=False)
        self.project.write("build/release/src/a.cpp.o", "other machine code")
        self.assert_stale("one: the result does not match")
        self.assert_remade(runs=1, drawn=True)

    def test_a_result_changed_by_hand(self):
        (self.project.out / "data/one/summary.json").write_text("{}")
        self.assert_stale("one: the result was changed after the run")
        self.assert_stale("one: the result was changed after the run", arguments=())

    def test_a_figure_older_than_its_data(self):
        self.project.age("results/report/figures/first.png", 60)
        self.assert_stale("figure first: older than its data")
        self.assert_remade(runs=0, drawn=True)

    def test_a_changed_script_style_or_table(self):
        self.project.write("reports/figures/first.py", FIGURE + "# another\n")
        self.assert_stale("figure first: its data, its script or its style changed")
        self.assert_remade(runs=0, drawn=True)
        self.project.write("reports/figures/style.py", "LINE = 2\n")
        self.assert_remade(runs=0, drawn=True)
        table = self.project.build / "evidence/tables/numbers.json"
        table.write_text(table.read_text().replace("2.0", "3.0"))
        self.assert_remade(runs=0, drawn=True)

    def test_a_figure_whose_data_lack_something(self):
        self.project.write("reports/figures/first.py", FIGURE.replace('table("numbers")', 'table("other")'))
        self.assert_stale("figure first: cannot be drawn of its data", "other", arguments=())

    def test_a_page_older_than_a_measurement(self):
        self.project.measure(EVIDENCE | {"measured": 2.002})
        self.assert_stale("index.html: older than", "what.json")
        self.assert_remade(runs=0, drawn=False)

    def test_a_run_that_fails_leaves_no_page(self):
        self.project.write("cases/bad.toml", "")
        self.project.write("reports/manifest.toml", MANIFEST.replace("one.toml", "bad.toml"))
        self.assert_stale("one: exit code 2", "tdbd: bad case", arguments=())
        self.assertFalse((self.project.out / "index.html").exists())
        self.assert_stale("one: has not been run")

    def test_evidence_older_than_its_program(self):
        self.project.age("build/release/verify", -60)
        self.assert_stale("older than the test program", "evidence for chapter5/order: no test wrote any")
        self.assert_stale("older than the test program", arguments=())
        self.assert_stale("numbers.json", "older than the test program", arguments=("--evidence-only",))

    def test_evidence_that_is_missing(self):
        (self.project.build / "evidence/chapter5/order/what.json").unlink()
        self.assert_stale("evidence for chapter5/order: no test wrote any")
        self.assert_stale("evidence for chapter5/order: no test wrote any", arguments=())
        self.assertFalse((self.project.out / "index.html").exists())
        code, _, complaints = self.project.make("--quick")
        self.assertEqual((code, complaints), (0, ""))
        page = (self.project.build / "report-quick/index.html").read_text()
        self.assertTrue("not measured in this run" in page)

    def test_an_open_claim_needs_no_evidence_and_may_have_none(self):
        self.project.write("reports/claims.toml", CLAIMS + 'open = "no <test> yet"\n')
        self.assert_stale("chapter5/order is open, and a test measures it", arguments=())
        (self.project.build / "evidence/chapter5/order/what.json").unlink()
        self.assert_made()
        page = (self.project.out / "index.html").read_text(encoding="utf-8")
        row = page[page.index('id="claim-chapter5/order"'):].split("</tr>")[0]
        self.assertTrue("no &lt;test&gt; yet" in row and ">open</span>" in row, row)

    def test_evidence_of_no_claim_or_verdict(self):
        self.project.measure(EVIDENCE | {"claim": "chapter5/other"})
        self.assert_stale("claims.toml has no chapter5/other")
        self.assert_stale("claims.toml has no chapter5/other", arguments=("--quick",))
        self.project.measure(EVIDENCE | {"verdict": "true"}, "second")
        self.assert_stale("verdict 'true'")
        self.project.measure({"claim": "chapter5/order", "program": "verify"}, "third")
        self.assert_stale("third.json", "missing")

    def test_the_page_agrees_with_the_files(self):
        page = (self.project.out / "index.html").read_text().replace("<wbr>", "")  # where a line may break
        self.assertRegex(page, 'title="2.001234567890123[0-9]"')  # every digit, on hover
        for words in ("Second &lt;order&gt;", "order of the attitude", "2.001", "2 +- 0.003", "Order.is_two",
                      "<b>Reconstructed:</b> all of it",
                      "tdbd rotate cases/one.toml --set &#39;time.step=0.1 s&#39;", "data:image/png;base64,"):
            self.assertTrue(words in page, words)
        self.assertFalse("http" in page)  # one file, nothing fetched
        self.project.measure(EVIDENCE | {"verdict": "refuted"}, "second")
        self.assert_made()
        page = (self.project.out / "index.html").read_text()
        row = page[page.index('id="claim-chapter5/order"'):].split("</tr>")[0]
        self.assertIn("refuted", row)  # the worst verdict is the claim's
        self.assertIn("all 2 measurements", row)

    def summary(self):
        """What the page states before its contents."""
        return (self.project.out / "index.html").read_text(encoding="utf-8").split('<nav aria-label="Contents">')[0]

    def test_the_page_begins_with_the_verdicts(self):
        for words in ("1 claims", "1 measurements", "<b>1</b>hold</li>", "<b>0</b>hold with limits</li>", "<b>0</b>refuted</li>"):
            self.assertIn(words, self.summary())
        self.assertNotIn("Refuted: ", self.summary())
        self.project.measure(EVIDENCE | {"verdict": "refuted"}, "second")
        self.assert_made()
        for words in ("<b>0</b>hold</li>", "<b>1</b>refuted</li>", "<summary>Refuted: 1</summary>",
                      '<a href="#claim-chapter5/order">Second &lt;order&gt;</a>'):
            self.assertIn(words, self.summary())

    def test_text_between_backticks_is_code(self):
        self.project.write("reports/manifest.toml", MANIFEST.replace('shows = "A line."', 'shows = "A `line`."'))
        self.assert_made()
        self.assertIn("A <code>line</code>.</p>", (self.project.out / "index.html").read_text(encoding="utf-8"))

    def test_a_quick_run_is_shorter_and_elsewhere(self):
        self.assertEqual(self.project.make("--quick")[0], 0)
        self.assertIn("--set time.duration=1 s", self.project.calls()[-1])
        self.assertEqual(self.project.make("--check"), (0, "", ""))


class Worst(unittest.TestCase):
    """A claim shows the worst of its measurements, wherever it stands among them."""

    def shown(self, *measurements):
        with tempfile.TemporaryDirectory() as folder:
            project = Project(folder)
            for i, (measured, limit, verdict) in enumerate(measurements):
                project.measure({**EVIDENCE, "what": f"number {i}", "measured": measured, "limit": limit,
                                 "verdict": verdict}, "what" if i == 0 else f"what-{i}")
            self.assertEqual(project.make()[2], "")
            page = (project.out / "index.html").read_text(encoding="utf-8")
            row = page[page.index('id="claim-'):]
            return row[row.index("number "):][:len("number 0")]

    def test_the_one_that_takes_most_of_its_limit(self):
        self.assertEqual(self.shown((1e-15, "<= 4e-12", "holds"), (3e-12, "<= 4e-12", "holds"),
                                    (5e-12, "<= 1e-11", "holds")), "number 1")
        self.assertEqual(self.shown((2.01, "2 +- 0.05", "holds"), (1.96, "2 +- 0.05", "holds")), "number 1")

    def test_the_one_of_the_worst_verdict_that_goes_farthest_beyond(self):
        self.assertEqual(self.shown((0.9, "<= 1", "holds"), (0.02, "<= 0.05", "refuted"),
                                    (4e-4, "a symplectic drift has <= 1e-13", "refuted")), "number 2")
        self.assertEqual(self.shown((1.09, "1 +- 0.1", "holds with limits"),
                                    (1.4, "1 +- 0.1 is missed: it rained", "holds with limits")), "number 1")


BIT_PAGE = """
def write(folder, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text((folder / "copy.toml").read_text(encoding="utf-8"), encoding="utf-8")
"""


class BitPages(OfOneProject):
    """The pages of bits are made of their results, again when anything behind them changed."""

    list, script, page_of, helper, source, kind = "bit_pages", "bit_page.py", "bits/one.html", "page_tables.py", BIT_PAGE, "page"

    @classmethod
    def make_first(cls, project):
        project.write("reports/manifest.toml", f'{cls.list} = ["one"]\n' + MANIFEST)
        project.write(f"reports/{cls.script}", cls.source)
        code, made, complaints = project.make()
        assert (code, made.count("made one ("), complaints) == (0, 2, ""), complaints  # the result and its page

    def setUp(self):
        super().setUp()
        self.page = self.project.out / self.page_of

    def make(self, *words):
        return self.project.make_or_complain(self, words).count("made one (")

    def assert_stale_then_made(self, made=1):
        code, _, complaints = self.project.make("--check")
        self.assertEqual(code, 1)
        self.assertIn("one", complaints)
        self.assertEqual(self.make(), made)
        self.assertEqual(self.project.make("--check"), (0, "", ""))

    def test_are_made_once_and_linked(self):
        self.assertEqual(self.make(), 0)
        self.assertIn(f'href="{self.page_of}"', (self.project.out / "index.html").read_text(encoding="utf-8"))

    def test_are_made_again_when_they_went_or_their_script_changed(self):
        self.page.unlink()
        self.assert_stale_then_made()
        self.project.write(f"reports/{self.helper}", "# another\n")
        self.assert_stale_then_made()

    def test_are_made_again_when_what_their_script_uses_changed(self):
        self.project.write(f"reports/{self.script}", "from figures import first, charts\n" + self.source)
        self.project.write("reports/figures/charts.py", "from figures.deep import A\n")
        self.project.write("reports/figures/deep.py", "A = 1\n")
        self.make()
        self.project.write("reports/figures/deep.py", "A = 2\n")
        self.assert_stale_then_made()

    def test_are_made_again_when_their_data_changed(self):
        self.project.write("cases/one.toml", "[time]\nstep = 2.0\n")
        self.assert_stale_then_made(made=2)
        self.assertIn("step = 2.0", self.page.read_text(encoding="utf-8"))

    def test_that_cannot_be_drawn_leave_no_report(self):
        self.project.write(f"reports/{self.script}", "def write(folder, path):\n    raise ValueError('no parts')\n")
        self.make(f"{self.kind} of one: no parts")
        self.assertFalse((self.project.out / "index.html").exists())


PAGE_3D = BIT_PAGE.replace("def write", "class Frames:\n    missing = []\n\ndef write") + "    return Frames\n"


class Pages3d(BitPages):
    """The same for 3-D pages of runs. A page without a frame is not one."""

    list, script, page_of, helper, source, kind = "pages3d", "page3d.py", "3d/one.html", "page3d_pack.py", PAGE_3D, "3-D page"

    def test_is_linked_beside_the_figure_of_its_run(self):
        page = (self.project.out / "index.html").read_text(encoding="utf-8")
        figure = page.split('<figure id="figure-first">')[1].split("</figure>")[0]
        self.assertIn('<a href="3d/one.html">one</a>', figure)

    def test_that_lacks_a_frame_is_none(self):
        self.project.write("reports/page3d.py", PAGE_3D.replace("missing = []", "missing = [{'number': 7, 'why': 'gone'}]"))
        self.make("3-D page of one: found no frame 7 (gone), expected all")
        self.assertFalse(self.page.exists())


class Manifest(unittest.TestCase):
    def test_mistakes_are_named(self):
        for wrong, words in {
                MANIFEST.replace("case =", "cas ="): "run one: unknown key cas",
                MANIFEST.replace('title = "First"', ""): "figure first: title is missing",
                MANIFEST.replace('runs = ["one"]', 'runs = "one"'): "expected a list",
                MANIFEST.replace('["one"]', '["two"]'): "figure first: no run or claim two",
                MANIFEST.replace('"chapter5/order"', '"order"'): "no run or claim order",
                MANIFEST + MANIFEST[MANIFEST.index("[[figures]]"):]: "twice: first",
                MANIFEST.replace('["one"]', "[]"): "no figure shows the runs one",
                MANIFEST + "[": "manifest.toml"}.items():
            with tempfile.TemporaryDirectory() as folder:
                project = Project(folder)
                project.write("reports/manifest.toml", wrong)
                code, _, complaints = project.make()
                self.assertEqual(code, 1)
                self.assertIn(words, complaints)
                self.assertEqual(project.calls(), [])

    def test_a_sweep_is_a_run_for_every_combination(self):
        with tempfile.TemporaryDirectory() as folder:
            project = Project(folder)
            project.write("reports/manifest.toml", MANIFEST.replace(
                "quick =", 'sweep = {"integrator.order" = [2, 4], "time.step" = ["1 s", "2 s"]}\nquick ='))
            project.write("reports/figures/first.py", FIGURE.replace(
                "inputs.folder('one').name", "len(inputs.sweep('one'))"))
            self.assertEqual(project.make()[2], "")
            self.assertEqual(len(project.calls()), 4)
            wanted = {f"--set time.step={step} s --set integrator.order={order} -o" for step in (1, 2) for order in (2, 4)}
            for words in wanted:  # in any order: they run at once
                self.assertEqual(sum(words in call for call in project.calls()), 1, words)
            self.assertTrue((project.out / "data/one/2/1s/summary.json").is_file())
            self.assertEqual(project.make("--check"), (0, "", ""))


if __name__ == "__main__":
    unittest.main()
