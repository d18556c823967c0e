"""page_test.py PROGRAM ROOT WEB [PICTURES]: the page that drills, in a headless Chromium: pixels, all bits, whirl, pause, tables good
and bad, downloads, keys, both colour schemes, no WebGL 2, no complaint. Exit code 77: nothing built, or no Chromium."""

import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import built
import numpy as np

PROGRAM, ROOT, WEB = map(pathlib.Path, sys.argv[1:4])
PICTURES = pathlib.Path(sys.argv[4]) if len(sys.argv) > 4 else None
sys.path.insert(0, str(ROOT / "verification/reports"))
import browser  # noqa: E402
import page_pixels  # noqa: E402

PATIENCE = 60  # s, for any answer of the page
AGREE = 1e-12  # of the page's volumes and the command line's
SHORT = {"edge": 5, "revolutions": 0.2}


class Driven(unittest.TestCase):
    """A page in a browser, opened again for each test."""

    options = browser.SOFTWARE

    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.made.cleanup)
        cls.page = pathlib.Path(cls.made.name) / "tdbd.html"
        subprocess.run([sys.executable, "-B", ROOT / "web/make.py", WEB, "-o", cls.page], check=True, capture_output=True)
        cls.browser = cls.enterClassContext(browser.Browser(cls.options, size=(1200, 1100)))

    def setUp(self):
        self.browser.open(self.page)
        self.until("live.state === 'drilling'")

    def tearDown(self):
        self.assertEqual(self.browser.complaints, [])
        for address in self.browser.requests:
            self.assertRegex(address, "^(file|data|blob):")

    def value(self, expression):
        return self.browser.value(expression)

    def until(self, condition):
        end = time.monotonic() + PATIENCE
        while not self.value(condition):
            self.assertLess(time.monotonic(), end, f"{condition}: {self.value('live.state')}, {self.value('''place('problem').textContent''')}")
            time.sleep(0.05)

    def choose(self, **values):
        """Puts values into the form and presses Drill."""
        for name, value in values.items():
            kind = "checked" if isinstance(value, bool) else "value"
            self.value(f"place('{name.replace('_', '-')}').{kind} = {json.dumps(value)}")
        self.value("place('form').dispatchEvent(new Event('change'))")
        self.value("live.facts = null, place('form').requestSubmit()")

    def drill(self, **values):
        """Drills to the end; returns the last look."""
        self.choose(**{**SHORT, **values})
        self.until("live.state === 'ended' || live.state === 'refused'")
        self.assertEqual(self.value("live.state"), "ended", self.value("place('problem').textContent"))
        return self.value("live.last")

    def drop(self, name, text):
        """Drops a file on the page, as a mouse does."""
        self.value(f"""(d => {{ d.items.add(new File([{json.dumps(text)}], {json.dumps(name)}));
            document.dispatchEvent(new DragEvent('drop', {{dataTransfer: d, bubbles: true, cancelable: true}})); }})(new DataTransfer())""")

    def seen(self, name=None):
        """The pixels of the 3-D picture."""
        return page_pixels.pixels(self.browser, PICTURES, name)


class Page(Driven):
    def test_draws_a_hole_that_grows(self):
        first = self.value("live.last.removed_m3")
        self.until("live.last.time_s > 0.3")
        image = self.seen("drills")
        self.assertGreater((np.abs(image - image[3, 3]).max(axis=2) > 12).mean(), 0.25)
        self.assertGreater(len(np.unique(image.reshape(-1, 3), axis=0)), 500)
        self.assertGreater(self.value("live.last.removed_m3"), first)
        self.assertTrue(self.value("place('still').hidden"))
        self.assertEqual(self.value("document.querySelectorAll('#traces figure').length"), 2)
        shown = "Array.from(document.querySelectorAll('#bars tr')).filter(r => !r.hidden && parseFloat(r.querySelector('.fill').style.width) > 0).length"
        self.assertGreater(self.value(shown), 20)

    def test_drills_as_the_command_line_does(self):
        look = self.drill(whirls=True, rate=20)
        with tempfile.TemporaryDirectory() as made:
            folder = pathlib.Path(made)
            for path, text in self.value("live.files").items():
                (folder / path).parent.mkdir(exist_ok=True)
                (folder / path).write_text(text, encoding="utf-8")
            subprocess.run([PROGRAM, "run", folder / "case.toml", "-o", folder / "out", "--quiet"], check=True, capture_output=True)
            run = json.loads((folder / "out/summary.json").read_text(encoding="utf-8"))
        volumes = np.array(list(run["removed_volume_by_part_m3"].values()))
        self.assertEqual(look["steps"], run["steps"])
        np.testing.assert_allclose(look["removed_by_part_m3"], volumes, rtol=0, atol=AGREE * volumes.max())

    def test_drills_every_bit(self):
        for bit in "abcr":
            with self.subTest(bit):
                look = self.drill(bit_choice=bit, revolutions=1)  # cones begin on a bottom that is higher than their prints
                self.assertGreater(look["removed_m3"], 1e-6)
                self.assertGreater(self.value("Math.max(...live.traces[0].value)"), 1)  # kN
                self.browser.drawn()
                self.seen(f"bit-{bit}")

    def test_pauses_and_continues(self):
        self.value("place('pause').click()")
        self.until("live.state === 'paused'")
        stood = self.value("live.last.time_s")
        time.sleep(0.5)
        self.assertEqual(self.value("live.last.time_s"), stood)
        self.assertEqual(self.value("place('pause').textContent"), "Resume")
        self.value("place('view').focus()")
        self.browser.press(" ")
        self.until(f"live.last.time_s > {stood}")

    def test_drills_a_table_that_is_dropped(self):
        text = (ROOT / "cases/bits/bit-c.csv").read_text(encoding="utf-8")
        self.choose(**SHORT)
        self.drop("my layout.csv", text)
        self.until("live.facts && live.facts.title === 'my-layout' && live.state === 'ended'")
        self.assertFalse(self.value("place('own-bit').hidden"))
        cutters = len([row for row in text.splitlines()[1:] if row.strip()])
        self.assertEqual(self.value("live.facts.parts.filter(p => p.kind === 'face').length"), cutters)

    def test_reports_mistakes_in_a_table(self):
        text = (ROOT / "cases/bits/bit-c.csv").read_text(encoding="utf-8")
        for name, wrong, words in (("column.csv", text.replace("back_rake_deg", "back_rake_grad"), ("column.csv", "back_rake_grad")),
                                   ("cell.csv", text.replace("13.44", "thirteen", 1), ("cell.csv:2", "thirteen")), ("empty.csv", "", ("empty.csv", "no cutter"))):
            with self.subTest(name):
                self.drop(name, wrong)
                self.until(f"live.table && live.table.name === '{name}' && live.state === 'refused'")
                for word in words:
                    self.assertIn(word, self.value("place('problem').textContent"))
        self.assertFalse(self.value("place('problem').hidden"))
        self.seen("refused")
        self.drill(bit_choice="b")
        self.assertTrue(self.value("place('problem').hidden"))

    def test_reports_mistakes_in_a_number(self):
        for values, words in (({"speed": ""}, ("rotary_speed",)), ({"edge": "-1"}, ("edge_length", "-1 mm")), ({"rate": "1e9"}, ("step",))):
            with self.subTest(values):
                self.choose(**{"speed": 120, "edge": 5, "rate": 15, **values})
                self.until("live.state === 'refused'")
                for word in words:
                    self.assertIn(word, self.value("place('problem').textContent"))

    def test_gives_away_what_it_made(self):
        self.value("window.saved = {}, save = (name, content) => { saved[name] = content; }")
        look = self.drill()
        for button in ("surface", "volumes-csv", "traces-csv", "case-zip"):
            self.value(f"place('{button}').click()")
        self.until("Object.keys(saved).length === 4")
        header = self.value("new TextDecoder().decode(saved['rock.ply'].slice(0, 400))")
        self.assertIn(f"element face {look['triangles']}\n", header)
        self.assertEqual(len(self.value("saved['volumes.csv']").splitlines()), 1 + len(look["removed_by_part_m3"]))
        rows = self.value("saved['traces.csv']").splitlines()
        self.assertEqual((rows[0], len(rows)), ("time_s,wob_kN,tob_N_m", 1 + look["steps"]))
        self.assertIn("bit-b/case.toml", self.value("new TextDecoder().decode(saved['bit-b.zip'])"))
        self.assertIn('edge_length = "5 mm"', self.value("live.files['case.toml']"))

    def test_drills_under_a_weight(self):
        look = self.drill(drive="weight", revolutions=1)
        self.assertFalse(self.value("place('weight-is').hidden"))
        self.assertIn("ROP", self.value("place('status').textContent"))
        self.assertGreater(look["removed_m3"], 1e-6)

    def test_keys_turn_and_cut(self):
        self.drill()
        self.value("place('view').focus()")
        for key in ("ArrowLeft", "+", "c", "Home"):
            self.browser.drawn()
            before = self.seen()
            self.browser.press(key)
            self.assertGreater((self.seen(f"key-{key}") != before).any(axis=2).mean(), 0.02, key)

    def test_is_readable_in_light_and_dark(self):
        inks = []
        for scheme in ("light", "dark"):
            self.browser.prefer(scheme)
            ink, paper = self.value(page_pixels.INK_AND_PAPER)
            inks.append(ink)
            self.assertGreater(page_pixels.contrast(ink, paper), page_pixels.READABLE)
        self.assertNotEqual(*inks)
        self.seen("dark")
        self.browser.prefer("light")


class WithoutWebGL(Driven):
    options = browser.WITHOUT_WEBGL

    def test_drills_in_numbers_beside_a_picture(self):
        self.until("live.last && live.last.removed_m3 > 0")
        self.assertIn("no WebGL 2", self.value("place('why').textContent"))
        self.assertTrue(self.value("place('three').hidden"))
        self.assertGreater(self.value("document.querySelector('#still img').naturalWidth"), 100)


if __name__ == "__main__":
    built.require(PROGRAM, ROOT, WEB)
    if browser.PROGRAM is None:
        print("skipped: there is no Chromium (bash scripts/setup browser)")
        sys.exit(built.SKIPPED)
    unittest.main(argv=sys.argv[:1])
