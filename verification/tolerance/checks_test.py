"""checks_test.py: the kind of a check, and reading of recorded errors."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import checks  # noqa: E402
from checks import Check  # noqa: E402

SOURCE = """constexpr double rounding = 1e-9;
TEST(A, b) {
  EXPECT_LT(error, 0.02);
  // wide: the other seeds of the noise give up to 0.015
  EXPECT_NEAR(length, 2.0,
              0.02);
  EXPECT_LT(error, 0.03);  // wide: a bound of theory
  EXPECT_LT(finer, coarser);
  EXPECT_LT(error, rounding);
}
"""


def check(line, words, share=0.1, allowed=0.02, scale=0.0):
    return Check("a_test.cpp", line, words, 1, share, share * allowed, allowed, scale)


def kind(*arguments, **named):
    return checks.kind(check(*arguments, **named), SOURCE)


class Kinds(unittest.TestCase):
    def test_a_third_of_the_tolerance_is_tight(self):
        self.assertEqual(kind(3, "0.02", share=0.34), "tight")
        self.assertEqual(kind(3, "0.02", share=0.33), "loose")

    def test_a_comment_above_or_in_the_statement_explains_a_wide_tolerance(self):
        self.assertEqual(kind(5, "0.02"), "said")
        self.assertEqual(kind(7, "0.03"), "said")
        self.assertEqual(kind(9, "rounding"), "loose")

    def test_a_comparison_of_two_computed_numbers_is_a_bound(self):
        self.assertEqual(kind(8, "coarser"), "bound")
        self.assertEqual(kind(8, "finer < coarser"), "bound")
        self.assertEqual(kind(8, "finer < coarser && x < 1e-3"), "bound")
        self.assertEqual(kind(8, "norm(a) < 1e-3 * scale"), "loose")
        self.assertEqual(kind(8, "std::get<0>(a) < coarser[i]"), "bound")

    def test_named_constants_are_tolerances(self):
        self.assertEqual(kind(9, "error <= rounding * scale"), "loose")

    def test_a_limit_of_the_program_is_a_bound(self):
        self.assertEqual(kind(9, "depth < tolerance::inside * 2.0"), "bound")

    def test_constants_are_read_where_they_are_declared(self):
        text = "constexpr double rounding = 1e-12, near = 0.5; ///< m\nstatic constexpr double wide = 2.0 * near;\nconstexpr int n = 3;"
        self.assertEqual(checks.constants(text), {"rounding": 1e-12, "near": 0.5})

    def test_rounding_depends_on_the_scale(self):
        self.assertEqual(kind(3, "1e-14", allowed=1e-14), "rounding")
        self.assertEqual(kind(3, "1e-11", allowed=1e-11), "loose")
        self.assertEqual(kind(3, "1e-12 * scale", allowed=1e-9), "rounding")
        self.assertEqual(kind(3, "1e-9", allowed=1e-9, scale=2e3), "rounding")
        self.assertEqual(kind(3, "1e-9", allowed=1e-9, scale=2e2), "loose")


class Reading(unittest.TestCase):
    def test_takes_the_largest_share_of_all_processes(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, share, seen in (("1", "0.1", "0.002"), ("2", "0.4", "0.008"), ("3", "0.2", "0.004")):
                row = ("/root/a_test.cpp", "3", "5", share, seen, "0.02", "7", 'e < 0.02 && s == "x"')
                (pathlib.Path(folder) / f"{name}.tsv").write_text("\t".join(row) + "\n", encoding="utf-8")
            self.assertEqual(checks.read(folder, "/root"), [Check("a_test.cpp", 3, 'e < 0.02 && s == "x"', 15, 0.4, 0.008, 0.02, 7.0)])


if __name__ == "__main__":
    unittest.main()
