"""draw_test.py TDBD ROOT: the figure of a convergence study shows the values of its file."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

TDBD, ROOT = map(pathlib.Path, sys.argv[1:])
sys.path.insert(0, str(ROOT / "reports"))
from figures import convergence  # noqa: E402

CASE = ROOT / "cases/slow-top.toml"
SHORT = ("--set", "time.duration=1 s", "--set", "time.step=0.1 s")


def tdbd(*words):
    subprocess.run([TDBD, *words, *SHORT, "--quiet"], check=True)


class Study(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.made.name)
        tdbd("converge", CASE, "--over", "time.step", "--levels", "5", "-o", cls.folder / "next")
        tdbd("rotate", CASE, "-o", cls.folder / "fine", "--set", "integrator.order=8")
        tdbd("converge", CASE, "--over", "time.step", "--levels", "3", "--reference", cls.folder / "fine", "-o",
             cls.folder / "reference")

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def expect_drawn(self, name, kind, words):
        study = json.loads((self.folder / name / "convergence.json").read_text(encoding="utf-8"))
        [axes] = convergence.draw_folder(self.folder / name).axes
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
        self.assertIn(words, axes.get_ylabel())
        lines = dict(zip(study["variables"], axes.get_lines()))
        for variable, line in lines.items():
            v = study["variables"][variable]
            drawn = np.nan_to_num(line.get_ydata()) * v["scale"]
            np.testing.assert_allclose(drawn, v[kind], rtol=1e-14)
            np.testing.assert_array_equal(line.get_xdata(), [level["size"] for level in study["levels"]][:len(drawn)])
            self.assertIn(f"{v['order']:.3f}" if v["order"] else v["verdict"], line.get_label())
        return axes.get_lines()[len(lines):]

    def test_differences_to_the_next_level_and_the_nominal_order(self):
        [nominal] = self.expect_drawn("next", "differences", "differences to the next level")
        self.assertEqual(nominal.get_label(), "order 2, nominal")
        x, y = np.log(nominal.get_xdata()), np.log(nominal.get_ydata())
        np.testing.assert_allclose(np.diff(y) / np.diff(x), 2.0)

    def test_errors_against_a_reference(self):
        self.expect_drawn("reference", "errors", "errors to the reference")

    def test_the_picture_is_the_same_twice(self):
        pictures = []
        for out in ("first", "second"):
            subprocess.run([sys.executable, "-B", ROOT / "reports/draw.py", self.folder / "next", "-o", self.folder / out],
                           check=True, capture_output=True)
            pictures.append((self.folder / out / "convergence.png").read_bytes())
        self.assertGreater(len(pictures[0]), 10000)
        self.assertEqual(pictures[0], pictures[1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
