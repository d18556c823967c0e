"""sweep_test.py TDBD ROOT: what is drawn of a sweep is in its table, and shares of variance are what they must be."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

TDBD, ROOT = (pathlib.Path(word).resolve() for word in sys.argv[1:])
sys.path[:0] = [str(ROOT / "reports"), str(ROOT / "verification/sweep/app")]
import sweep  # noqa: E402
from small_sweeps import tops  # noqa: E402

FIGURES = ("steps", "energy_drift_max")
DESIGN = tops(20, ("time.step", "values = [0.005, 0.01, 0.02]"), ("integrator.drift", 'values = ["lie-mean", "lie-midpoint"]'),
              title="tops", figures=FIGURES, goals=FIGURES)


def column(values, words=()):
    return sweep.Column("x", "x", np.array(values, float), list(words))


class MainEffects(unittest.TestCase):
    def test_of_a_sum_are_its_terms(self):
        """y = 3 a + b over a full design: shares 9 and 1 of the variances, the means are the terms about the mean."""
        a, b = (np.ravel(m) for m in np.meshgrid([0.0, 1.0, 2.0, 3.0], [-1.0, 0.0, 5.0], indexing="ij"))
        y = column(3.0 * a + b)
        places, means, share_a = sweep.main_effect(column(a), y)
        np.testing.assert_allclose(means, 3.0 * np.array(places) + b.mean(), rtol=1e-15)
        share_b = sweep.main_effect(column(b), y)[2]
        self.assertAlmostEqual(share_a, 9.0 * a.var() / (9.0 * a.var() + b.var()), places=14)
        self.assertAlmostEqual(share_a + share_b, 1.0, places=14)

    def test_of_a_sampled_factor_are_those_of_equal_shares(self):
        x = np.random.default_rng(1).permutation(np.linspace(0.0, 1.0, 800))
        places, means, share = sweep.main_effect(column(x), column(x))
        np.testing.assert_allclose(places, (np.arange(8) + 0.5) / 8, atol=1e-3)
        np.testing.assert_allclose(means, places)
        self.assertAlmostEqual(share, 1.0 - 1.0 / 64.0, places=3)  # what is left varies inside an eighth

    def test_of_a_constant_and_of_no_number(self):
        self.assertEqual(sweep.main_effect(column([1, 2]), column([5, 5]))[2], 0.0)
        self.assertEqual(sweep.main_effect(column([1, 2]), column([np.nan, np.nan]))[:2], ([], []))


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.made.name)
        (cls.folder / "tops.toml").write_text(DESIGN)
        cls.table = cls.folder / "tops.nc"
        subprocess.run([TDBD, "sweep", cls.folder / "tops.toml", "-o", cls.table, "--quiet"], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def test_effects_show_every_point(self):
        table = sweep.read_table(self.table)
        self.assertEqual(table.factors[1].words, ["lie-mean", "lie-midpoint"])
        figure = sweep.effects(table)
        axes = figure.axes[0]
        np.testing.assert_array_equal(axes.get_lines()[0].get_ydata(), [4000, 4000, 2000, 2000, 1000, 1000])
        np.testing.assert_array_equal(axes.get_lines()[1].get_ydata(), [4000, 2000, 1000])
        self.assertEqual([t.get_text() for t in axes.texts], ["100 %"])
        self.assertEqual([t.get_text() for t in figure.axes[1].texts], ["0 %"])

    def test_parallel_coordinates_have_a_line_for_each_point_and_thick_ones_for_the_front(self):
        table = sweep.read_table(self.table)
        [axes] = sweep.parallel(table).axes
        lines = axes.get_lines()[:6]
        self.assertEqual(sum(line.get_linewidth() > 1.0 for line in lines), int(table.front.sum()))
        self.assertGreater(int(table.front.sum()), 1)
        self.assertIn("6 points", axes.get_title())

    def test_the_same_table_gives_the_same_bytes(self):
        made = []
        for name in ("a", "b"):
            subprocess.run([ROOT / "reports/sweep.py", self.table, "-o", self.folder / name], check=True, stdout=subprocess.DEVNULL)
            made.append([p.read_bytes() for p in sorted((self.folder / name).glob("*.svg"))])
        self.assertEqual(len(made[0]), 2)
        self.assertEqual(*made)

    def test_what_is_no_table_is_named(self):
        for text in (b"no", None):
            wrong = self.folder / "wrong.nc"
            wrong.write_bytes(text) if text else wrong.unlink()
            done = subprocess.run([ROOT / "reports/sweep.py", wrong], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn("wrong.nc: found no table of a sweep", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
