#include "reference/literature/surface/z_map_sweep.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::z_map_sweep_test {

double most_apart(const ZMap& a, const ZMap& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.height.size(); ++i)
    most = std::max(most, std::abs(a.height[i] - b.height[i]));
  return most;
}

/// A cell whose centre lies on a facet's rim to rounding may belong to one and not the other: at a
/// silhouette a whole depth hangs on it. Places that are no multiples of the cell make that rare;
/// here none happens.
RC_GTEST_PROP(ZMapSweep, takes_row_by_row_what_the_slow_twin_takes, ()) {
  const mesh::TriangleMesh part = *battery::convex_polyhedron();
  Pose X_WP = *battery::pose(0.3);
  X_WP.p += Vec3(0.01234567, 0.0234567, -0.2);
  ZMap slow = flat_z_map(1.7, 0.0, 67), quick = slow;
  const double removed = cut(slow, part, X_WP);
  RC_ASSERT(std::abs(cut_sweep(quick, part, X_WP) - removed) < 1e-12);
  RC_ASSERT(most_apart(slow, quick) < 1e-12);
}

TEST(ZMapSweep, of_a_sheet_has_its_heights) {
  const mesh::TriangleMesh sheet =
      battery::placed({Eigen::AngleAxisd(0.3, Vec3::UnitX()).toRotationMatrix(), Vec3::Zero()},
                      battery::flat_rock(1.0, 0.0, 7));
  const ZMap map = z_map_of(sheet, 0.8, 33);
  for (const double y : {-0.77, -0.3, 0.01, 0.5})  // a plane: bilinear is exact
    EXPECT_NEAR(height_at(map, 0.123, y), y * std::tan(0.3), 1e-12);
}

/// Heights at corners of cells are means of four: exact for planes, off by a cell's share of a
/// curved surface, which order 2 shows.
TEST(ZMapSweep, height_between_cells_converges_with_order_two) {
  const auto error = [](int cells) {
    ZMap map = flat_z_map(1.0, 0.0, cells);
    for (int i = 0; i < cells * cells; ++i) {
      const double x = -1.0 + (i % cells + 0.5) * map.cell();
      map.height[static_cast<std::size_t>(i)] = x * x;
    }
    double worst = 0.0;
    for (double x = -0.8; x < 0.8; x += 0.0137)
      worst = std::max(worst, std::abs(height_at(map, x, 0.1) - x * x));
    return worst;
  };
  EXPECT_NEAR(std::log2(error(32) / error(64)), 2.0, 2.2e-4);
}

}  // namespace tdbd::reference::z_map_sweep_test
