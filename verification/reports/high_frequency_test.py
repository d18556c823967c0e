"""high_frequency_test.py TDBD ROOT BUILD: the claim chapter6/high-frequency, on short runs of its two cases.

Weight and torque at 1000 Hz keep their spectrum at 512 Hz, and their lines are where case and bit say. The
measures are those of figure 6.7's counterpart: reports/figures/signals.py.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

from evidence_file import Recorder

TDBD, ROOT, BUILD = map(pathlib.Path, sys.argv[1:])
sys.path.insert(0, str(ROOT / "reports"))
from figures import results, signals  # noqa: E402

CLAIM = "chapter6/high-frequency"
RATE, UP, DOWN = 1000.0, 64, 125
START_UP = 1.0  # s, two turns
RUNS = {"high-frequency": "5 s", "high-frequency-beds": "7 s"}
WORDS = {"high-frequency": "homogeneous rock", "high-frequency-beds": "dipping beds"}
LOADS = {"weight_on_bit": "weight", "torque_on_bit": "torque"}


def drilled(folder, case):
    subprocess.run([TDBD, "run", ROOT / f"cases/{case}.toml", "-o", folder / case, "--quiet",
                    "--set", "rock.edge_length=2 mm", "--set", f"time.duration={RUNS[case]}",
                    "--set", f"output.means_from={START_UP} s"], check=True)
    return folder / case


def nearest(lines, expected):
    """Lines of nearly equal strength change places with the smallest forces."""
    return min((frequency for frequency, _ in lines), key=lambda f: abs(f - expected))


class HighFrequency(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.folders = {case: drilled(pathlib.Path(cls.made.name), case) for case in RUNS}
        cls.lines = {case: signals.lines_of_run(folder) for case, folder in cls.folders.items()}

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def samples(self, case, name):
        time, values = results.history(self.folders[case], "time", name)
        self.assertAlmostEqual(time[1] - time[0], 1.0 / RATE)
        return values[time > START_UP]

    def recorder(self):
        return Recorder(BUILD, TDBD, f"HighFrequency.{self.id().split('.')[-1].removeprefix('test_')}")

    def test_a_laboratory_s_rate_keeps_the_spectrum(self):
        """Without the low pass, maintenance of the mesh folds into an empty band."""
        for case, rock in WORDS.items():
            for name, load in LOADS.items():
                x = self.samples(case, name)
                off = {way: np.abs(signals.ratios(make(x, UP, DOWN), RATE * UP / DOWN, x, RATE)[1] - 1.0).max()
                       for way, make in (("filtered", signals.resampled), ("naive", signals.interpolated))}
                self.assertTrue(self.recorder().bound(
                    CLAIM, f"{rock}: density of the {load} at 512 Hz over that at 1000 Hz, 2 to 220 Hz, farthest from 1",
                    off["filtered"], "1", 3e-4))
                self.assertTrue(self.recorder().record(
                    CLAIM, f"{rock}: the same of the {load} without a low pass, which must be seen", off["naive"], "1",
                    "more than 0.3", off["naive"] > 0.3))

    def test_homogeneous_rock_shows_the_blades_and_little_else(self):
        lines = self.lines["high-frequency"]
        for name, load in LOADS.items():
            x = self.samples("high-frequency", name)
            self.assertTrue(self.recorder().near(
                CLAIM, f"homogeneous rock: nearest of the eight strongest lines of the {load} over blades times rotation",
                nearest(signals.strongest(x, RATE, 8), lines.blades) / lines.blades, 1.0, 0.015))
            self.assertTrue(self.recorder().bound(
                CLAIM, f"homogeneous rock: rms of the {load} over its mean", x.std() / x.mean(), "1", 0.009))

    def test_dipping_beds_shake_the_bit(self):
        for name, load in LOADS.items():
            x, calm = self.samples("high-frequency-beds", name), self.samples("high-frequency", name)
            self.assertTrue(self.recorder().near(
                CLAIM, f"dipping beds: rms of the {load} over its mean", x.std() / x.mean(), 0.02, 0.01))
            ratio = (x.std() / x.mean()) / (calm.std() / calm.mean())
            self.assertTrue(self.recorder().record(
                CLAIM, f"dipping beds: that over the same in homogeneous rock, {load}", ratio, "1", "more than 2", ratio > 2.0))

    def test_lines_of_dipping_beds_are_where_rotation_and_advance_put_them(self):
        """Lines of the transform are 1/6 Hz apart; the parabola between them finds what stands alone to a tenth of that."""
        lines = self.lines["high-frequency-beds"]
        comb = signals.bedding_comb(lines, up_to=60.0)
        for name, load in LOADS.items():
            found = signals.strongest(self.samples("high-frequency-beds", name), RATE, 10)
            away = [np.abs(comb - frequency).min() for frequency, _ in found]
            self.assertTrue(self.recorder().bound(
                CLAIM, f"dipping beds: ten strongest lines of the {load}, farthest from |k f +- m b|: f turns and b pairs of beds "
                "in a second, k whole, m 1 or 3, so four lines in 2 Hz", max(away), "Hz", 0.03))
            expected = lines.blades - lines.beds
            self.assertTrue(self.recorder().near(
                CLAIM, f"dipping beds: nearest of the six strongest lines of the {load} over blades times f less b",
                nearest(found[:6], expected) / expected, 1.0, 0.0025))

    def test_dipping_beds_excite_the_shaft(self):
        lines = self.lines["high-frequency-beds"]
        frequency, _ = signals.strongest(self.samples("high-frequency-beds", "rotary_speed"), RATE, 1)[0]
        self.assertTrue(self.recorder().near(
            CLAIM, "dipping beds: strongest line of the rotary speed over the torsional frequency of shaft and mass",
            frequency / lines.torsion, 1.0, 0.15))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
