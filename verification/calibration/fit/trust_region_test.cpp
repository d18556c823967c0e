#include "calibration/fit/trust_region.hpp"

#include <gsl/gsl_errno.h>
#include <gtest/gtest.h>

#include <utility>

namespace tdbd::calibration::trust_region_test {
namespace {

/// In the middle of a range.
Unknown within(double lo, double hi) {
  Unknown u;
  u.range = Range::within(lo, hi);
  u.start = 0.5 * (lo + hi);
  return u;
}

/// No readings: a row for each prior, (value - centre)/sd. GSL must not end the program.
struct Priors {
  Problem problem;
  Data data{Eigen::VectorXd(), Eigen::VectorXd(2)};

  Priors() {
    gsl_set_error_handler_off();
    problem.unknowns.assign(2, within(1.0, 3.0));
    for (Unknown& u : problem.unknowns) u.prior_sd = 1.0;
    data.prior_centres << 2.0, 2.0;
  }
};

/// A misfit that no free unknown changes, 1e8, is so large that rounding hides what is left to gain: the search cannot go
/// lower and has ended, whichever row it is.
TEST(SearchFromValues, has_ended_where_rounding_hides_the_rest) {
  for (const auto& [held, free] : {std::pair(0, 1), std::pair(1, 0)}) {
    Priors p;
    p.data.prior_centres[held] = 1e8;
    Search search{p.problem, p.data, Eigen::Vector2d(2.0, 2.0), {free}};
    search.values[free] = 2.1;
    EXPECT_EQ(search_from_values(search), GSL_SUCCESS) << held;
  }
}

/// Beyond the lower end the objective falls where its gradient is positive, beyond the upper one where it is negative.
TEST(IsDrivenOut, follows_the_sign_of_the_gradient_at_each_end) {
  const Unknown u = within(1.0, 3.0);
  for (const double slope : {1e-9, 0.5, 7.0}) {
    EXPECT_TRUE(is_driven_out_of_range(u, 1.0001, slope));
    EXPECT_FALSE(is_driven_out_of_range(u, 1.0001, -slope));
    EXPECT_TRUE(is_driven_out_of_range(u, 2.9999, -slope));
    EXPECT_FALSE(is_driven_out_of_range(u, 2.9999, slope));
    EXPECT_FALSE(is_driven_out_of_range(u, 2.0, slope));
    EXPECT_FALSE(is_driven_out_of_range(u, 2.0, -slope));
  }
}

/// A billionth of the range inside, wherever the range lies.
TEST(EndOf, is_a_billionth_of_the_range_inside) {
  for (const double lo : {-40.0, 0.0, 10.0}) {
    const double width = 2.0;
    const Unknown u = within(lo, lo + width);
    EXPECT_NEAR(end_of(u, lo + 1e-5) - lo, 1e-9 * width, 1e-14);
    EXPECT_NEAR(lo + width - end_of(u, lo + width - 1e-5), 1e-9 * width, 1e-14);
  }
}

TEST(EndOf, is_a_billionth_of_the_start_inside_where_there_is_one_end) {
  Unknown u;
  u.range = {.lo = 2.0};
  u.start = 5.0;
  EXPECT_NEAR(end_of(u, 2.0001) - 2.0, 1e-9 * 3.0, 1e-15);
}

}  // namespace
}  // namespace tdbd::calibration::trust_region_test
