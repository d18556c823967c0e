"""sweep_test.py TDBD ROOT: pictures of a sweep show the values of its table; shares and coefficients agree with closed forms."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

TDBD, ROOT = (pathlib.Path(word).resolve() for word in sys.argv[1:])
sys.path[:0] = [str(ROOT / "reports"), str(ROOT / "verification/sweep/app")]
import balance  # noqa: E402
import sweep  # noqa: E402
import sweep_table  # noqa: E402
from small_sweeps import tops  # noqa: E402

FIGURES = ("steps", "energy_drift_max")
DESIGN = tops(20, ("time.step", "values = [0.005, 0.01, 0.02]"), ("integrator.drift", 'values = ["lie-mean", "lie-midpoint"]'),
              title="tops", figures=FIGURES, goals=FIGURES)


def column(values, words=()):
    return sweep_table.Column("x", "x", np.array(values, float), list(words))


class MainEffects(unittest.TestCase):
    def test_of_a_sum_are_its_terms(self):
        """y = 3 a + b over a full design: shares 9 and 1 of the variances, the means are the terms about the mean."""
        a, b = (np.ravel(m) for m in np.meshgrid([0.0, 1.0, 2.0, 3.0], [-1.0, 0.0, 5.0], indexing="ij"))
        y = column(3.0 * a + b)
        places, means, share_a = sweep_table.main_effect(column(a), y)
        np.testing.assert_allclose(means, 3.0 * np.array(places) + b.mean(), rtol=1e-15)
        share_b = sweep_table.main_effect(column(b), y)[2]
        self.assertAlmostEqual(share_a, 9.0 * a.var() / (9.0 * a.var() + b.var()), places=14)
        self.assertAlmostEqual(share_a + share_b, 1.0, places=14)

    def test_of_a_sampled_factor_are_those_of_equal_shares(self):
        x = np.random.default_rng(1).permutation(np.linspace(0.0, 1.0, 800))
        places, means, share = sweep_table.main_effect(column(x), column(x))
        np.testing.assert_allclose(places, (np.arange(8) + 0.5) / 8, atol=1e-3)
        np.testing.assert_allclose(means, places)
        self.assertAlmostEqual(share, 1.0 - 1.0 / 64.0, places=3)  # what is left varies inside an eighth

    def test_of_a_constant_and_of_no_number(self):
        self.assertEqual(sweep_table.main_effect(column([1, 2]), column([5, 5]))[2], 0.0)
        self.assertEqual(sweep_table.main_effect(column([1, 2]), column([np.nan, np.nan]))[:2], ([], []))


class Regression(unittest.TestCase):
    def test_of_a_linear_function_has_its_coefficients_and_explains_all(self):
        random = np.random.default_rng(2)
        a, b = random.random(50), random.random(50)
        y = 3.0 * a - 2.0 * b
        coefficients, explained = sweep_table.regression([column(a), column(b)], column(y))
        np.testing.assert_allclose(coefficients, [3.0 * a.std() / y.std(), -2.0 * b.std() / y.std()], rtol=1e-12)
        self.assertAlmostEqual(explained, 1.0, places=14)

    def test_of_a_factor_of_texts_is_the_deviation_of_its_contribution(self):
        level, a = np.repeat([0.0, 1.0, 2.0], 20), np.tile(np.linspace(0.0, 1.0, 20), 3)
        part = np.array([5.0, 1.0, 2.0])[level.astype(int)]
        coefficients, explained = sweep_table.regression([column(level, "xyz"), column(a)], column(part + a))
        np.testing.assert_allclose(coefficients, np.array([part.std(), a.std()]) / (part + a).std(), rtol=1e-12)
        self.assertAlmostEqual(explained, 1.0, places=14)

    def test_of_an_even_function_explains_nothing(self):
        a = np.linspace(-1.0, 1.0, 41)
        coefficients, explained = sweep_table.regression([column(a)], column(a**2))
        self.assertAlmostEqual(coefficients[0], 0.0, places=14)
        self.assertAlmostEqual(explained, 0.0, places=14)

    def test_of_too_few_points_or_of_a_constant_is_no_number(self):
        for x, y in (([1, 2], [3, 4]), ([1, 2, 3, 4], [5, 5, 5, 5])):
            coefficients, explained = sweep_table.regression([column(x)], column(y))
            self.assertTrue(np.isnan(coefficients[0]) and np.isnan(explained))


def grid(*levels, figures=1):
    """A table over all combinations of levels; figure k is the sum of the factors times k + 1."""
    values = [np.ravel(m) for m in np.meshgrid(*levels, indexing="ij")]
    factors = [sweep_table.Column(f"case.factor_{i}", "", v, [], "rpm") for i, v in enumerate(values)]
    made = [sweep_table.Column(f"rop_{k}_m_per_s", "", (k + 1.0) * sum(values), [], "m/s") for k in range(figures)]
    sweep_table.set_labels(factors + made)
    return sweep_table.Table("a title that is far too long for one line of a small picture", factors, made,
                       np.zeros(values[0].size, bool), 0, sweep_table.is_grid(factors))


class Maps(unittest.TestCase):
    def test_a_grid_is_every_combination_once(self):
        table = grid([1.0, 2.0], [3.0, 4.0, 5.0])
        self.assertTrue(table.is_grid)
        table.factors[0].values[0] = 2.0
        self.assertFalse(sweep_table.is_grid(table.factors))

    def test_two_factors_have_a_heat_map_with_contours_of_each_figure(self):
        table = grid([1.0, 2.0, 4.0], [10.0, 20.0], figures=2)
        first, second = sweep.maps(table).axes[:2]
        self.assertEqual((first.get_xlabel(), first.get_ylabel()), ("factor 1 [rpm]", "factor 0 [rpm]"))
        mesh = first.collections[0]
        np.testing.assert_array_equal(np.reshape(mesh.get_array(), (3, 2)), [[11.0, 21.0], [12.0, 22.0], [14.0, 24.0]])
        np.testing.assert_array_equal(np.ravel(second.collections[0].get_array()), 2.0 * np.ravel(mesh.get_array()))
        self.assertEqual(len(first.collections), 1)  # no contours between two values
        self.assertGreater(len(sweep.maps(grid([1.0, 2.0, 4.0], [10.0, 20.0, 30.0])).axes[0].collections), 1)
        self.assertIn("\n", sweep.maps(grid([1.0, 2.0], [3.0, 4.0]))._suptitle.get_text())

    def test_a_failed_point_is_empty(self):
        table = grid([1.0, 2.0], [10.0, 20.0])
        table.figures[0].values[1] = np.nan
        values = sweep.maps(table).axes[0].collections[0].get_array()
        np.testing.assert_array_equal(np.ma.getmaskarray(values).ravel(), [False, True, False, False])

    def test_three_factors_have_a_row_of_maps_of_each_figure(self):
        table = grid([1.0, 2.0, 3.0], [5.0, 6.0], [10.0, 20.0, 30.0], figures=2)
        axes = [a for a in sweep.maps(table).axes if a.get_title()]
        self.assertEqual([a.get_title() for a in axes], 2 * ["factor 1 [rpm]: 5", "factor 1 [rpm]: 6"])
        self.assertEqual(np.ravel(axes[1].collections[0].get_array())[0], 1.0 + 6.0 + 10.0)

    def test_a_figure_has_the_unit_of_its_name_as_the_trade_writes_it(self):
        made = [sweep_table.Column(name, "", np.array([2000.0, 3600.0]), []) for name in ("wob_mean_n", "tob_mean_n_m", "rop_mean_m_per_s",
                                                                                    "rotary_speed_mean_rad_per_s", "imbalance")]
        sweep_table.set_labels(made)
        self.assertEqual([c.label for c in made], ["mean weight on bit [kN]", "mean torque on bit [kN m]", "mean rate of penetration [m/h]",
                                                   "mean rotary speed [rpm]", "imbalance"])
        shown = [sweep_table.in_drawn_units(c).values[0] for c in made]
        np.testing.assert_allclose(shown, [2.0, 2.0, 7.2e6, 2000.0 * 30.0 / np.pi, 2000.0])

    def test_one_factor_has_a_line_with_points_of_each_figure(self):
        table = grid([3.0, 1.0, 2.0], figures=2)
        self.assertEqual(list(sweep.pictures(table)), ["curves"])
        [line] = sweep.curves(table).axes[1].get_lines()
        np.testing.assert_array_equal(line.get_xydata(), [[1.0, 2.0], [2.0, 4.0], [3.0, 6.0]])
        self.assertEqual(sweep.curves(table).axes[0].get_ylabel(), "rate of penetration 0 [m/h]")

    def test_without_a_map_the_reason_is_given(self):
        many = list(range(7))
        samples = grid([1.0, 2.0], [3.0, 4.0])
        samples.is_grid = False
        for table, word in ((samples, "the points are samples"), (grid(*4 * [[1.0, 2.0]]), "the sweep has 4 factors"),
                            (grid(many, many, many), "7 values or more")):
            self.assertIn(word, sweep.no_map(table))
            self.assertNotIn("map", sweep.pictures(table))

    def test_samples_have_coefficients_in_place_of_shares(self):
        table = grid([1.0, 2.0, 3.0], [3.0, 4.0, 6.0])
        table.is_grid = False
        figure = sweep.effects(table)
        coefficients, _ = sweep_table.regression(table.factors, table.figures[0])
        self.assertEqual([t.get_text() for a in figure.axes for t in a.texts], [f"{c:.2f}" for c in coefficients])
        self.assertTrue(figure.axes[0].get_ylabel().endswith("R$^2$ = 1.00"))
        with tempfile.TemporaryDirectory() as folder:
            sweep.write_effects(table, pathlib.Path(folder) / "effects.csv")
            head = (pathlib.Path(folder) / "effects.csv").read_text().splitlines()[0]
        self.assertEqual(head, "figure,factor,standardised coefficient,R2,means at places")


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
        table = sweep_table.read_table(self.table)
        self.assertEqual(table.factors[1].words, ["lie-mean", "lie-midpoint"])
        figure = sweep.effects(table)
        axes = figure.axes[0]
        np.testing.assert_array_equal(axes.get_lines()[0].get_ydata(), [4000, 4000, 2000, 2000, 1000, 1000])
        np.testing.assert_array_equal(axes.get_lines()[1].get_ydata(), [4000, 2000, 1000])
        self.assertEqual([t.get_text() for t in axes.texts], ["100 %"])
        self.assertEqual([t.get_text() for t in figure.axes[1].texts], ["0 %"])

    def test_parallel_coordinates_have_a_line_for_each_point_and_thick_ones_for_the_front(self):
        table = sweep_table.read_table(self.table)
        [axes] = sweep.parallel(table).axes
        lines = axes.get_lines()[:6]
        self.assertEqual(sum(line.get_linewidth() > 1.0 for line in lines), int(table.front.sum()))
        self.assertGreater(int(table.front.sum()), 1)
        self.assertIn("6 points", axes.get_title())

    def test_pictures_are_reproducible(self):
        made = []
        for name in ("a", "b"):
            subprocess.run([ROOT / "reports/sweep.py", self.table, "-o", self.folder / name], check=True, stdout=subprocess.DEVNULL)
            made.append([p.read_bytes() for p in sorted((self.folder / name).glob("*.svg"))])
        self.assertEqual(len(made[0]), 3)
        self.assertEqual(*made)

    def test_the_page_has_the_points_and_the_pictures_of_the_table(self):
        done = subprocess.run([ROOT / "reports/run_report.py", self.table], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.folder / "tops_report.html").read_text()
        table = sweep_table.read_table(self.table)
        balance.check(page)
        self.assertEqual(page.count("<img "), 3)
        self.assertIn('<th scope="row">points</th><td>6</td>', page)
        self.assertIn('<th scope="row">factor drift</th><td>lie-mean, lie-midpoint</td>', page)
        rows = re.search(r"Points that are done.*?<tbody>(.*?)</tbody>", page, re.DOTALL)[1]
        cells = [re.findall("<td>(.*?)</td>", row) for row in re.findall("<tr>(.*?)</tr>", rows)]
        self.assertEqual([c[2] for c in cells], [f"{v:.0f}" for v in table.figures[0].values])
        self.assertEqual([c[4] for c in cells], ["yes" if front else "no" for front in table.front])

    def test_what_is_no_table_is_named(self):
        for text in (b"no", None):
            wrong = self.folder / "wrong.nc"
            wrong.write_bytes(text) if text else wrong.unlink()
            done = subprocess.run([ROOT / "reports/sweep.py", wrong], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn("wrong.nc: found no table of a sweep", done.stderr)
            done = subprocess.run([ROOT / "reports/run_report.py", wrong], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr.startswith("report: ")), (2, True), done.stderr)
            self.assertFalse((self.folder / "wrong_report.html").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
