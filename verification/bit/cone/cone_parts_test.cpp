#include "bit/cone/cone_parts.hpp"

#include <gtest/gtest.h>

#include "bit/cone_generate.hpp"

namespace tdbd::bit::cone_parts_test {

RC_GTEST_PROP(ConeSpacing, sums_to_a_turn_in_the_ratios_of_the_pattern, ()) {
  const int teeth = *rc::gen::inRange(2, 30);
  std::vector<double> pattern;
  for (int i = 0; i < *rc::gen::inRange(1, 6); ++i) pattern.push_back(number(0.5, 2.0));
  const std::vector<double> a = spaced_angles(teeth, 0.0, pattern);
  RC_ASSERT(a.size() == static_cast<std::size_t>(teeth));
  double sum = 0.0, ratios = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) ratios += pattern[i % pattern.size()];
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double space = (i + 1 < a.size() ? a[i + 1] : a[0] + 2 * pi) - a[i];
    RC_ASSERT(std::abs(space - 2 * pi * pattern[i % pattern.size()] / ratios) < 1e-14);
    sum += space;
  }
  RC_ASSERT(std::abs(sum - 2 * pi) < 1e-14);
}

RC_GTEST_PROP(ConeSpacing, rises_within_one_turn_from_any_first_angle, ()) {
  const std::vector<double> a = spaced_angles(*rc::gen::inRange(1, 30), number(-20, 20), {1, 2});
  for (std::size_t i = 0; i < a.size(); ++i) {
    RC_ASSERT(a[i] >= 0.0 && a[i] < 2 * pi);
    if (i > 0) RC_ASSERT(a[i] > a[i - 1]);  // RC_ASSERT looks at both sides of an "or"
  }
}

}  // namespace tdbd::bit::cone_parts_test
