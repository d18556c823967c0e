"""form_test.py PROGRAM ROOT [PICTURES]: the form of the page that drills, in a headless Chromium, with stand_in.js in place of the program for
browsers, which need not be built. Exit code 77: there is no Chromium."""

import base64
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile

PROGRAM, ROOT = map(pathlib.Path, sys.argv[1:3])
PICTURES = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
sys.path.insert(0, str(ROOT / "verification/reports"))
import browser  # noqa: E402

SKIPPED, PATIENCE = 77, 60
SAVED = "btoa(Array.from(saved[Object.keys(saved)[0]], b => String.fromCharCode(b)).join(''))"


class Form(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.folder = pathlib.Path(made.name)
        shutil.copy(ROOT / "verification/web/stand_in.js", cls.folder / "tdbd.js")
        (cls.folder / "tdbd.wasm").write_bytes(b"none")
        subprocess.run([sys.executable, "-B", ROOT / "web/make.py", cls.folder, "-o", cls.folder / "page.html"], check=True, capture_output=True)
        cls.browser = cls.enterClassContext(browser.Browser(size=(1200, 1500)))

    def setUp(self):
        self.browser.open(self.folder / "page.html")
        self.until("live.state === 'ended'")

    def tearDown(self):
        self.assertEqual(self.browser.complaints, [])

    def value(self, expression):
        return self.browser.value(expression)

    def until(self, condition):
        end = time.monotonic() + PATIENCE
        while not self.value(condition):
            self.assertLess(time.monotonic(), end, f"{condition}: {self.value('live.state')}, {self.value('''place('problem').textContent''')}")
            time.sleep(0.05)

    def choose(self, **values):
        for name, value in values.items():
            self.value(f"place('{name.replace('_', '-')}').value = {json.dumps(value)}, place('form').dispatchEvent(new Event('change'))")

    def drill(self):
        self.value("live.facts = null, place('form').requestSubmit()")
        self.until("live.state === 'ended' && live.facts")

    def see(self, name):
        if PICTURES:
            (PICTURES / f"{name}.png").write_bytes(self.browser.picture(whole=True))

    def shown(self, *names):
        return [n for n in names if not self.value(f"place('{n}').hidden")]

    def zip(self):
        """The ZIP file that the button saves."""
        self.value("window.saved = {}, save = (name, content) => { saved[name] = content; }, place('case-zip').click()")
        return self.value("Object.keys(saved)[0]"), zipfile.ZipFile(io.BytesIO(base64.b64decode(self.value(SAVED))))

    def test_a_table_becomes_a_zip_file_that_the_program_accepts(self):
        self.value("window.saved = {}, save = (name, content) => { saved[name] = content; }, place('template').click()")
        self.assertIn("r_tip_mm", self.value("saved['cutters.csv']"))
        self.value("takeTable(new File([saved['cutters.csv']], 'my layout.csv'))")
        self.until("live.state === 'ended' && live.choice.bit === 'own'")
        self.assertEqual(self.value("place('gage').value"), "215.9")
        self.choose(chamfer="0.4", edge="10")
        self.drill()
        self.see("own")
        self.assertIn("a chamfer of 0.4 mm at 45 degrees", self.value("place('assumptions').textContent"))
        name, packed = self.zip()
        self.assertEqual((name, packed.testzip()), ("my-layout.zip", None))
        with tempfile.TemporaryDirectory() as made:
            packed.extractall(made)
            done = subprocess.run([PROGRAM, "check", "case.toml"], cwd=pathlib.Path(made) / "my-layout", capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_zip_file_is_that_of_the_hole_on_the_page(self):
        self.choose(rock="texas-granite")
        self.drill()
        self.choose(rock="berea-sandstone", speed="13")
        self.value("place('form').requestSubmit()")
        self.until("live.state === 'refused'")
        self.assertIn("found 13 rpm", self.value("place('problem').textContent"))
        case = self.zip()[1].read("bit-b/case.toml").decode()
        self.assertIn('material = "texas-granite"', case)

    def test_shows_the_settings_that_apply(self):
        groups = ("own-bit", "energy-is", "weight-is", "whirls-is")
        self.assertEqual(self.shown(*groups), ["whirls-is"])
        self.choose(law="detournay", drive="weight", bit_choice="own")
        self.assertEqual(self.shown(*groups), ["own-bit", "energy-is", "weight-is"])
        self.choose(bit_choice="r")
        self.assertEqual(self.value("[...place('law').options].map(o => o.value)"), ["indentation"])
        self.assertEqual(self.shown(*groups), ["weight-is"])
        self.assertIn("The weight on bit is 30 kN", self.value("place('assumptions').textContent"))
        self.drill()
        self.assertIn("ROP 36.0 m/h", self.value("place('status').textContent"))
        self.see("weight")

    def test_names_the_parts_of_the_bit_and_draws_axes(self):
        self.assertIn("faces of cutters", self.value("place('bit-legend').textContent"))
        self.assertIn("time, s", self.value("place('traces').textContent"))


if __name__ == "__main__":
    if browser.PROGRAM is None:
        print("skipped: there is no Chromium (bash scripts/setup browser)")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
