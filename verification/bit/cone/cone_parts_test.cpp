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

/// A tooth stands on its place of the shell, sunk along the normal there; its Z leans from the normal towards
/// the base, its X is along the meridian; all of it turns with the cone.
RC_GTEST_PROP(ToothPose, stands_on_the_shell_and_leans_towards_the_base, ()) {
  const ConeLayout c = any_cone();
  const std::size_t i = *rc::gen::inRange<std::size_t>(1, c.shell.size());
  const ShellPoint &a = c.shell[i - 1], &b = c.shell[i];
  ToothRow row;
  const double share = number(0.1, 0.9), angle = number(-7.0, 7.0);
  row.s = a.s + share * (b.s - a.s);
  row.sink = number(-2e-3, 2e-3);
  row.lean = number(-0.5, 0.5);
  const Pose X_KT = tooth_pose(c, row, angle);
  const Vec3 radial(std::cos(angle), std::sin(angle), 0.0), base = -Vec3::UnitZ();
  const double length = std::hypot(b.s - a.s, b.r - a.r);
  const Vec3 along = ((b.s - a.s) * base + (b.r - a.r) * radial) / length,
             out = ((b.s - a.s) * radial - (b.r - a.r) * base) / length;
  const Vec3 place = row.s * base + (a.r + share * (b.r - a.r)) * radial - row.sink * out;
  constexpr double rounding = 2e-15;
  RC_ASSERT((X_KT.p - place).norm() < 0.1 * rounding);
  RC_ASSERT((X_KT.R.col(2) - std::cos(row.lean) * out - std::sin(row.lean) * along).norm() <
            rounding);
  RC_ASSERT((X_KT.R.col(0) - std::cos(row.lean) * along + std::sin(row.lean) * out).norm() <
            rounding);
  RC_ASSERT((X_KT.R.col(2).cross(X_KT.R.col(0)) - X_KT.R.col(1)).norm() < rounding);
}

}  // namespace tdbd::bit::cone_parts_test
