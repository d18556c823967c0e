"""What the tests of the Python package share: SCRIPT PROGRAM ROOT PACKAGES, small cases, the command line beside it."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, ROOT, PACKAGES = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
del sys.argv[1:4]
sys.path.insert(0, str(PACKAGES))

DRILLING = ROOT / "cases/bit-b-steady.toml"
DRIVEN = ROOT / "cases/drill-bit-b.toml"  # forces move this bit
CONES = ROOT / "cases/bit-r-rolling.toml"
TOP = ROOT / "cases/slow-top.toml"
BIT = ROOT / "cases/bits/bit-b.toml"
COARSE = {"rock.edge_length": "8 mm", "time.step": "5 ms"}
QUICK = COARSE | {"time.revolutions": 0.2}  # 20 steps
LONG = COARSE | {"time.revolutions": 10_000}  # longer than any test waits


def words(settings):
    """--set of a dictionary."""
    return [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]


def command(*arguments):
    """The command line with these words."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)


class FolderTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = pathlib.Path(made.name)

    def demand_one_commit(self):
        """Summaries contain the commit, so results differ if only one of the two was rebuilt."""
        import tdbd
        self.assertIn(f"commit {tdbd.provenance['commit']}\n", command("--version").stdout, "build program and module both")

    def same_files(self, one, other, but=("timing.json",)):
        """Both folders contain the same files, bitwise identical."""
        names = lambda folder: sorted(str(f.relative_to(folder)) for f in folder.rglob("*") if f.is_file())
        self.assertEqual(names(one), names(other))
        for name in names(one):
            if name not in but:
                self.assertEqual((one / name).read_bytes(), (other / name).read_bytes(), name)
        return names(one)
