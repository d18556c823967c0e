"""One version everywhere: that of project() in CMakeLists.txt.

    version_test.py BUILD VERSION

Program, manual page, Python package, CMake package, Debian package and documentation follow from it. CITATION.cff, codemeta.json
and .zenodo.json repeat it; the changelog has a section for it.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD, VERSION = Path(sys.argv[1]), sys.argv[2]
del sys.argv[1:]


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def output(*words, **options):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=True, **options).stdout


class Version(unittest.TestCase):
    def test_is_semantic(self):
        self.assertRegex(VERSION, r"^\d+\.\d+\.\d+$")
        self.assertIn(f"project(TDBD VERSION {VERSION} ", read("CMakeLists.txt"))

    def test_of_the_program(self):
        self.assertEqual(output(BUILD / "tdbd", "--version").split("\n")[0], f"tdbd {VERSION}")
        self.assertIn(f'"tdbd {VERSION}"', output(BUILD / "tdbd", "help", "--man"))

    def test_of_the_python_package(self):
        if not list((BUILD / "python/tdbd").glob("_core.*.so")):
            self.skipTest("the Python module is not built")
        found = output(sys.executable, "-B", "-c", "import tdbd; print(tdbd.__version__)", env=os.environ | {"PYTHONPATH": str(BUILD / "python")})
        self.assertEqual(found.strip(), VERSION)

    def test_of_cmake_and_debian_packages(self):
        self.assertIn(f'set(PACKAGE_VERSION "{VERSION}")', (BUILD / "tdbdConfigVersion.cmake").read_text(encoding="utf-8"))
        self.assertIn(f'set(CPACK_PACKAGE_VERSION "{VERSION}")', (BUILD / "CPackConfig.cmake").read_text(encoding="utf-8"))

    def test_of_the_documentation(self):
        line = next(line for line in read("docs/conf.py").split("\n") if line.startswith("version = release"))
        names = {"re": re, "ROOT": ROOT}
        exec(line, names)
        self.assertEqual(names["release"], VERSION)

    def test_of_the_source_archive(self):
        script = next(line for line in read("scripts/package").split("\n") if line.startswith("version="))
        self.assertEqual(output("bash", "-c", f"{script}; echo $version", cwd=ROOT).strip(), VERSION)

    def test_in_metadata(self):
        self.assertEqual(re.search(r"(?m)^version: (.*)$", read("CITATION.cff")).group(1).strip('"'), VERSION)
        for name in ("codemeta.json", ".zenodo.json"):
            if (ROOT / name).is_file():
                self.assertEqual(json.loads(read(name)).get("version"), VERSION, name)

    def test_in_the_changelog(self):
        headings = re.findall(r"(?m)^## (.*)$", read("CHANGELOG.md"))
        self.assertEqual(headings[0], "Unreleased")
        self.assertRegex(headings[1], rf"^{re.escape(VERSION)} - \d{{4}}-\d\d-\d\d$")

    def test_of_the_commit_in_an_archive(self):
        """cmake/commit.txt has the commit in a source archive, and no commit in a clone."""
        self.assertEqual(read("cmake/commit.txt"), "$Format:%H$\n")
        self.assertIn("cmake/commit.txt export-subst", read(".gitattributes"))
        if not (ROOT / ".git").exists():
            self.skipTest("these sources are no clone")
        with tempfile.TemporaryDirectory() as work:
            archive = subprocess.run(["git", "archive", "HEAD", "cmake"], cwd=ROOT, capture_output=True, check=True).stdout
            subprocess.run(["tar", "-x", "-C", work], input=archive, check=True)
            found = (Path(work) / "cmake/commit.txt").read_text(encoding="utf-8").strip()
        self.assertEqual(found, output("git", "rev-parse", "HEAD", cwd=ROOT).strip())


if __name__ == "__main__":
    unittest.main()
