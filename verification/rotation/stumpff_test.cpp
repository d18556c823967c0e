#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rotation/quaternion.hpp"
#include "verification/battery/dual.hpp"

namespace tdbd::rotation::stumpff_test {

constexpr double rounding = 4e-16;   // values of order one
constexpr double cancelled = 2e-13;  // c_4, c_5 by upward recurrence just above the series' end
constexpr double derivative = 1e-14;

/// Straight from the definition in extended precision; x up to ten.
double by_definition(int k, double x) {
  long double term = 1.0L, sum = 0.0L;
  for (int n = 2; n <= k; ++n) term /= n;
  for (int j = 0; j < 40; ++j) {
    sum += term;
    term *= -static_cast<long double>(x) / ((2.0L * j + k + 1) * (2.0L * j + k + 2));
  }
  return static_cast<double>(sum);
}

double random_x() { return 1e-5 * *rc::gen::inRange(0, 1'000'000); }

RC_GTEST_PROP(Stumpff, agree_with_their_series, ()) {
  const double x = random_x();
  const Stumpff<double> c = stumpff(x);
  const CosSinc<double> t = cos_sinc(x);
  const double all[] = {c.c0, c.c1, c.c2, c.c3, c.c4, c.c5};
  for (int k = 0; k < 6; ++k)
    RC_ASSERT(std::abs(all[k] - by_definition(k, x)) <= (k < 2 ? 2.0 * rounding : cancelled));
  RC_ASSERT(std::abs(t.cos - by_definition(0, x)) <= rounding);
  RC_ASSERT(std::abs(t.sinc - by_definition(1, x)) <= rounding);
}

TEST(Stumpff, c_2_and_c_3_keep_their_digits_up_to_the_series_end) {
  for (double x = 0.0; x <= stumpff_series_end; x += 0.01) {
    EXPECT_NEAR(stumpff(x).c2, by_definition(2, x), rounding) << x;
    EXPECT_NEAR(stumpff(x).c3, by_definition(3, x), rounding) << x;
  }
}

TEST(Stumpff, keep_value_and_derivative_where_a_series_is_shortest) {
  constexpr double last_digits = 2.3e-16;
  using Dual = battery::Dual<1>;
  for (const double x :
       {stumpff_short_series_end, 2.0 * stumpff_short_series_end, 1.0 / 32.0, stumpff_series_end}) {
    Dual seeded(x);
    seeded.by[0] = 1.0;
    EXPECT_NEAR(cos_sinc(x).cos, by_definition(0, x), last_digits) << x;
    EXPECT_NEAR(cos_sinc(x).sinc, by_definition(1, x), last_digits) << x;
    EXPECT_NEAR(cos_sinc(seeded).cos.by[0], -0.5 * by_definition(1, x), derivative) << x;
  }
}

TEST(Stumpff, carry_derivatives_on_both_sides_of_the_series_end) {
  using Dual = battery::Dual<1>;
  for (const double x : {0.0, 0.1, 0.2499, 0.26, 1.0, 4.0}) {
    Dual seeded(x);
    seeded.by[0] = 1.0;
    const Stumpff<Dual> c = stumpff(seeded);
    EXPECT_NEAR(c.c1.by[0], 0.5 * (by_definition(3, x) - by_definition(2, x)), derivative) << x;
    EXPECT_NEAR(c.c2.by[0], by_definition(4, x) - 0.5 * by_definition(3, x), derivative) << x;
    EXPECT_NEAR(c.c3.by[0], 0.5 * (3.0 * by_definition(5, x) - by_definition(4, x)), derivative)
        << x;
  }
}

}  // namespace tdbd::rotation::stumpff_test
