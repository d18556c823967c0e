"""page3d_browser_test.py PROGRAM ROOT [PICTURES]: the 3-D page in a headless Chromium: pixels, slider, keys, mouse, both colour
schemes, a missing frame, no WebGL 2, no complaint. Exit code 77: there is no Chromium. PICTURES: a folder for what was seen."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import browser
import numpy as np
import page3d_data
import page_pixels

PROGRAM, ROOT = map(pathlib.Path, sys.argv[1:3])
PICTURES = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
sys.path.insert(0, str(ROOT / "reports"))
import page3d_pack  # noqa: E402
from figures import rock_data  # noqa: E402

SKIPPED = 77
FRAMES = 6
SETTINGS = ("rock.edge_length=4 mm", "time.step=5 ms", "time.revolutions=0.6", "output.frames_every=10")
LOST = 3  # the frame that the page with a gap lacks
GRID_QUALITY = 1.5e-3  # an edge of 4 mm, off by half a step of 3 um in each direction at both ends
SUMS = "frames.map(f => [f.points, f.corners, f.last].map(a => a.map(c => c.reduce((sum, v, i) => sum + v * (i % 97 + 1), 0))))"
QUALITY = """started.then(s => { const f = s.frames[s.frames.length - 1]; return Array.from(f.corners[0], (_, t) => qualityOf(f, s.run.box, t)); })"""


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.made.name)
        subprocess.run([PROGRAM, "run", ROOT / "cases/bit-b-steady.toml", "-o", cls.folder, "--quiet", *(w for s in SETTINGS for w in ("--set", s))],
                       check=True)
        cls.whole, cls.gap = cls.folder / "whole.html", cls.folder / "gap.html"
        for page in (cls.whole, cls.gap):
            subprocess.run([sys.executable, "-B", ROOT / "reports/page3d.py", cls.folder, "-o", page], check=True, capture_output=True)
            rock_data.frames(cls.folder)[LOST - 1][1].unlink(missing_ok=True)
        cls.browser = browser.Browser()
        cls.browser.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.made.cleanup()

    def setUp(self):
        self.open(self.whole)

    def tearDown(self):
        self.assertEqual(self.browser.complaints, [])

    def open(self, page):
        self.browser.open(page)
        self.assertTrue(self.browser.value("started.then(s => s !== null)"), "the page did not start")
        self.browser.drawn()

    def seen(self, name=None):
        """The pixels of the 3-D picture."""
        return page_pixels.pixels(self.browser, PICTURES, name)

    def state(self, name):
        return self.browser.value(f"started.then(s => s.state.{name})")

    def words(self):
        return self.browser.value("place('now').textContent")

    def changes(self, act, name=None):
        """The share of the picture's pixels that an act changes."""
        before = self.seen()
        act()
        self.browser.drawn()
        return (self.seen(name) != before).any(axis=2).mean()

    def sums(self, frames):
        """Of columns, each number with a weight of its own: what SUMS computes in the page."""
        return [[[int((c * (np.arange(len(c)) % 97 + 1)).sum()) for c in frame[name].T] for name in ("points", "corners", "last")] for frame in frames]

    def test_reads_the_numbers_that_the_program_wrote(self):
        frames, _ = page3d_data.frames(self.whole.read_text(encoding="utf-8"))
        self.assertEqual(self.browser.value(f"started.then(s => (frames => {SUMS})(s.frames))"), self.sums(frames))
        quality = rock_data.final(self.folder).cell_values["quality"]
        np.testing.assert_allclose(self.browser.value(QUALITY), quality, atol=GRID_QUALITY)

    def test_reads_meshes_that_change_between_frames(self):
        meshes = page3d_data.changing_meshes()
        entries, data, _ = page3d_data.packed(page3d_pack, meshes)
        self.assertEqual([e["over_time"] for e in entries[:5]], [False, True, True, True, False])
        found = self.browser.value(f"inflate({json.dumps(data)}).then(b => (frames => {SUMS})(unpackFrames({json.dumps(entries)}, arrayReader(b))))")
        self.assertEqual(found, self.sums([dict(zip(("points", "corners", "last"), m)) for m in meshes]))

    def test_draws_the_hole_and_fetches_nothing(self):
        image = self.seen("light")
        background = image[3, 3]
        self.assertGreater((np.abs(image - background).max(axis=2) > 12).mean(), 0.25)
        self.assertGreater(len(np.unique(image.reshape(-1, 3), axis=0)), 500)
        for address in self.browser.requests:
            self.assertRegex(address, "^(file|data):")
        self.assertFalse(self.browser.value("!place('still').hidden"))

    def test_the_slider_shows_other_frames(self):
        self.assertIn(f"Frame {FRAMES} of {FRAMES}", self.words())
        self.browser.value("place('time').focus()")
        self.assertGreater(self.changes(lambda: self.browser.press("Home"), "first"), 0.002)
        self.assertIn(f"Frame 1 of {FRAMES}: 0.05 s, 0.10 revolutions", self.words())
        self.browser.press("ArrowRight", 2)
        self.assertIn(f"Frame 3 of {FRAMES}", self.words())
        self.assertEqual(self.browser.value("place('time').getAttribute('aria-valuetext')"), self.words())
        middle = self.browser.value("(PLOT.left + PLOT.right) / 2")
        self.assertAlmostEqual(self.browser.value("Number(document.querySelector('.mark').getAttribute('x1'))"), middle, delta=1)

    def test_traces_have_axes_with_ticks_and_units(self):
        for name, unit in (("Rate of penetration", "m/h"), ("Rock removed", "cm\u00b3")):
            ticks = self.browser.value(f"""[...[...document.querySelectorAll('#traces figure')].find(f => f.textContent.includes('{name}'))
                .querySelectorAll('.tick')].map(t => t.textContent)""")
            self.assertIn("time, s", ticks)
            self.assertIn(unit, ticks)
            numbers = [float(t) for t in ticks if t not in ("time, s", unit)]
            self.assertGreaterEqual(len(numbers), 6, ticks)
            self.assertTrue(all(len(t) < 7 for t in ticks[:-2]), ticks)  # no 119.999999999979991

    def test_a_click_on_a_cutter_selects_it_and_a_drag_does_not(self):
        where = self.browser.value("""started.then(s => { for (let i = 3; i < 17; ++i) for (let k = 3; k < 17; ++k) {
            const [x, y] = [i / 10 - 1, k / 10 - 1], part = pickedPart(s, x, y);
            if (part >= 0 && s.run.parts[part].name.startsWith('cutter-')) return [x, y, s.run.parts[part].name];
          } })""")
        x, y = self.browser.value(f"(r => [r.x + r.width * {0.5 + where[0] / 2}, r.y + r.height * {0.5 - where[1] / 2}])(place('view').getBoundingClientRect())")
        selected = "place('part').selectedOptions[0].textContent"

        def click(moved=0):
            self.browser.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
            if moved:
                self.browser.mouse("mouseMoved", x + moved, y, button="left", buttons=1)
            self.browser.mouse("mouseReleased", x + moved, y, button="left", clickCount=1)
        self.assertEqual(self.browser.value(selected), "none")
        self.assertGreater(self.changes(click, "selected"), 1e-4)
        self.assertEqual(self.browser.value(selected), where[2])
        for words in ("radius of the tip", "azimuth", "rock removed in the run"):
            self.assertIn(words, self.browser.value("place('part-facts').textContent"))
        click(moved=30)
        self.assertEqual(self.browser.value(selected), where[2])
        self.browser.value("selectPart(JSON.parse(place('run').textContent).parts, -1)")
        self.assertEqual(self.browser.value("place('part-facts').textContent"), "")

    def test_keys_turn_zoom_play_and_cut(self):
        self.browser.value("place('view').focus()")
        eye = "started.then(s => [s.camera.azimuth, s.camera.height, s.camera.distance])"
        start = self.browser.value(eye)
        self.assertGreater(self.changes(lambda: self.browser.press("ArrowLeft", 4)), 0.1)
        self.browser.press("ArrowUp", 2)
        self.browser.press("+", 2)
        moved = self.browser.value(eye)
        self.assertTrue(moved[0] > start[0] and moved[1] > start[1] and moved[2] < start[2], (start, moved))
        self.browser.press("ArrowRight", 4)
        self.browser.press("ArrowDown", 2)
        self.browser.press("-", 2)
        np.testing.assert_allclose(self.browser.value(eye), start, rtol=1e-9)
        self.browser.press(",")
        self.assertEqual(self.state("frame"), FRAMES - 2)
        self.browser.press(".", 2)
        self.assertEqual(self.state("frame"), 0)
        self.browser.press("c")
        self.assertTrue(self.state("cuts"))
        self.browser.press("+", 5)
        self.browser.press("Home")
        np.testing.assert_allclose(self.browser.value(eye), start, rtol=1e-9)

    def test_plays_and_pauses(self):
        self.browser.value("place('view').focus()")
        self.browser.press(" ")
        self.assertEqual(self.browser.value("place('play').textContent"), "Pause")
        frames = self.browser.value("new Promise(done => { const seen = []; const clock = setInterval(() => { seen.push(Number(place('time').value)); "
                                    "if (new Set(seen).size > 2) { clearInterval(clock); done([...new Set(seen)]); } }, 50); })")
        self.assertEqual(len(frames), 3)
        self.browser.press(" ")
        self.assertFalse(self.state("plays"))

    def test_the_mouse_turns_and_zooms(self):
        x, y = self.browser.value("(r => [r.x + r.width / 2, r.y + r.height / 2])(place('view').getBoundingClientRect())")

        def drag():
            self.browser.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
            self.browser.mouse("mouseMoved", x + 120, y + 30, button="left", buttons=1)
            self.browser.mouse("mouseReleased", x + 120, y + 30, button="left", clickCount=1)
        self.assertGreater(self.changes(drag), 0.1)
        self.assertGreater(self.changes(lambda: self.browser.mouse("mouseWheel", x, y, deltaX=0, deltaY=-300)), 0.1)

    def choose(self, name, value):
        self.browser.value(f"(c => {{ c.value = {json.dumps(value)}; c.dispatchEvent(new Event('change')); c.dispatchEvent(new Event('input')); }})(place('{name}'))")

    def test_colours_bit_and_section_change_the_picture(self):
        for name, value, least in (("colour", "part", 0.1), ("colour", "quality", 0.1), ("bit", "all", 0.05), ("bit", "none", 0.05)):
            self.assertGreater(self.changes(lambda n=name, v=value: self.choose(n, v), f"{name}-{value}"), least, (name, value))
        self.assertIn("equilateral", self.browser.value("place('legend').textContent"))
        self.choose("colour", "part")
        self.assertIn("cutter-7", self.browser.value("place('legend').textContent"))
        self.assertGreater(self.groups_seen(), 10)
        self.assertGreater(self.changes(lambda: self.browser.value("place('lines').click()"), "lines"), 0.05)
        whole = self.seen()
        self.assertGreater(self.changes(lambda: self.browser.value("place('cut').click()"), "section"), 0.05)
        self.assertGreater(self.changes(lambda: self.choose("cut-move", "60"), "section-moved"), 0.02)
        self.choose("cut-move", "-107")
        self.assertLess(self.rock_share(), 0.4 * np.mean(np.abs(whole - whole[3, 3]).max(axis=2) > 12), "the section leaves too much rock")

    def groups_seen(self):
        """Of the groups that cut last: how many have pixels of their colour, which light makes darker and leaves as it is."""
        pixels = self.seen().reshape(-1, 3)
        pixels = pixels[pixels.max(axis=1) > 40]
        pixels = pixels / np.linalg.norm(pixels, axis=1, keepdims=True)
        colours = [[int(c[k:k + 2], 16) for k in (1, 3, 5)] for c in self.browser.value("started.then(s => s.run.colours.part.colours.slice(1))")]
        return sum((pixels @ (np.array(c) / np.linalg.norm(c)) > 0.9998).sum() > 50 for c in colours)

    def rock_share(self):
        """Of the picture: what is not background, without the bit."""
        image = self.seen()
        return (np.abs(image - image[3, 3]).max(axis=2) > 12).mean()

    def test_both_colour_schemes_can_be_read(self):
        papers = []
        for scheme in ("light", "dark"):
            self.browser.prefer(scheme)
            self.seen(f"scheme-{scheme}")
            ink, paper = self.browser.value(page_pixels.INK_AND_PAPER)
            papers.append(np.mean(paper))
            self.assertGreater(page_pixels.contrast(ink, paper), page_pixels.READABLE, scheme)
            self.assertGreater(self.rock_share(), 0.25, scheme)
        self.browser.prefer("light")
        self.assertTrue(papers[0] > 200 and papers[1] < 60, papers)

    def test_a_missing_frame_is_named_and_skipped(self):
        self.open(self.gap)
        self.assertIn(f"frame {LOST}", self.browser.value("place('missing').textContent"))
        self.browser.value("place('time').focus()")
        self.browser.press("Home")
        numbers = []
        for _ in range(FRAMES - 1):
            numbers.append(int(self.words().split()[1]))
            self.browser.press("ArrowRight")
        self.assertEqual(numbers, [k for k in range(1, FRAMES + 1) if k != LOST])
        self.seen("gap")

    def test_every_control_is_reached_by_tab_and_has_a_name(self):
        self.browser.value("document.body.focus()")
        reached = []
        for _ in range(14):
            self.browser.press("Tab")
            reached.append(self.browser.value("document.activeElement.id"))
        self.assertLessEqual({"view", "play", "time", "colour", "bit", "lines", "cut", "home", "part"}, set(reached), reached)
        nameless = self.browser.value("[...document.querySelectorAll('input, select')].filter(c => !c.labels.length).map(c => c.id)")
        self.assertEqual(nameless, [])


class WithoutWebGL(unittest.TestCase):
    def test_reports_it_and_shows_the_end_as_a_picture(self):
        with tempfile.TemporaryDirectory() as made, browser.Browser(browser.WITHOUT_WEBGL) as window:
            made = pathlib.Path(made)
            subprocess.run([PROGRAM, "run", ROOT / "cases/bit-b-steady.toml", "-o", made, "--quiet", *(w for s in SETTINGS for w in ("--set", s))], check=True)
            subprocess.run([sys.executable, "-B", ROOT / "reports/page3d.py", made], check=True, capture_output=True)
            window.open(made / "result.html")
            self.assertTrue(window.value("started.then(s => s === null)"))
            self.assertIn("cannot draw the run in 3-D: it has no WebGL 2", window.value("place('why').textContent"))
            self.assertEqual(window.value("(i => i.complete && i.naturalWidth > 300 && i.getBoundingClientRect().height > 300)(document.querySelector('#still img'))"), True)
            self.assertTrue(window.value("place('three').hidden"))
            self.assertEqual(window.value("document.querySelectorAll('#traces svg').length"), 2)
            if PICTURES:
                (PICTURES / "without-webgl.png").write_bytes(window.picture())


if __name__ == "__main__":
    if not browser.PROGRAM:
        print("skipped: there is no chromium to open the page in; install it with: bash scripts/setup browser")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
