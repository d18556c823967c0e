"""bit_counts_test.py PROGRAM ROOT: pages count the cutters and teeth of the shipped bits as the program does."""

import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, ROOT = map(pathlib.Path, sys.argv[1:3])
sys.path.insert(0, str(ROOT / "reports"))
from stated import pattern_of  # noqa: E402

BITS = ["bit-a", "bit-b", "bit-c", "bit-r", "bit-m", "generated", "standard"]
PAGES = ["README.md", "benchmarks/measured.json", "benchmarks/README.md", "cases/README.md", "cases/bits/README.md",
         "reports/manifest.toml", *sorted(str(f.relative_to(ROOT)) for f in (ROOT / "reports/studies").glob("*/README.md"))]
# Where a page counts: the text, with a place for each number, and what it counts.
COUNTS = [
    ("README.md", "8.5 in PDC bit of {} cutters", ("bit-b", "cutters")),
    ("benchmarks/measured.json", "laid out and meshed: {} cones, {} teeth", ("bit-r", "cones"), ("bit-r", "teeth")),
    ("benchmarks/measured.json", "a PDC design of {} cutters", ("generated", "cutters")),
    ("benchmarks/measured.json", "sections ahead of {} faces", ("standard", "cutters")),
    ("benchmarks/README.md", "laid out and meshed: {} cones, {} teeth", ("bit-r", "cones"), ("bit-r", "teeth")),
    ("benchmarks/README.md", "a PDC design of {} cutters", ("generated", "cutters")),
    ("benchmarks/README.md", "sections ahead of {} faces", ("standard", "cutters")),
    ("benchmarks/README.md", "`cases/standard-workload.toml`: {} sharp discs", ("standard", "cutters")),
    ("cases/bits/README.md", "| `bit-a.csv` | 8.5 in | {} | {} of", ("bit-a", "blades"), ("bit-a", "cutters")),
    ("cases/bits/README.md", "| `bit-b.csv` | 8.5 in | {} | {} of", ("bit-b", "blades"), ("bit-b", "cutters")),
    ("cases/bits/README.md", "| `bit-c.csv` | 8.5 in | {} | {} of", ("bit-c", "blades"), ("bit-c", "cutters")),
    ("cases/bits/README.md", "lays out {} cutters of 13.44 mm on {} blades, {} of them back-ups",
     ("generated", "cutters"), ("generated", "blades"), ("generated", "back-ups")),
    ("cases/bits/README.md", "no real bit: {} discs", ("standard", "cutters")),
    ("cases/bits/README.md", "{} rows, {} inserts", ("bit-r", "rows"), ("bit-r", "teeth")),
    ("cases/bits/README.md", "{} rows, {} teeth on three cones", ("bit-m", "rows"), ("bit-m", "teeth")),
    ("reports/manifest.toml", "{} blades with {} cutters of 16 mm", ("bit-a", "blades"), ("bit-a", "cutters")),
    ("reports/manifest.toml", "{} blades with {} cutters of 19 mm", ("bit-b", "blades"), ("bit-b", "cutters")),
    ("reports/manifest.toml", "{} blades with {} cutters of 13.44 mm", ("bit-c", "blades"), ("bit-c", "cutters")),
    ("reports/manifest.toml", "lays out {} cutters on {} blades, {} of them back-up cutters",
     ("generated", "cutters"), ("generated", "blades"), ("generated", "back-ups")),
    ("reports/studies/rolling-bit-r/README.md", "Bit R, {} inserts", ("bit-r", "teeth")),
    ("reports/studies/steady-bit-b/README.md", "(8.5 in, {} cutters)", ("bit-b", "cutters")),
]
COUNTING = re.compile(r"\b\d+ (?:cutters|teeth|inserts|discs|blades)\b")


def backups(folder):
    with (folder / "cutters.csv").open(newline="", encoding="utf-8") as file:
        return sum(float(row["under_exposure_mm"]) > 0.0 for row in csv.DictReader(file))


def counts_of(bit, folder):
    """{what: how many} of a shipped bit, as the program builds it."""
    subprocess.run([PROGRAM, "bit", ROOT / f"cases/bits/{bit}.toml", "-o", folder, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    told = json.loads((folder / "bit.json").read_text(encoding="utf-8"))
    cutters, cones = told["cutters"], told.get("cones", [])
    rows = [row for cone in cones for row in cone["rows"]]
    return {"cutters": len(cutters), "blades": len({c["blade"] for c in cutters}), "back-ups": backups(folder) if cutters else 0,
            "cones": len(cones), "rows": len(rows), "teeth": sum(row["teeth"] for row in rows)}


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.counts = {bit: counts_of(bit, pathlib.Path(folder) / bit) for bit in BITS}

    def test_count_as_the_program_does(self):
        for page, phrase, *counted in COUNTS:
            with self.subTest(page, phrase=phrase):
                found = list(pattern_of(phrase).finditer((ROOT / page).read_text(encoding="utf-8")))
                self.assertEqual(len(found), 1)
                self.assertEqual([int(n) for n in found[0].groups()], [self.counts[bit][what] for bit, what in counted])

    def test_count_nothing_unasked(self):
        for page in PAGES:
            text = (ROOT / page).read_text(encoding="utf-8")
            known = [m.span() for p, phrase, *_ in COUNTS if p == page for m in pattern_of(phrase).finditer(text)]
            unasked = [m.group() for m in COUNTING.finditer(text) if not any(a <= m.start() < b for a, b in known)]
            self.assertEqual(unasked, [], f"{page}: add to COUNTS")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
