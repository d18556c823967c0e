#include "reference/rock/section_by_columns.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::section_by_columns_test {

/// Forwards along x at the origin; z of F is up.
Pose across_the_path(double y) {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = -Vec3::UnitY();
  X.R.col(2) = -Vec3::UnitZ();
  X.p.y() = y;
  return X;
}

/// Rock up to 0.1 above a box's lower side. The corners of its triangles are multiples of an eighth
/// apart, in y and along the path: with 4 columns that are an eighth wide every column lies on
/// edges, and the face on corners, wherever the box is moved by whole eighths.
RC_GTEST_PROP(SectionByColumns, counts_a_column_on_an_edge_once, ()) {
  const mesh::TriangleMesh rock_W = battery::flat_rock(1.0, 0.0, 16);
  const double shift = 0.125 * *battery::integer(-3, 3);
  const double y = *rc::gen::element(0.0, 0.0625, 0.03);  // on edges, between them, anywhere
  const std::vector<Eigen::Vector2d> box_F{
      {-0.3125, -0.1}, {0.1875, -0.1}, {0.1875, 0.5}, {-0.3125, 0.5}};
  const reference::ColumnSection s =
      reference::section_by_columns(rock_W, across_the_path(shift + y), box_F, 4);
  RC_ASSERT(std::abs(s.area - 0.05) <= 1e-15);
  RC_ASSERT(std::abs(s.moment.x() + 0.0625 * 0.05) <= 1e-15);
  RC_ASSERT(std::abs(s.moment.y() + 0.05 * 0.05) <= 1e-15);
}

}  // namespace tdbd::rock::section_by_columns_test
