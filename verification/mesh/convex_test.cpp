#include "mesh/convex.hpp"

#include <gtest/gtest.h>

#include "verification/battery/shapes.hpp"

namespace tdbd::mesh {
namespace {

TEST(convex, has_one_plane_for_coplanar_triangles) {
  EXPECT_EQ(convex_solid(battery::box({-1, -1, -1}, {1, 1, 1}))->planes, 6U);
  EXPECT_EQ(convex_solid(battery::cylinder(1.0, 2.0, 64))->planes, 66U);
}

TEST(convex, is_not_what_has_a_notch_or_a_hole) {
  EXPECT_FALSE(convex_solid(battery::prism(battery::l_outline(1.0, 0.9), 0.0, 1.0)));
  EXPECT_FALSE(convex_solid(battery::torus(3.0, 1.0, 12, 8)));
}

TEST(convex, leaves_a_ball_of_many_planes_to_the_tree) {
  EXPECT_EQ(convex_solid(battery::sphere(1.0, 2))->planes, 320U);
  EXPECT_FALSE(convex_solid(battery::sphere(1.0, 3)));
}

}  // namespace
}  // namespace tdbd::mesh
