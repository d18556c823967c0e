"""Laboratory and calibration: the files of the command line, coefficients, predictions, Ctrl-C between cut runs."""

import unittest

from common import ROOT, FolderTest, command, words

import numpy as np
import tdbd

CUTTERS = ROOT / "validation/cases/zijsling-share.toml"
RECORDS = ROOT / "validation/records/zijsling-1987.csv"
LABORATORY = ROOT / "validation/cases/laboratory.toml"
COARSE = {"rock.edge_length": "8 mm", "time.revolutions": 2, "time.steps_per_revolution": 50}
FEW = COARSE | {"laboratory.rates": ["10 m/h"], "laboratory.pressures": ["3000 psi"]}


class Calibration(FolderTest):
    def test_files(self):
        self.demand_one_commit()
        done = command("calibrate", CUTTERS, "-o", self.folder / "a", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, "tdbd: warning: the error of the law is unknown, so intervals "
                                                          "contain the noise only: only one bit is fitted\n"))
        result = tdbd.calibrate(CUTTERS, self.folder / "b")
        self.assertEqual(command("calibrate", CUTTERS, "-o", self.folder / "c").stdout.rsplit("results in", 1)[0], result.answer)
        self.assertIn("calibration.json", self.same_files(self.folder / "a", result.folder))

    def test_what_it_found(self):
        result = tdbd.calibrate(CUTTERS)
        self.assertEqual(set(result.coefficients), {"A1", "A3", "pressure_share"})
        for found in result.coefficients.values():
            self.assertTrue(found["low"] < found["value"] < found["high"], found)
        predictions = result.predictions
        kinds = [name.removesuffix("_mean") for name in predictions if name.endswith("_mean")]
        self.assertEqual(len(kinds), 2)
        for kind in kinds:
            self.assertEqual(predictions[kind + "_mean"].dims, ("record",))
            self.assertTrue(predictions[kind + "_mean"].attrs["units"])
            self.assertTrue(np.all(predictions[kind + "_low"] <= predictions[kind + "_high"]))
        self.assertGreater(result.residuals.sizes["record"], 3)
        self.assertIs(result.fits, True)
        self.assertIn("The law fits the readings.", result.answer)
        self.assertRegex(repr(result), "<tdbd.CalibrationResult of hanson-hansen: the law fits, in .*>")
        self.assertTrue(result.law.startswith('[forces]\nlaw = "hanson-hansen"'), result.law)

    def test_a_wrong_reading_is_named(self):
        lines = RECORDS.read_text().splitlines()
        head = next(i for i, line in enumerate(lines) if "[" in line)
        row = next(i for i, line in enumerate(lines) if i > head and ",mid," in line)
        column = next(i for i, name in enumerate(lines[head].split(",")) if name.startswith("normal"))
        cells = lines[row].split(",")
        cells[column] = str(2 * float(cells[column]))
        (self.folder / "wrong.csv").write_text("\n".join([*lines[:row], ",".join(cells), *lines[row + 1:]]) + "\n")
        with self.assertWarnsRegex(tdbd.CaseWarning, r"the law does not fit the readings: chi2 .* degrees of freedom"):
            result = tdbd.calibrate(tdbd.case(CUTTERS, calibration__records=self.folder / "wrong.csv"))
        self.assertIs(result.fits, False)
        self.assertEqual((result.worst_readings[0]["line"], result.worst_readings[0]["load"]), (row + 1, "normal"))
        self.assertIn("THE LAW DOES NOT FIT THE READINGS.", result.answer)
        self.assertRegex(repr(result), "THE LAW DOES NOT FIT")

    def test_laboratory(self):
        settings = {key: value if isinstance(value, (str, int)) else str(value).replace("'", '"') for key, value in FEW.items()}
        done = command("laboratory", LABORATORY, *words(settings), "-o", self.folder / "a.csv", "--cuts", self.folder / "cuts")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        heard = []
        records = tdbd.laboratory(tdbd.case(LABORATORY, set=FEW), self.folder / "b.csv", cuts=self.folder / "more-cuts",
                                  progress=lambda done, total: heard.append((done, total)))
        self.assertEqual((self.folder / "a.csv").read_bytes(), (self.folder / "b.csv").read_bytes())
        self.assertEqual((records.sizes["record"], heard[-1]), (3, (3, 3)))
        with self.assertRaisesRegex(tdbd.FolderError, "b.csv: exists; force=True overwrites"):
            tdbd.laboratory(tdbd.case(LABORATORY, set=FEW), self.folder / "b.csv")

    def test_cut_runs_are_found_again_and_stop(self):
        made = []

        def stop(done, total):
            made.append(done)
            raise KeyboardInterrupt

        case = tdbd.case(LABORATORY, set=COARSE | {"rock.edge_length": "3 mm"})
        for _ in range(2):
            self.assertRaises(KeyboardInterrupt, tdbd.laboratory, case, self.folder / "a.csv", cuts=self.folder / "cuts", progress=stop)
        self.assertEqual(len(list((self.folder / "cuts").glob("cuts-*.nc"))), sum(made))
        self.assertFalse((self.folder / "a.csv").exists())


if __name__ == "__main__":
    unittest.main(warnings="ignore")
