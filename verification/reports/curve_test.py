"""curve_test.py ROOT: the picture of a curve shows the values of its table; what is no curve is named."""

import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np

ROOT = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(ROOT / "reports"))
import curve  # noqa: E402

HEAD = "rock,weight_set_n,wob_mean_n,wob_interval_n,rop_mean_m_per_h,rop_interval_m_per_h,tob_mean_n_m,tob_interval_n_m\n"
TABLE = HEAD + "shale,10000,9900,100,5,0.2,600,20\nshale,20000,19800,nan,11,0.3,1300,30\ngranite,20000,nan,nan,nan,nan,nan,nan\n"
RATES = "rock,rate_m_per_h,result,weight_set_n,rop_mean_m_per_h\nshale,11,found,20000,11\ngranite,11,out-of-reach,nan,nan\n"


class Curve(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def drawn(self):
        """The axes of the rate and of the torque."""
        (self.folder / "curve.csv").write_text(TABLE)
        with mock.patch.object(curve.plt, "close"):
            path = curve.draw_curve(self.folder, self.folder / "out")
        self.assertEqual(path, self.folder / "out" / "curve.png")
        self.addCleanup(curve.plt.close, "all")
        return curve.plt.gcf().axes

    def test_shows_rate_and_torque_over_the_weight(self):
        (self.folder / "rates.csv").write_text(RATES)
        rate, torque = self.drawn()
        np.testing.assert_allclose(rate.containers[0].lines[0].get_xydata(), [[9.9, 5], [19.8, 11]])
        np.testing.assert_allclose(torque.containers[0].lines[0].get_xydata(), [[9.9, 600], [19.8, 1300]])
        self.assertEqual((rate.get_xlabel(), rate.get_ylabel()), ("weight on bit [kN]", "rate of penetration [m/h]"))
        self.assertEqual([t.get_text() for t in torque.get_legend().get_texts()], ["shale: 20 kN for 11 m/h", "granite"])
        stars = [line for line in rate.get_lines() if line.get_marker() == "*"]
        self.assertEqual([star.get_xydata().tolist() for star in stars], [[[20.0, 11.0]]])

    def test_of_one_without_a_rate_has_no_star(self):
        rate, _ = self.drawn()
        self.assertEqual([line for line in rate.get_lines() if line.get_marker() == "*"], [])

    def test_picture_is_reproducible(self):
        (self.folder / "curve.csv").write_text(TABLE)
        pictures = [curve.draw_curve(self.folder, self.folder / name).read_bytes() for name in ("a", "b")]
        self.assertEqual(*pictures)

    def test_has_a_printable_page(self):
        (self.folder / "curve.csv").write_text(TABLE.replace("\n", ",no,\n").replace("tob_interval_n_m,no,", "tob_interval_n_m,steady,message"))
        (self.folder / "rates.csv").write_text(RATES.replace("per_h\n", "per_h,message\n").replace("nan,nan\n", "nan,nan,out\n").replace(
            "20000,11\n", "20000,11,11 m/h takes 20 kN\n"))
        done = subprocess.run([sys.executable, "-B", ROOT / "reports/run_report.py", self.folder], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr.strip().splitlines()[1:]), (0, []), done)
        page = (self.folder / "report.html").read_text(encoding="utf-8")
        for words in ("A curve of rate over weight", "11 m/h takes 20 kN", "3 of 3 runs: their means drift", "shale, 10 kN", "5 m/h, 600 N m, not steady",
                      "data:image/png"):
            self.assertIn(words, page)

    def test_what_is_no_curve_is_named(self):
        for text in (None, "a,b\n1,2\n", HEAD):
            if text is not None:
                (self.folder / "curve.csv").write_text(text)
            done = subprocess.run([ROOT / "reports/curve.py", self.folder], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"{self.folder}: found no curve (", done.stderr)
            self.assertNotIn("Traceback", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
