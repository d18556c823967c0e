"""result_pictures_test.py TDBD ROOT: the pictures of every kind of result show its numbers; the printable page; progress."""

import json
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
import progress  # noqa: E402
import result_pictures  # noqa: E402
from figures import calibration_pictures, results, traces, work_precision  # noqa: E402

TOP = ROOT / "cases/slow-top.toml"
DRILL = ("--set", "rock.edge_length=6 mm", "--set", "time.step=5 ms", "--set", "time.revolutions=0.4", "--set", "output.means_from=0.1 s")


def tdbd(*words):
    subprocess.run([TDBD, *words, "--quiet"], check=True)


class OfResults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.folder = pathlib.Path(made.name)
        tdbd("run", ROOT / "cases/bit-b-6000psi.toml", "-o", cls.folder / "run", *DRILL)
        for order in ("2", "4"):
            for step in ("0.1 s", "0.05 s", "0.025 s"):
                tdbd("rotate", TOP, "-o", cls.folder / f"top-{order}-{step[:-2]}", "--set", "time.duration=1 s", "--set", f"time.step={step}",
                     "--set", f"integrator.order={order}")
        tdbd("converge", TOP, "--over", "time.step", "--levels", "4", "-o", cls.folder / "orders", "--set", "time.duration=1 s")
        tdbd("calibrate", ROOT / "validation/cases/cutter-small-to-large-glowka.toml", "-o", cls.folder / "fit")

    def drawn(self, name, kind):
        _, pictures = result_pictures.of_folder(self.folder / name, kind)
        return {p.name: p for p in pictures}

    def test_a_run_has_a_panel_for_each_load_and_a_straight_line_for_a_constant(self):
        pictures = self.drawn("run", "run")
        self.assertEqual(list(pictures), ["bit", "bottom_hole", "side_view", "cutters", "forces", "traces"])
        weight, torque, speed, spectra = pictures["traces"].draw().axes
        self.assertEqual([a.get_ylabel() for a in (weight, torque, speed)],
                         ["weight on bit (kN)", "torque on bit (kN m)", "speed of the bit (rpm)"])
        [line] = speed.get_lines()
        self.assertEqual(set(line.get_ydata()), {120.0})
        self.assertEqual(speed.get_ylim(), (108.0, 132.0))
        self.assertEqual(len(weight.get_lines()), 1)
        self.assertEqual([t.get_text() for t in spectra.get_legend().get_texts()], ["weight on bit (kN)", "torque on bit (kN m)"])

    def test_a_constant_is_recognized_despite_rounding(self):
        self.assertEqual(traces.constant([119.999999999979991, 120.0, 120.00000000002]), 120.0)
        self.assertEqual(traces.constant(np.zeros(5)), 0.0)
        self.assertIsNone(traces.constant([120.0, 120.01]))
        self.assertEqual(traces.constant([1e-9, -1e-9], scale=5.0), 0.0)
        self.assertIsNone(traces.constant([np.nan, np.nan]))

    def test_titles_are_wrapped_to_the_width(self):
        figure = traces.style.panels(1, 1, (4.0, 3.0))[0]
        self.assertLessEqual(max(map(len, traces.fitted("many words " * 20, figure).split("\n"))), 50)

    def test_a_rotation_draws_changes_below_rounding_as_none(self):
        *_, conservation = self.drawn("top-2-0.05", "rotation").values()
        energies, energy, momentum = conservation.draw().axes
        self.assertEqual(len(energies.get_lines()), 3)
        self.assertGreater(np.abs(energy.get_lines()[0].get_ydata()).max(), 1e-9)
        self.assertFalse(momentum.get_lines()[0].get_ydata().any())

    def test_work_and_precision_of_runs_and_of_a_study(self):
        runs = sorted(path for path in self.folder.glob("top-*") if path.is_dir())
        [axes] = work_precision.of_runs(runs).axes
        lines = {line.get_label(): line for line in axes.get_lines()}
        self.assertEqual(set(lines), {"split, order 2", "slope of order 2", "split, order 4", "slope of order 4"})
        summaries = [json.loads((self.folder / f"top-2-{h}/summary.json").read_text()) for h in ("0.1", "0.05", "0.025")]
        np.testing.assert_array_equal(lines["split, order 2"].get_xdata(), [s["torque_evaluations"] for s in summaries])
        for order in (2, 4):
            x, y = np.log(lines[f"slope of order {order}"].get_xydata().T)
            np.testing.assert_allclose(np.diff(y) / np.diff(x), -order)
        study = json.loads((self.folder / "orders/convergence.json").read_text())
        counts = [level["torque_evaluations"] for level in study["levels"]]
        self.assertEqual(counts, [level["steps"] + 1 for level in study["levels"]])
        [axes] = self.drawn("orders", "convergence")["work_precision"].draw().axes
        self.assertEqual(results.in_words({"order": None, "verdict": "too few"}), "not known (too few points above rounding)")
        self.assertEqual(results.in_words({"order": None, "verdict": "exact"}), "not needed (the results are exact)")
        np.testing.assert_array_equal(axes.get_lines()[0].get_xdata(), counts[:-1])
        np.testing.assert_allclose(axes.get_lines()[0].get_ydata(), np.array(study["variables"]["attitude"]["differences"])
                                   / study["variables"]["attitude"]["scale"])

    def test_rotations_with_different_ends_are_rejected(self):
        other = self.folder / "other"
        tdbd("rotate", TOP, "-o", other, "--set", "time.duration=2 s", "--force")
        with self.assertRaisesRegex(ValueError, r"found rotations that end at different times \(1 s, 2 s\), expected the same duration"):
            work_precision.of_runs([self.folder / "top-2-0.1", other])

    def test_a_calibration_shows_its_intervals_and_readings(self):
        found = json.loads((self.folder / "fit/calibration.json").read_text())
        [axes] = calibration_pictures.coefficients(self.folder / "fit", "fit").axes
        self.assertEqual([t.get_text().split(" ")[0] for t in axes.get_yticklabels()], list(found["coefficients"]))
        bars = [line.get_xdata() for line in axes.get_lines() if len(line.get_xdata()) == 2 and line.get_linewidth() == 2.0]
        for bar, c in zip(bars, found["coefficients"].values()):
            np.testing.assert_allclose(bar, [c["low"] / c["value"], c["high"] / c["value"]])
        normal, _ = calibration_pictures.predictions(self.folder / "fit", "fit").axes
        self.assertIn("fitted: 13 readings", [t.get_text() for t in normal.get_legend().get_texts()])

    def report(self, name):
        page = self.folder / f"{name}.html"
        done = subprocess.run([sys.executable, "-B", ROOT / "reports/run_report.py", self.folder / name, "-o", page], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = page.read_text(encoding="utf-8")
        balance.check(text)
        self.assertIsNone(re.search(r"(src|href)=.(?!data:)", text), "the page fetches something")
        self.assertIn("@media print", text)
        return text

    def test_the_page_of_a_run_and_of_a_rotation(self):
        text = self.report("run")
        for part in ("weight on bit</th>", "mechanical specific energy</th>", "The bit</h2>", "Traces</h2>", "cutter-28/face", "law = &#34;hanson-hansen&#34;"):
            self.assertIn(part, text)
        self.assertEqual(text.count("<img "), 6)
        self.assertEqual(text, self.report("run"))
        text = self.report("top-4-0.05")
        self.assertIn("<td>drift split, order 4</td>", text)
        self.assertEqual(text.count("<img "), 3)
        for name in ("orders", "fit"):
            self.report(name)

    def test_progress_is_a_line_for_each_part_where_it_takes_its_time(self):
        shown = progress.Progress("draw", 4, "picture")
        shown.on_terminal, shown.shown = False, -100.0
        said = []
        original, progress.print = getattr(progress, "print", print), lambda line, **_: said.append(line)
        try:
            self.assertEqual(list(shown.over(["a", "b", "c", "d"])), ["a", "b", "c", "d"])
        finally:
            progress.print = original
        self.assertEqual(said, ["draw: picture 1 of 4, 25 %  a", "draw: picture 4 of 4, 100 %  d"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
