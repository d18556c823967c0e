#include "reference/rock/close_surface.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reference/mesh/exact_volume.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::close_surface_test {

using mesh::TriangleMesh;

TEST(CloseSurface, of_a_flat_rock_is_a_box) {
  const TriangleMesh block = close_surface(battery::flat_rock(1.0, 0.5, 3), 2.0);
  EXPECT_DOUBLE_EQ(enclosed_volume_exact(block), 8.0);
  EXPECT_EQ(self_intersecting_pairs(block), 0u);
}

TEST(CloseSurface, loses_the_volume_of_a_dent) {
  TriangleMesh dented = battery::flat_rock(1.0, 0.0, 2);
  dented.positions[4].z() = 0.5;  // a pyramid over the ring of the middle vertex, area 3
  EXPECT_DOUBLE_EQ(enclosed_volume_exact(close_surface(dented, 1.0)), 4.0 - 0.5);
}

TEST(CloseSurface, refuses_a_bottom_that_is_too_high) {
  TriangleMesh dented = battery::flat_rock(1.0, 0.0, 2);
  dented.positions[4].z() = 0.5;
  EXPECT_THROW(close_surface(dented, 0.5), RunError);
}

TEST(CloseSurface, refuses_a_boundary_that_is_not_level) {
  TriangleMesh tilted = battery::flat_rock(1.0, 0.0, 2);
  tilted.positions[0].z() = -0.1;
  EXPECT_THROW(close_surface(tilted, 1.0), RunError);
}

TEST(CloseSurface, refuses_closed_surfaces_and_holes) {
  EXPECT_THROW(close_surface(battery::box({0, 0, 0}, {1, 1, 1}), 2.0), RunError);
  TriangleMesh pierced = battery::flat_rock(1.0, 0.0, 4);
  pierced.triangles.erase(pierced.triangles.begin() + 10);  // away from the outer boundary
  EXPECT_THROW(close_surface(pierced, 1.0), RunError);
}

}  // namespace tdbd::reference::close_surface_test
