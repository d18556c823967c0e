"""split_test.py ROOT: no record is both fitted and compared, and split.toml agrees with the cases."""

import pathlib
import sys
import tomllib
import unittest

ROOT = pathlib.Path(sys.argv[1]) / "validation"
sys.path.insert(0, str(ROOT))
import comparison  # noqa: E402
import validate  # noqa: E402

SPLIT = comparison.read_split()
KEYS = {"name", "title", "kind", "fit", "predict", "floor", "floor_of", "law"}
LAW_KEYS = {"case", "verdict", "why", "coefficients_from"}


def case(name):
    return tomllib.loads((ROOT / "cases" / f"{name}.toml").read_text(encoding="utf-8"))


class Split(unittest.TestCase):
    def test_fits_nothing_that_it_compares(self):
        for c in SPLIT:
            self.assertFalse(set(c["fit"]) & set(c["predict"]), c["name"])
            for law in c["law"].values():
                chosen = case(law["case"])["calibration"]
                self.assertFalse(set(chosen.get("fit_bits", [])) & set(chosen["predict_bits"]), law["case"])

    def test_says_what_the_cases_fit_and_predict(self):
        for c in SPLIT:
            for law in c["law"].values():
                with self.subTest(law["case"]):
                    fitted = case(law.get("coefficients_from", law["case"]))["calibration"]
                    self.assertEqual(sorted(fitted.get("fit_bits", [])), sorted(c["fit"]))
                    self.assertEqual(sorted(case(law["case"])["calibration"]["predict_bits"]), sorted(c["predict"]))

    def test_is_complete_and_in_known_words(self):
        self.assertEqual(len({c["name"] for c in SPLIT}), len(SPLIT))
        for c in SPLIT:
            with self.subTest(c["name"]):
                self.assertEqual(set(c), KEYS)
                self.assertIn(c["kind"], comparison.KINDS)
                for law in c["law"].values():
                    self.assertLessEqual(set(law), LAW_KEYS)
                    self.assertIn(law["verdict"], comparison.VERDICTS)
                    self.assertTrue(law["why"].endswith("."))

    def test_knows_every_case_of_measured_and_published_records(self):
        made = {name for name, _ in validate.runs(SPLIT)}
        for file in (ROOT / "cases").glob("*.toml"):
            if not file.stem.startswith("lab"):
                self.assertIn(file.stem, made)

    def test_has_floors_for_all_loads_of_its_records(self):
        known = comparison.floors()
        for c in SPLIT:
            for load in ("normal", "drag") if c["predict"][0].split("-")[0] in "jkd" else ("wob",):
                floor = comparison.floor_of(c, load, known)
                self.assertTrue(0.0 < floor.mean < 0.2 and 0.0 < floor.rms < 0.2, c["name"])

    def test_runs_a_case_after_the_one_that_it_starts_from(self):
        order = [name for name, _ in validate.runs(SPLIT)]
        for name, before in validate.runs(SPLIT):
            if before:
                self.assertLess(order.index(before), order.index(name))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
