#include "reference/rock/swept_boolean.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/mesh/exact_volume.hpp"
#include "reference/rock/close_surface.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::swept_boolean_test {

using mesh::TriangleMesh;

const TriangleMesh rock = close_surface(battery::flat_rock(4.0, 0.0, 4), 3.0);
const TriangleMesh cube = battery::box({-1, -1, -1}, {1, 1, 1});

Pose at(double x, double y, double z) { return {Mat3::Identity(), Vec3(x, y, z)}; }

TEST(SweptBoolean, of_a_cube_that_goes_down_is_its_face_times_its_depth) {
  const SweptBoolean s = swept_boolean(rock, cube, {at(0, 0, -2), at(0, 0, -1), at(0, 0, -0.5)});
  EXPECT_EQ(s.before, 192.0);
  EXPECT_EQ(s.removed, 2.0);
  EXPECT_EQ(s.after, 190.0);
}

/// Along x, then along y: the corner is counted once.
TEST(SweptBoolean, of_a_path_with_a_corner_is_its_union) {
  const SweptBoolean s =
      swept_boolean(rock, cube, {at(-1, 0, -0.5), at(1, 0, -0.5), at(1, 1.5, -0.5)});
  EXPECT_EQ(s.removed, 0.5 * (4.0 * 2.0 + 1.5 * 2.0));
}

TEST(SweptBoolean, of_a_path_in_the_air_is_nothing) {
  EXPECT_EQ(swept_boolean(rock, cube, {at(0, 0, -3), at(0, 0, -2)}).removed, 0.0);
}

/// The cube turns about its upright axis by a quarter: its corners' circle, in chords.
TEST(SweptBoolean, of_a_turning_cube_is_a_disc_in_chords) {
  constexpr int steps = 3;
  std::vector<Pose> poses;
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::numbers::pi / 2.0 * i / steps;
    const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    poses.push_back({R, Vec3(0, 0, -0.5)});
  }
  constexpr int sides = 4 * steps;  // of a regular polygon of circumradius sqrt(2)
  const double polygon = sides * std::sin(2.0 * std::numbers::pi / sides);
  EXPECT_NEAR(swept_boolean(rock, cube, poses).removed, 0.5 * polygon, 1e-12);
}

RC_GTEST_PROP(SweptBoolean, of_a_buried_part_at_rest_is_the_part, ()) {
  const TriangleMesh part = *battery::convex_polyhedron();
  Pose X_WP = *battery::pose(0.0);
  X_WP.p = Vec3(0.0, 0.0, 2.0);
  const TriangleMesh deep = close_surface(battery::flat_rock(4.0, 0.0, 1), 8.0);
  const double removed = swept_boolean(deep, part, {X_WP, X_WP}).removed;
  RC_ASSERT(std::abs(removed - enclosed_volume_exact(part)) < 1e-12);
}

}  // namespace tdbd::reference::swept_boolean_test
