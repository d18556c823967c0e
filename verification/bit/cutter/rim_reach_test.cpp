#include "bit/cutter/rim_reach.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"

namespace tdbd::bit::rim_reach_test {
namespace {

/// Columns are equal, from the axis to the widest rim, and no wider than asked.
TEST(RimReach, has_columns_no_wider_than_asked) {
  const std::vector<Cutter> cutters = table('b');
  double end = 0.0;
  for (const Cutter& c : cutters)
    for (const Vec3& p : turned_outline(c, rim_points)) end = std::max(end, p.x());
  for (const double widest : {0.1e-3, 0.37e-3, 1.3e-3, 7e-3}) {
    const RimReaches rims = rim_reaches(cutters, widest);
    ASSERT_EQ(rims.of_cutter.size(), cutters.size());
    const auto columns = static_cast<double>(rims.of_cutter.front().size());
    EXPECT_LE(rims.width, widest);
    EXPECT_GT(rims.width, widest * (1.0 - 1.0 / columns));
    EXPECT_NEAR(rims.width * columns, end, 1e-15);
  }
}

/// The rim starts at the tip, which stands on the outer edge of the chamfer.
TEST(TurnedOutline, starts_at_the_tip) {
  for (const Cutter& c : table('b')) {
    ASSERT_GT(c.chamfer, 0.0);
    const Vec3 first = turned_outline(c, 12).front();
    EXPECT_NEAR(first.x(), c.tip_radius, 1e-15);
    EXPECT_NEAR(first.y(), c.azimuth, 1e-13);
    EXPECT_NEAR(first.z(), -c.tip_height, 1e-15);
  }
}

}  // namespace
}  // namespace tdbd::bit::rim_reach_test
