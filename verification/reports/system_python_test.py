#!/usr/bin/python3
"""system_python_test.py ROOT: a script that another python starts, one without numpy, is run by Debian's."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop())
BARE = ["/usr/bin/python3", "-S"]  # without site-packages: as a python of one's own


def script(folder, modules):
    path = Path(folder) / "script.py"
    path.write_text(f"import sys\nsys.path.insert(0, {str(ROOT / 'reports')!r})\nimport system_python\n"
                    f"system_python.require({modules})\nprint('ran', sys.argv[1:])\n", encoding="utf-8")
    return path


def call(words, **surroundings):
    return subprocess.run(words, capture_output=True, text=True, check=False, env=os.environ | surroundings)


class SystemPython(unittest.TestCase):
    def test_starts_again_with_the_same_words(self):
        with tempfile.TemporaryDirectory() as folder:
            done = call([*BARE, script(folder, '"numpy"'), "a b", "-o", "c"])
            self.assertEqual((done.returncode, done.stdout), (0, "ran ['a b', '-o', 'c']\n"), done.stderr)

    def test_reports_what_no_python_has(self):
        with tempfile.TemporaryDirectory() as folder:
            done = call([*BARE, script(folder, '"numpy", "no_such_module"')])
            self.assertEqual(done.returncode, 2)
            self.assertIn("found a python without no_such_module", done.stderr)

    def test_every_command_script_checks_its_modules(self):
        for path in sorted((ROOT / "reports").glob("*.py")):
            text = path.read_text(encoding="utf-8")
            if os.access(path, os.X_OK) and ("numpy" in text or "matplotlib" in text or "figures" in text):
                with self.subTest(path.name):
                    self.assertIn("system_python.require(", text)
                    self.assertEqual(call([*BARE, path, "--help"]).returncode, 0)


if __name__ == "__main__":
    unittest.main()
