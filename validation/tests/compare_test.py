"""compare_test.py ROOT: errors, floors and verdicts of an invented result; messages name the mistakes."""

import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv[1]) / "validation"
sys.path.insert(0, str(ROOT))
import compare  # noqa: E402
import comparison  # noqa: E402
import validate  # noqa: E402

HEADER = ("test,bit,wob [N],tob [N m],wob_mean [N],wob_se [N],wob_low [N],wob_high [N],tob_mean [N m],tob_se [N m],"
          "tob_low [N m],tob_high [N m],measured_wob [N],measured_tob [N m]\n")
# Weight 10 % too high and 10 % too low; a torque 20 % too high, and one without a reading.
ROWS = ("t,A,1000,50,1100,1,1050,1150,60,1,40,80,1000,50\n"
        "t,A,2000,,1800,1,1700,2100,60,1,40,80,2000,\n")
WHY = "Made up."


def split(floor, verdict="within the floor"):
    return [{"name": "made-up", "title": "Made up", "kind": "synthetic laboratory", "fit": ["B"], "predict": ["A"],
             "floor": floor, "floor_of": "nothing",
             "law": {"detournay": {"case": "made-up-case", "verdict": verdict, "why": WHY}}}]


class Made(unittest.TestCase):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.results = pathlib.Path(made.name)
        folder = self.results / "made-up-case"
        folder.mkdir()
        (folder / "predictions.csv").write_text(HEADER + ROWS, encoding="utf-8")
        (folder / "calibration.json").write_text(json.dumps({"extrapolates": True}), encoding="utf-8")

    def compared(self, *arguments):
        [one] = comparison.read_all(split(*arguments), self.results, {})
        return one

    def test_errors_are_those_of_the_rows_that_were_read(self):
        one = self.compared(0.1)
        weight, torque = one.loads
        self.assertAlmostEqual(weight.mean(), 0.0, delta=1e-12)
        self.assertAlmostEqual(weight.rms(), 0.1, delta=1e-12)
        self.assertEqual((len(torque.predicted), one.readings()), (1, 3))
        self.assertAlmostEqual(torque.mean(), 0.2, delta=1e-12)
        self.assertEqual(weight.inside, [False, True])
        self.assertAlmostEqual(one.inside(), 2.0 / 3.0, delta=1e-12)
        self.assertTrue(one.extrapolates)

    def test_verdict_is_that_of_the_worst_load(self):
        for floor, verdict in ((0.21, "within the floor"), (0.19, "within 2 floors"), (0.101, "within 2 floors"),
                               (0.099, "fails")):
            self.assertEqual(self.compared(floor).verdict(), verdict, floor)

    def test_verdict_sees_a_mean_that_is_off_and_a_scatter_alike(self):
        load = comparison.Load("wob", "N", [1.1, 1.1], [1.0, 1.0], [True, True], comparison.Floor(0.04, 0.2))
        self.assertAlmostEqual(load.in_floors(), 2.5, delta=1e-9)
        load.predicted = [1.3, 0.7]
        self.assertAlmostEqual(load.in_floors(), 1.5, delta=1e-9)

    def test_tables_and_figures_are_written(self):
        compare.compare(self.results, split(0.21))
        table = (self.results / "comparisons.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(table[0], ",".join(compare.COLUMNS))
        self.assertEqual(table[2], f"made-up,synthetic laboratory,detournay,tob,1,0.2000,0.2100,0.2000,0.2100,1.000,yes,"
                                   f"within the floor,{WHY}")
        self.assertIn("synthetic laboratory", (self.results / "comparisons.md").read_text(encoding="utf-8"))
        for name in ("comparison-made-up.png", "comparisons.png"):
            self.assertTrue((self.results / name).read_bytes().startswith(b"\x89PNG"))

    def test_a_verdict_that_was_not_expected_is_told(self):
        for verdict, code in (("within the floor", 0), ("fails", 1)):
            with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as told:
                self.assertEqual(compare.report(comparison.read_all(split(0.21, verdict), self.results, {})), code)
            self.assertEqual("read its 'why' again" in told.getvalue(), code == 1)


class Mistakes(unittest.TestCase):
    def test_a_missing_result_is_named(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(comparison.Problem, "made-up-case: found no result"):
            comparison.read_all(split(0.1), folder, {})

    def test_a_floor_that_nothing_measured_is_named(self):
        with self.assertRaisesRegex(comparison.Problem, "made-up: floor: found .'nowhere'. without wob"):
            comparison.floor_of(split(["nowhere"])[0], "wob", comparison.floors())

    def test_an_unknown_comparison_is_named(self):
        with self.assertRaisesRegex(comparison.Problem, "found no comparison 'nothing', expected one of cutter-"):
            validate.chosen(comparison.read_split(), ["nothing"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
