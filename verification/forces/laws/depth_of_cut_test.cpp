#include "forces/laws/depth_of_cut.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"
#include "forces/laws/detournay.hpp"

namespace tdbd::forces::depth_of_cut_test {

/// 10 mm wide, 1 mm deep.
TEST(DepthOfCut, is_width_times_depth_and_doubles_with_the_depth) {
  const DepthOfCut law{.kn = 80 * MPa, .kt = 100 * MPa, .slip_speed = 0.0};
  PartCut c = plain_cut(bit::PartKind::face);
  EXPECT_LT((law_force(law, c).force - Vec3(-1000, 0, -800)).norm(), 1e-12);
  c.depth *= 2;
  EXPECT_LT((law_force(law, c).force - Vec3(-2000, 0, -1600)).norm(), 1e-12);
}

/// Equal to the law of Detournay with kt = eps and kn = zeta eps, of a square-ended cutter.
TEST(DepthOfCut, of_a_square_cutter_is_that_of_a_sharp_one) {
  const DepthOfCut law{.kn = 80 * MPa, .kt = 100 * MPa, .slip_speed = 0.0};
  const Detournay sharp{.eps = 100 * MPa, .zeta = 0.8, .slip_speed = 0.0};
  const PartCut c = plain_cut(bit::PartKind::face);  // its area is edge times depth
  EXPECT_LT((law_force(law, c).force - law_force(sharp, c).force).norm(), 1e-12);
}

}  // namespace tdbd::forces::depth_of_cut_test
