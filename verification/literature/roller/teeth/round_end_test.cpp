#include "reference/literature/roller/teeth/round_end.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/literature/roller/craters/crater_bottom.hpp"
#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::round_end_test {
namespace {

/// A ring begins to carry at once, as wide as it is: by a law that is smooth at 0, and by a table that
/// begins with a slope; scale: the law's force.
constexpr double of_power = 0.03, of_table = 0.15;

double force_on(const ZMap& bottom, const RoundEnd& end, const ToothLaw& law, double depth) {
  std::vector<double> gaps(end.points.size());
  touch_round_end(end, Vec3::Zero(), bottom, gaps.data());
  return round_end_force(end, law, gaps.data(), depth);
}

TEST(RoundEnd, feels_the_law_itself_on_flat_rock) {
  const RoundEnd end = round_end(6e-3, 0.5e-3, 4e-3);
  const ZMap bottom = flat_z_map(10e-3, 0.0, 40);
  for (const auto& [law, of_rings] : {std::pair{ToothLaw(example::power_tooth()), of_power},
                                      std::pair{ToothLaw(example::tooth_table()), of_table}})
    for (const double depth : {1e-3, 1.7e-3, 2.4e-3}) {
      const double expected = tooth_force(law, depth);
      EXPECT_NEAR(force_on(bottom, end, law, depth), expected, of_rings * expected) << depth;
    }
}

/// In its own crater a tooth feels nothing; its point alone would not know of the ridge beside it.
TEST(RoundEnd, feels_the_ridge_beside_its_point_and_nothing_in_its_own_crater) {
  const RoundEnd end = round_end(6e-3, 0.5e-3, 4e-3);
  const ToothLaw law = example::power_tooth();
  ZMap bottom = flat_z_map(12e-3, 0.0, 240);
  dig(bottom, {Vec3(0, 0, 1e-3), 1e-3, 6e-3, CraterShape::sphere});
  EXPECT_LT(force_on(bottom, end, law, 0.99e-3), 0.01 * tooth_force(law, 1e-3));
  ZMap ridge = flat_z_map(12e-3, 0.0, 240);
  dig(ridge, {Vec3(-1.5e-3, 0, 1e-3), 1e-3, 6e-3, CraterShape::sphere});
  const double there = level_at(ridge, 0.0, 0.0);
  EXPECT_GT(force_on(ridge, end, law, 0.99 * there), 0.05 * tooth_force(law, 1e-3));
}

}  // namespace
}  // namespace tdbd::reference::round_end_test
