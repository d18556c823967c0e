#include "dynamics/schedule.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::dynamics::schedule_test {

TEST(Schedule, empty_is_zero_and_a_constant_has_no_end) {
  EXPECT_EQ(value_at({}, 3.0), 0.0);
  EXPECT_EQ(integral_to({}, 3.0), 0.0);
  const Schedule c = constant(4.0);
  EXPECT_EQ(value_at(c, -7.0), 4.0);
  EXPECT_EQ(value_at(c, 7.0), 4.0);
  for (const double t : {3.0, 0.1, -0.3, 1e-20}) EXPECT_EQ(integral_to(c, t), 4.0 * t);
}

TEST(Schedule, stairs_hold_and_ramps_rise) {
  const Schedule stairs = make_schedule(Interpolation::stepwise, {1.0, 3.0}, {10.0, 20.0});
  const Schedule ramp = make_schedule(Interpolation::linear, {1.0, 3.0}, {10.0, 20.0});
  for (const Schedule* s : {&stairs, &ramp}) {
    EXPECT_EQ(value_at(*s, 0.0), 10.0);  // the first before the first time
    EXPECT_EQ(value_at(*s, 1.0), 10.0);
    EXPECT_EQ(value_at(*s, 3.0), 20.0);  // at an edge the value after it
    EXPECT_EQ(value_at(*s, 9.0), 20.0);
  }
  EXPECT_EQ(value_at(stairs, 2.5), 10.0);
  EXPECT_EQ(value_at(ramp, 2.5), 17.5);
  EXPECT_EQ(integral_to(stairs, 4.0), 10.0 + 20.0 + 20.0);
  EXPECT_EQ(integral_to(ramp, 4.0), 10.0 + 30.0 + 20.0);
}

/// The integral is that of the values, across every entry: sums of midpoints on a fine grid.
RC_GTEST_PROP(Schedule, integral_is_that_of_the_values, ()) {
  std::vector<double> times{*battery::number(-1.0, 1.0)}, values{*battery::number(-5.0, 5.0)};
  const int more = *battery::integer(0, 4);
  for (int i = 0; i < more; ++i) {
    times.push_back(times.back() + *battery::number(0.05, 1.0));
    values.push_back(*battery::number(-5.0, 5.0));
  }
  const auto kind = *rc::gen::element(Interpolation::stepwise, Interpolation::linear);
  const Schedule s = make_schedule(kind, times, values);
  const double end = *battery::number(-2.0, 5.0);
  constexpr int cells = 4000;
  double sum = 0.0, jumps = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) jumps += std::abs(values[i] - values[i - 1]);
  for (int i = 0; i < cells; ++i) sum += value_at(s, end * (i + 0.5) / cells) * end / cells;
  // A midpoint misses a jump by half a cell of it at most; the sum of up to 25 rounds.
  const double missed = 0.5 * jumps * std::abs(end) / cells;
  RC_ASSERT(std::abs(integral_to(s, end) - sum) <= missed + 1e-12 * 25.0);
}

TEST(Schedule, rejects_what_is_no_schedule) {
  const auto reason = [](std::vector<double> t, std::vector<double> v) {
    return schedule_problem(t, v);
  };
  EXPECT_EQ(reason({0.0, 1.0}, {1.0}), "2 times for 1 values");
  EXPECT_EQ(reason({0.0, 0.0}, {1.0, 2.0}), "entry 2: 0 s does not come after 0 s");
  EXPECT_EQ(reason({0.0}, {std::nan("")}), "entry 1: nan at 0 s is not finite");
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(reason({0.0, std::nan("")}, {1.0, 2.0}), "entry 2: 2 at nan s is not finite");
  EXPECT_EQ(reason({0.0, inf}, {1.0, 2.0}), "entry 2: 2 at inf s is not finite");
  EXPECT_EQ(reason({}, {}), "");
  EXPECT_THROW(make_schedule(Interpolation::linear, {1.0, 0.0}, {0.0, 0.0}), InputError);
}

}  // namespace tdbd::dynamics::schedule_test
