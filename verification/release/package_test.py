"""scripts/package names what is missing before it makes anything, and packaging/smoke.py rejects packages that are missing or changed.

dpkg-query is replaced by a program that knows all packages but some, so that the test does not depend on this machine.
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Package(unittest.TestCase):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = Path(made.name)

    def run_without(self, missing, *words, script="scripts/package"):
        """Runs the script where the packages `missing` are not installed, with no other program than the shell's own."""
        fake = self.folder / "dpkg-query"
        cases = "|".join(missing) or "none-of-them"
        fake.write_text(f'#!/bin/sh\nfor word; do :; done\ncase "$word" in {cases}) exit 1 ;; *) echo "ii " ;; esac\n', encoding="utf-8")
        fake.chmod(0o755)
        for tool in ("cmake", "cpack", "git", "apt-get", "sudo"):  # nothing may be built or installed
            other = self.folder / tool
            other.write_text(f"#!/bin/sh\necho {tool} was called\nexit 77\n", encoding="utf-8")
            other.chmod(0o755)
        env = os.environ | {"PATH": f"{self.folder}:{os.environ['PATH']}"}
        return subprocess.run(["bash", ROOT / script, *words], capture_output=True, text=True, check=False, env=env)

    def test_names_missing_packages_and_their_purpose(self):
        done = self.run_without(["patchelf", "libcgal-dev"])
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("patchelf (the wheel)\n", done.stderr)
        self.assertIn("libcgal-dev (libraries)\n", done.stderr)
        self.assertIn("bash scripts/setup package\n", done.stderr)
        self.assertNotIn("binutils", done.stderr)

    def test_the_page_needs_its_own_packages(self):
        done = self.run_without(["emscripten"], "page")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("emscripten\n", done.stderr)
        self.assertIn("bash scripts/setup web\n", done.stderr)

    def test_all_packages_go_without_the_page(self):
        done = self.run_without(["emscripten"])
        self.assertIn("no page for browsers, since these Debian packages are missing: emscripten (bash scripts/setup web)", done.stdout)
        self.assertEqual(done.returncode, 77, "the next command is git's")

    def test_setup_installs_the_packages_of_the_list(self):
        done = self.run_without(["patchelf"], "package", script="scripts/setup")
        self.assertIn("packages are missing: patchelf\n", done.stdout)
        self.assertEqual(done.returncode, 77, "apt-get is called")

    def test_rejects_unknown_words(self):
        for words, text in ((["rpm"], 'found "rpm", expected nothing, deb, source, wheel, page, --smoke or --no-build'),
                            (["deb", "--smoke"], "expected --smoke with all packages")):
            done = self.run_without([], *words)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(text, done.stderr)

    def smoke(self):
        return subprocess.run([sys.executable, "-B", ROOT / "packaging/smoke.py", self.folder, "1.2.3"], capture_output=True, text=True, check=False)

    def test_smoke_rejects_missing_or_changed_packages(self):
        done = self.smoke()
        self.assertEqual(done.returncode, 1)
        self.assertIn("found 0 files", done.stderr)
        for name in ("tdbd_1.2.3_amd64.deb", "tdbd-1.2.3-cp311-cp311-linux.whl", "tdbd-1.2.3.tar.gz"):
            (self.folder / name).write_text("a", encoding="utf-8")
        sums = "".join(f"{'0' * 64}  {file.name}\n" for file in self.folder.glob("tdbd*.deb"))
        (self.folder / "SHA256SUMS").write_text(sums, encoding="utf-8")
        done = self.smoke()
        self.assertEqual(done.returncode, 1)
        self.assertIn("tdbd_1.2.3_amd64.deb: FAILED", done.stderr)


if __name__ == "__main__":
    unittest.main()
