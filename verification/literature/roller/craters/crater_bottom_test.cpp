#include "reference/literature/roller/craters/crater_bottom.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "verification/battery/generators.hpp"

namespace tdbd::reference::crater_bottom_test {
namespace {

/// Cells of a tenth of a millimetre under a crater of 3 mm; scale: its volume.
constexpr double of_cells = 1e-3;

ZMap fine() { return flat_z_map(6e-3, 0.0, 240); }

TEST(CraterBottom, a_cone_and_a_cap_leave_their_volumes) {
  for (const Crater& crater : {Crater{{0, 0, 1.5e-3}, 1.5e-3, 3.5e-3, CraterShape::cone},
                               Crater{{0, 0, 1.2e-3}, 1.2e-3, 6e-3, CraterShape::sphere}}) {
    ZMap bottom = fine();
    const double expected = isolated_volume(crater);
    EXPECT_NEAR(dig(bottom, crater), expected, of_cells * expected);
    EXPECT_NEAR(*std::ranges::max_element(bottom.height), crater.depth, 0.1 * crater.depth);
    EXPECT_EQ(*std::ranges::min_element(bottom.height), 0.0);
    EXPECT_EQ(dig(bottom, crater), 0.0);
  }
}

TEST(CraterBottom, two_craters_that_overlap_take_less_than_their_sum) {
  ZMap bottom = fine();
  const Crater first{{-1e-3, 0, 1e-3}, 1e-3, 2.6e-3, CraterShape::cone};
  Crater second = first;
  second.tip_W.x() = 1e-3;
  const double alone = dig(bottom, first), then = dig(bottom, second);
  EXPECT_LT(then, 0.9 * alone);
  EXPECT_GT(then, 0.5 * alone);
}

RC_GTEST_PROP(CraterBottom, levels_of_a_plane_are_exact_and_of_the_outside_are_the_rims, ()) {
  ZMap bottom = flat_z_map(1.0, 0.0, 20);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i)
      bottom.height[at(j) * 20 + at(i)] = 0.3 * bottom.centre(i) - 0.2 * bottom.centre(j);
  const double x = *battery::number(-0.95, 0.95), y = *battery::number(-0.95, 0.95);
  RC_ASSERT(std::abs(level_at(bottom, x, y) - (0.3 * x - 0.2 * y)) <= 1e-15);
  RC_ASSERT(std::abs(level_at(bottom, 7.0, y) - (0.3 * 0.95 - 0.2 * y)) <= 1e-15);
}

RC_GTEST_PROP(CraterBottom, digging_never_raises_and_tells_what_it_took, ()) {
  ZMap bottom = flat_z_map(6e-3, 0.0, 60);
  for (int n = 0; n < 4; ++n) {
    const std::vector<double> before = bottom.height;
    const double depth = *battery::number(-0.5, 2.0) * 1e-3;
    const Crater crater{
        {*battery::number(-8.0, 8.0) * 1e-3, *battery::number(-8.0, 8.0) * 1e-3, depth},
        depth,
        *battery::number(0.0, 5.0) * 1e-3,
        *rc::gen::element(CraterShape::cone, CraterShape::sphere)};
    const double dug = dig(bottom, crater);
    double sum = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      RC_ASSERT(bottom.height[i] >= before[i]);
      sum += (bottom.height[i] - before[i]) * bottom.cell() * bottom.cell();
    }
    RC_ASSERT(std::abs(sum - dug) <= 1e-12 * (sum + 1e-12));
  }
}

}  // namespace
}  // namespace tdbd::reference::crater_bottom_test
