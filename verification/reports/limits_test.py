"""limits_test.py ROOT: the limit of a claim is at most three times the measured value or gives a reason; a claim beyond its limit is rejected."""

import pathlib
import sys
import unittest

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "reports"))
import evidence  # noqa: E402


def measured(value, limit, test="Snail.creeps", claim="ours/speed", verdict="holds"):
    return evidence.Evidence(claim, "its speed", value, "m/s", limit, verdict, test, "verify_snails")


class Limits(unittest.TestCase):
    def assert_tight(self, *found):
        self.assertEqual(evidence.loose_limits(found), [])

    def assert_loose(self, *found):
        [problem] = evidence.loose_limits(found)
        return problem

    def test_of_three_times_the_measurement_are_tight(self):
        self.assert_tight(measured(0.1, "<= 0.299"), measured(-0.1, "<= 0.298"), measured(2.1, "2 +- 0.299"), measured(1.9, "2 +- 0.298"))

    def test_that_are_wider_are_named_with_what_they_leave(self):
        self.assertRegex(self.assert_loose(measured(0.1, "<= 0.4")), r"of ours/speed: Snail.creeps has the limit '<= 0.4', .* 0.25 is used")
        self.assert_loose(measured(-0.1, "<= 0.4"))
        self.assert_loose(measured(2.1, "2 +- 0.301"))
        self.assert_loose(measured(-1.9, "-2 +- 0.301"))
        self.assert_loose(measured(1.9, "2 +- 3.01e-1"))

    def test_of_a_measurement_that_meets_them_exactly_are_wide(self):
        self.assert_loose(measured(0.0, "<= 1e-9"))
        self.assert_loose(measured(2.0, "2 +- 1e-9"))

    def test_that_say_why_may_be_wide(self):
        self.assert_tight(measured(0.1, "<= 0.4; wide: five standard deviations"), measured(2.0, "2 +- 1; wide: a chaotic run"))

    def test_with_other_words_after_the_number_do_not_say_why(self):
        self.assert_loose(measured(0.1, "<= 0.4; GSL takes 0.9"))
        self.assert_loose(measured(2.1, "2 +- 0.4 where it rains"))
        self.assert_loose(measured(0.1, "<= 0.4; wide: "))

    def test_that_are_missed_are_not_wide_whatever_they_say(self):
        self.assert_tight(measured(1.4, "1 +- 0.1 is missed: it sleeps"), measured(0.7, "<= 0.1 was asked"))

    def test_of_rounding_may_be_wide(self):
        self.assert_tight(measured(0.0, "<= 1e-12"), measured(2.0, "2 +- 1e-12"), measured(1e-15, "<= 3e-13"))
        self.assert_loose(measured(1e-15, "<= 2e-12"))

    def test_are_as_tight_as_the_worst_of_a_test_s_measurements(self):
        self.assert_tight(measured(0.1, "<= 1"), measured(0.5, "<= 1"), measured(0.0, "<= 1"))
        self.assert_loose(measured(0.1, "<= 1"), measured(0.3, "<= 1"))


class Missed(unittest.TestCase):
    def assert_missed(self, found):
        [problem] = evidence.missed_limits([found])
        return problem

    def test_what_is_within_its_limit_may_hold(self):
        for limit, value in (("<= 0.1", 0.1), ("2 +- 0.1", 2.05), ("<= 0", 0.0), ("0, bitwise", 0.0), ("below 1", 4.0)):
            self.assertEqual(evidence.missed_limits([measured(value, limit)]), [])

    def test_what_is_beyond_its_limit_does_not_hold(self):
        self.assertIn("Snail.creeps measured 0.11 of 'its speed', beyond the limit '<= 0.1'", self.assert_missed(measured(0.11, "<= 0.1")))
        for limit, value in (("<= 0.1; wide: it rains", 0.11), ("2 +- 0.1", 2.11), ("<= 0", 1.0), ("<= 1", -1.65)):
            self.assert_missed(measured(value, limit))
            self.assert_missed(measured(value, limit, verdict="holds with limits"))

    def test_a_recorded_miss_may_pass_within_its_limits(self):
        found = measured(1.4, "1 +- 0.1 is missed: it sleeps", verdict="holds with limits")
        self.assertEqual(evidence.missed_limits([found]), [])
        self.assert_missed(measured(1.4, "1 +- 0.1 is missed: it sleeps"))

    def test_what_is_refuted_may_be_beyond_its_limit(self):
        self.assertEqual(evidence.missed_limits([measured(1.65, "<= 1", verdict="refuted")]), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
