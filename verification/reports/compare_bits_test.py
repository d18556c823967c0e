"""compare_bits_test.py TDBD ROOT: the page of two bits has their numbers, and those of two runs."""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

TDBD, ROOT = map(pathlib.Path, sys.argv[1:])
sys.path.insert(0, str(ROOT / "reports"))
import balance  # noqa: E402
import compare_bits  # noqa: E402
import compared_bits  # noqa: E402

BITS = [ROOT / "cases/bits/bit-a.toml", ROOT / "cases/bits/bit-b.toml"]
OPERATION = compared_bits.Operation(0.005, 4.0 * math.pi, 60e6)
DRILL = ("--set", "rock.edge_length=6 mm", "--set", "time.step=5 ms", "--set", "time.revolutions=0.3", "--set", "output.means_from=0.1 s")
ROUNDING = 1e-12


class TwoBits(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.folder = pathlib.Path(made.name)
        for bit in "ab":
            subprocess.run([TDBD, "run", ROOT / f"cases/bit-{bit}-6000psi.toml", "-o", cls.folder / bit, *DRILL, "--quiet"], check=True)

    def page(self, *paths, code=0):
        page = self.folder / "page.html"
        page.unlink(missing_ok=True)
        done = subprocess.run([sys.executable, "-B", ROOT / "reports/compare_bits.py", *paths, "-o", page, "--program", TDBD],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(page.exists(), code == 0)
        if code:
            return done.stderr
        self.assertLess(done.stdout.count("\n"), 60)
        text = page.read_text(encoding="utf-8")
        balance.check(text)
        self.assertIsNone(re.search(r">\s*(nan|None|inf)\s*<", text))
        return text

    def test_the_estimate_is_the_cut_area_times_stresses(self):
        side = compared_bits.of_bit(BITS[1], self.folder / "analysis", TDBD, OPERATION)
        analysis = json.loads((self.folder / "analysis/analysis.json").read_text())
        area = np.array([c["area_m2"] for c in analysis["cutters"]])
        np.testing.assert_allclose(side.drag, 60e6 * area, rtol=ROUNDING)
        np.testing.assert_allclose(side.power, side.drag * side.radius * OPERATION.speed, rtol=ROUNDING)
        rate = OPERATION.penetration * OPERATION.speed / (2.0 * math.pi)
        self.assertAlmostEqual(side.sums["drilling power kW"],
                               side.sums["torque on bit kN m"] * OPERATION.speed + side.sums["weight on bit kN"] * rate, delta=1e-9)
        # The normal forces are in proportion to those of the unit law, whose sum is over pushes instead of the weight.
        unit = -np.array(analysis["imbalance_vector_of_unit_law"][:2])
        across = side.pushes["the normal forces"][0] * unit[1] - side.pushes["the normal forces"][1] * unit[0]
        self.assertAlmostEqual(across, 0.0, delta=1e-12)
        self.assertGreater(side.pushes["the normal forces"] @ unit, 0.0)
        np.testing.assert_allclose(side.pushes["the normal forces"] + side.pushes["the drag"], side.pushes["both"], atol=1e-15)

    def test_the_page_of_two_bit_files(self):
        text = self.page(*BITS)
        for title in ("The bits", "Profiles", "Forces of the cutters", "Work rates", "Lateral forces"):
            self.assertIn(f"<h2>{title}</h2>", text)
        self.assertIn("<th scope=\"row\">cutters</th><td>36</td><td>28</td><td>-8</td><td>-22.2 %</td>", text)
        self.assertIn("Forces are an estimate for steady drilling at 5 mm a revolution and 120 rpm in rock of 60 MPa", text)
        self.assertEqual(text, self.page(*BITS))

    def test_a_bit_does_not_differ_from_itself(self):
        sides = compare_bits.read_sides([BITS[0], BITS[0]], TDBD, OPERATION, self.folder / "twice")
        self.assertEqual([side.name for side in sides], ["A: bit-a", "B: bit-a"])
        self.assertEqual({row[3] for row in compare_bits.differences(sides)}, {"0"})

    def test_a_bit_does_not_differ_from_its_export(self):
        out = self.folder / "export"
        subprocess.run([TDBD, "bit", BITS[1], "-o", out, "--quiet"], check=True)
        for name in ("bit.toml", "solids.toml"):
            sides = compare_bits.read_sides([BITS[1], out / name], TDBD, OPERATION, self.folder / f"compare-{name}")
            self.assertIn("junk slots mm²", sides[1].sums)
            self.assertEqual(sides[1].sums["blades"], 5)
            self.assertEqual({row[3] for row in compare_bits.differences(sides)}, {"0"}, compare_bits.differences(sides))

    def test_the_page_of_two_runs_has_their_loads(self):
        text = self.page(self.folder / "a", self.folder / "b")
        weights = [json.loads((self.folder / bit / "summary.json").read_text())["wob_mean_n"] for bit in "ab"]
        self.assertIn("".join(f"<td>{1e-3 * w:.4g}</td>" for w in weights), text)
        self.assertIn("Forces are the means of two runs.", text)

    def test_runs_without_forces_and_bits_without_cutters(self):
        free = self.folder / "free"
        subprocess.run([TDBD, "run", ROOT / "cases/bit-b-steady.toml", "-o", free, *DRILL[:6], "--quiet"], check=True)
        self.assertEqual(self.page(free, self.folder / "a", code=2),
                         f"compare: {free}: found a run without forces, expected one whose case has a table [forces]\n")
        cones = ROOT / "cases/bits/bit-r.toml"
        self.assertEqual(self.page(cones, BITS[0], code=2), f"compare: {cones}: found a bit without cutters, expected a PDC bit; of roller "
                                                            "cone bits compare two results of tdbd run\n")
        bad = self.folder / "bad.toml"
        bad.write_text("name = 'bad'\n[cutters]\nchamfr = 1\n", encoding="utf-8")
        self.assertRegex(self.page(bad, BITS[0], code=2), r"^compare: .*bad\.toml:")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
