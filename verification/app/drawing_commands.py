#!/usr/bin/python3
"""drawing_commands.py TDBD ROOT: `tdbd draw`, `page`, `report` and `compare` find their scripts, and reject what they cannot draw."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

TDBD, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
TOP, DRILL, BIT_A, BIT_B = (ROOT / "cases" / name for name in ("slow-top.toml", "bit-b-steady.toml", "bits/bit-a.toml", "bits/bit-b.toml"))
RESULT = ("expected a result folder of tdbd run, rotate, string, converge, calibrate, curve or tdbd bit BIT -o FOLDER --report, or the table "
          "NAME.nc of tdbd sweep")


def call(program, *words, **environment):
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False, env=os.environ | environment)
    return done.returncode, done.stdout, done.stderr


class DrawingCommands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.folder = pathlib.Path(made.name).resolve()
        cls.top = cls.folder / "top"
        assert call(TDBD, "rotate", TOP, "-o", cls.top, "--set", "time.duration=0.2 s", "--quiet") == (0, "", "")

    def expect_rejected(self, words, message):
        self.assertEqual(call(TDBD, *words), (2, "", message + "\n"), words)

    def test_draw_prints_the_name_of_each_picture(self):
        code, out, _ = call(TDBD, "draw", self.top, "-o", self.folder / "pictures")
        self.assertEqual(code, 0)
        self.assertEqual([pathlib.Path(line).name for line in out.splitlines()], ["motion.png", "path.png", "conservation.png"])
        self.assertTrue(all(pathlib.Path(line).stat().st_size > 5000 for line in out.splitlines()))

    def test_paths_that_are_no_result(self):
        empty = self.folder / "empty"
        empty.mkdir()
        nothing = "found nothing, expected a result folder or a table NAME.nc"
        self.expect_rejected(("draw", self.folder / "none"), f"tdbd: {self.folder}/none: {nothing}")
        self.expect_rejected(("page", self.folder / "none"), f"tdbd: {self.folder}/none: {nothing}")
        self.expect_rejected(("draw", empty), f"draw: {empty}: found no result, {RESULT}")
        self.expect_rejected(("report", empty), f"report: {empty}: found no result, {RESULT}")
        self.expect_rejected(("draw", DRILL), f"draw: {DRILL}: found an input file (TOML), {RESULT}")
        self.expect_rejected(("draw", self.top / "summary.json"),
                             f"draw: {self.top}/summary.json: found a file of a result, expected its folder: {self.top}")
        self.expect_rejected(("draw", self.folder), f"draw: {self.folder}: found no result (results are in its folders top), {RESULT}")
        (empty / "checkpoint.bin").touch()
        self.expect_rejected(("report", empty), f"report: {empty}: found a run that is not complete; to resume it: tdbd run --resume {empty}, "
                                                f"{RESULT}")

    def test_results_of_another_kind(self):
        self.expect_rejected(("draw", self.top, "--gif", self.folder / "a.gif"),
                             f"draw: {self.top}: found a rotation (tdbd rotate), expected a run (tdbd run)")
        self.assertFalse((self.folder / "a.gif").exists())
        analysed = self.folder / "bit"
        assert call(TDBD, "bit", BIT_B, "-o", analysed, "--report", "--quiet")[0] == 0
        self.expect_rejected(("draw", analysed), f"draw: {analysed}: found the analysis of a bit (tdbd bit --report), of which there are no "
                                                 "pictures; tdbd report FOLDER makes its page")
        self.expect_rejected(("draw", self.top, analysed),
                             f"draw: {analysed}: found the analysis of a bit (tdbd bit --report), expected several rotations or several "
                             "convergence studies of rotations (one work-precision diagram), or one result")

    def test_bits_that_cannot_be_compared(self):
        page = self.folder / "no.html"
        self.expect_rejected(("compare", BIT_A, DRILL, "-o", page),
                             f"tdbd: {DRILL}: found a case to drill, with a table [motion], expected a bit; try: tdbd run {DRILL}")
        self.expect_rejected(("compare", BIT_A, self.top, "-o", page),
                             f"compare: found a bit file ({BIT_A}) and a folder ({self.top}), expected two bit files or two result folders of "
                             "tdbd run")
        self.expect_rejected(("compare", self.top, self.top, "-o", page),
                             f"compare: {self.top}: found a rotation (tdbd rotate), expected a run (tdbd run)")
        self.expect_rejected(("compare", BIT_A, BIT_B, "--penetration", "5", "-o", page),
                             "tdbd: --penetration: found '5', expected a length > 0 with its unit")
        self.assertFalse(page.exists())

    def test_without_python_the_message_names_the_variable(self):
        code, out, err = call(TDBD, "draw", self.top, TDBD_PYTHON="/no/python")
        self.assertEqual((code, out), (2, ""))
        self.assertRegex(err, r"^tdbd: /no/python: found no Python that starts \(No such file or directory\), expected Python 3 with numpy.*"
                              r"TDBD_PYTHON names another Python\n$")

    def test_installed_and_alone(self):
        """An installation has the scripts in share/tdbd/reports beside bin; a copied program has none."""
        program = self.folder / "prefix/bin/tdbd"
        program.parent.mkdir(parents=True)
        shutil.copy(TDBD, program)
        code, out, err = call(program, "draw", self.top)
        self.assertEqual((code, out), (2, ""))
        self.assertIn(f"found no script draw.py, expected it in {self.folder}/prefix/share/tdbd/reports or ", err)
        (self.folder / "prefix/share/tdbd").mkdir(parents=True)
        (self.folder / "prefix/share/tdbd/reports").symlink_to(ROOT / "reports")
        code, out, err = call(program, "draw", self.top, "-o", self.folder / "installed")
        self.assertEqual((code, out.count("\n")), (0, 3), err)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
