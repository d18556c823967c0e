"""completion_test.py TDBD: what bash offers behind `tdbd` once it has loaded what `tdbd help --completion` prints."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

TDBD = sys.argv[1]
ASK = r"""
set -u
source ./completion
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_tdbd
for word in "${COMPREPLY[@]}"; do printf '%s\n' "$word"; done
"""


def tdbd(*words):
    return subprocess.run([TDBD, *words], check=True, capture_output=True, text=True).stdout


class Completion(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.folder = pathlib.Path(made.name)
        (cls.folder / "completion").write_text(tdbd("help", "--completion"))
        for name in ("first.toml", "my case.toml", "bit.stl", "bit.ply", "table.nc", "notes.txt"):
            (cls.folder / name).touch()
        (cls.folder / "results").mkdir()

    def offers(self, *words):
        """Returns the completions of the last word, sorted."""
        done = subprocess.run(["bash", "-c", ASK, "bash", "tdbd", *words], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return sorted(done.stdout.splitlines())

    def test_of_commands(self):
        self.assertEqual(self.offers("r"), ["report", "rotate", "run"])
        self.assertEqual(self.offers("--v"), ["--version"])
        listed = re.findall(r"^(\w+) +[A-Z]", tdbd("help"), re.MULTILINE)
        self.assertEqual(self.offers(""), sorted([*listed, "help", "--help", "--version"]))
        self.assertEqual(self.offers("help", "co"), ["compare", "converge"])

    def test_of_options_is_all_that_help_lists(self):
        self.assertIn("--resume", self.offers("run", "--"))
        for command in set(self.offers("")) - {"help", "--help", "--version"}:
            listed = re.findall(r"^  (?:-\w,)?(--[\w-]+)", tdbd(command, "--help"), re.MULTILINE)
            self.assertEqual(self.offers(command, "--"), sorted(set(listed)), command)
            self.assertEqual(self.offers(command, "first.toml", "--"), sorted(set(listed)), command)

    def test_of_files_is_by_what_the_command_reads(self):
        for command in ("run", "rotate", "check", "sweep", "calibrate", "converge", "bit", "laboratory"):
            self.assertEqual(self.offers(command, ""), ["first.toml", "my case.toml", "results"], command)
        self.assertEqual(self.offers("run", "f"), ["first.toml"])
        self.assertEqual(self.offers("run", "my"), ["my case.toml"])
        self.assertEqual(self.offers("mesh", ""), ["bit.ply", "bit.stl", "results"])
        self.assertEqual(self.offers("run", "--quiet", ""), ["first.toml", "my case.toml", "results"])

    def test_of_values_is_by_the_option(self):
        self.assertEqual(self.offers("run", "first.toml", "-o", ""), ["results"])
        self.assertEqual(self.offers("run", "--resume", ""), ["results"])
        self.assertEqual(self.offers("sweep", "first.toml", "--output", ""), ["results", "table.nc"])
        self.assertEqual(self.offers("bit", "--format", ""), ["obj", "off", "ply", "stl"])
        self.assertEqual(self.offers("bit", "--format", "o"), ["obj", "off"])

    def test_offers_nothing_for_free_text(self):
        self.assertEqual(self.offers("run", "--threads", ""), [])
        self.assertEqual(self.offers("run", "first.toml", "--set", ""), [])
        self.assertEqual(self.offers("run", "first.toml", "--set", "time.step", "="), [])
        self.assertEqual(self.offers("run", "first.toml", "--set", "time.step", "=", "f"), [])
        self.assertEqual(self.offers("nonsense", ""), [])

    def test_of_places_one_after_another(self):
        self.assertEqual(self.offers("new", "c"), ["calibration", "cones"])
        self.assertEqual(self.offers("new", "cones", ""), ["results"])

    def test_is_loaded_for_tdbd(self):
        done = subprocess.run(["bash", "-c", "source ./completion; complete -p tdbd"], cwd=self.folder, capture_output=True, text=True,
                              check=True)
        self.assertEqual(done.stdout, "complete -F _tdbd tdbd\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
