"""The package where cmake --install puts it: found there, whole, without the build's folder.

    install_test.py TDBD ROOT PACKAGES CMAKE BUILD FOLDER
"""

import json
import os
import subprocess
import sys
import unittest

from common import QUICK, ROOT, FolderTest

CMAKE, BUILD, PLACE = sys.argv[1:4]
del sys.argv[1:4]
DRILL = """
import json, sys, tdbd
r = tdbd.run(tdbd.case(sys.argv[1], set=json.loads(sys.argv[2])))
print(tdbd.__file__, tdbd._core.__file__, r.summary["removed_volume_m3"] > 0)
"""


class Installed(FolderTest):
    def test_drills(self):
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", self.folder / "a", "--component", "python"], check=True,
                       stdout=subprocess.DEVNULL)
        os.rename(self.folder / "a", self.folder / "prefix")  # the package can be moved
        packages = self.folder / "prefix" / PLACE
        self.assertTrue((packages / "tdbd/py.typed").is_file() and (packages / "tdbd/_core.pyi").is_file())
        self.assertFalse([file for file in (packages / "tdbd").iterdir() if file.is_symlink()])
        shipped = sorted(file.name for file in (ROOT / "python/tdbd").iterdir() if file.is_file())
        self.assertEqual(sorted(file.name for file in (packages / "tdbd").iterdir() if not file.name.endswith(".so")), shipped)
        done = subprocess.run([sys.executable, "-B", "-c", DRILL, ROOT / "cases/bit-b-steady.toml", json.dumps(QUICK)], text=True,
                              capture_output=True, check=False, cwd=self.folder, env=os.environ | {"PYTHONPATH": str(packages)})
        self.assertEqual(done.returncode, 0, done.stderr)
        package, module, drilled = done.stdout.split()
        self.assertTrue(package.startswith(str(packages)) and module.startswith(str(packages)), done.stdout)
        self.assertEqual(drilled, "True")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
