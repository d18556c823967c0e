"""case_zip_test.py PROGRAM ROOT: the ZIP files that the page for browsers offers, written under node: unpacked, each is a case that
`tdbd check` accepts and `tdbd run` drills. The program for browsers need not be built. Exit code 77: there is no node."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

PROGRAM, ROOT = map(pathlib.Path, sys.argv[1:3])
NODE, SKIPPED = shutil.which("node"), 77
FORM = {"bit": "b", "table": None, "gage": "215.9", "chamfer": "0.3", "chamferAngle": "45", "cutterLength": "13", "diamond": "2", "rock": "mancos-shale",
        "pressure": "20.7", "law": "hanson-hansen", "energy": "100", "drive": "rate", "weight": "30", "speed": "120", "rate": "15", "edge": "8",
        "revolutions": "0.1", "whirls": False, "whirlRadius": "1", "whirlTimes": "3", "whirlSense": "backward"}
OWN = {"bit": "own", "table": {"name": "my layout.csv", "text": ""}}  # the text is that of the template
ROCKS = ("berea-sandstone", "carthage-marble", "catoosa-shale", "crab-orchard-sandstone", "forge-granitoid", "indiana-limestone", "mancos-shale",
         "sierra-white-granite", "texas-granite")
CHOICES = ([{"bit": bit, "drive": drive} for bit in "abcrm" for drive in ("rate", "weight")] + [{"law": law} for law in ("hanson-hansen", "detournay", "thin-cut")]
           + [{"rock": rock} for rock in ROCKS] + [{"whirls": True}, OWN, {**OWN, "drive": "weight"}, {**OWN, "chamfer": "0", "law": "thin-cut"}])
TABLES = ("bit,r_tip_mm\nB,5\nB,107.95\n", "# words, words\n\nR_TIP_MM;dia_mm\n107,95;13\n5,0;13\n", "r_tip_in\tdia_mm\n4.25\t13\n", "radius\n3\n", "")


def made(choices, tables=()):
    """(what the script prints, {name: bytes} of what it writes) for changes of FORM."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([NODE, ROOT / "verification/web/case_zips.js", ROOT, folder], capture_output=True, text=True, check=True,
                              input=json.dumps({"choices": [{**FORM, **c} for c in choices], "tables": tables}))
        return json.loads(done.stdout), {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}


class Zips(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        cls.said, cls.files = made(CHOICES, TABLES)
        for k in range(len(CHOICES)):
            (cls.folder / f"{k}.zip").write_bytes(cls.files[f"{k}.zip"])
            with zipfile.ZipFile(cls.folder / f"{k}.zip") as packed:
                assert packed.testzip() is None, CHOICES[k]
                packed.extractall(cls.folder / str(k))

    def case(self, k):
        """The case of a choice, unpacked."""
        [found] = (self.folder / str(k)).glob("*/case.toml")
        return found

    def text(self, changes):
        return self.case(CHOICES.index(changes)).read_text(encoding="utf-8")

    def test_are_cases_that_the_program_accepts(self):
        for k, changes in enumerate(CHOICES):
            with self.subTest(changes):
                done = subprocess.run([PROGRAM, "check", "case.toml"], cwd=self.case(k).parent, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_are_drilled_in_their_folder(self):
        for changes in (OWN, {**OWN, "drive": "weight"}, {"bit": "r", "drive": "weight"}):
            with self.subTest(changes):
                folder = self.case(CHOICES.index(changes)).parent
                subprocess.run([PROGRAM, "run", "case.toml", "-o", "result", "--quiet"], cwd=folder, check=True, capture_output=True)
                summary = json.loads((folder / "result/summary.json").read_text(encoding="utf-8"))
                self.assertAlmostEqual(summary["revolutions"], 0.1, delta=0.02)

    def test_contain_what_the_case_names_and_a_readme(self):
        names = zipfile.ZipFile(self.folder / f"{CHOICES.index(OWN)}.zip").namelist()
        self.assertEqual(names, [f"my-layout/{path}" for path in ("README.txt", "bits/my-layout.toml", "bits/my-layout.csv", "case.toml")])
        readme = (self.folder / f"{CHOICES.index(OWN)}/my-layout/README.txt").read_text(encoding="utf-8")
        for words in ("tdbd run case.toml -o result", "- bits/my-layout.csv", "TDBD 0.0, test"):
            self.assertIn(words, readme)
        for words in self.said["assumptions"][CHOICES.index(OWN)]:
            self.assertIn(f"- {words}\n", readme)

    def test_say_which_chamfer_an_own_bit_has(self):
        chamfered, sharp = (self.said["assumptions"][CHOICES.index(c)] for c in (OWN, {**OWN, "chamfer": "0", "law": "thin-cut"}))
        self.assertTrue(any("a chamfer of 0.3 mm at 45 degrees" in words for words in chamfered), chamfered)
        self.assertTrue(any("Cutters are sharp" in words for words in sharp), sharp)

    def test_have_the_law_the_rock_and_the_weight_of_the_form(self):
        self.assertIn('law = "detournay"\neps = "100 MPa"', self.text({"law": "detournay"}))
        self.assertIn('law = "indentation"', self.text({"bit": "r", "drive": "rate"}))
        self.assertIn('material = "texas-granite"', self.text({"rock": "texas-granite"}))
        self.assertRegex(self.text({"bit": "a", "drive": "weight"}), r'kind = "drilling"\n(.*\n)*weight_on_bit = "30 kN"\n(.*\n)*\[string\]')

    def test_are_the_same_bytes_for_the_same_choice(self):
        _, again = made(CHOICES, TABLES)
        self.assertEqual(self.files, again)

    def test_the_form_offers_every_rock_of_the_program(self):
        keys = (ROOT / "src/simulation/case/KEYS.md").read_text(encoding="utf-8")
        known = re.search(r"\| `material` \| one of \| required with forces \| ([^|]*) \|", keys)[1].split(", ")
        self.assertEqual(sorted(known), sorted(ROCKS))
        page = (ROOT / "web/page/case_text.js").read_text(encoding="utf-8")
        self.assertEqual(sorted(re.findall(r'"([a-z-]+)": "', page.split("const ROCKS", 1)[1].split("};", 1)[0])), sorted(ROCKS))

    def test_the_template_explains_every_required_column(self):
        lines = self.files["template.csv"].decode().splitlines()
        comments, [heads, *rows] = [l for l in lines if l.startswith("#")], [l for l in lines if not l.startswith("#")]
        for column in heads.split(","):
            self.assertRegex(" ".join(comments), rf"\b{column}\b")
        self.assertFalse(any(mark in line for line in comments for mark in ",;\""), "a spreadsheet would split a comment into cells")
        self.assertGreater(len(rows), 20)

    def test_reads_the_gage_from_tables_of_any_spreadsheet(self):
        self.assertEqual([gage and round(gage, 9) for gage in self.said["gages"]], [215.9, 215.9, 215.9, None, None])


if __name__ == "__main__":
    if NODE is None:
        print("skipped: there is no node")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
