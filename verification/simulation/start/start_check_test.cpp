#include "simulation/start/start_check.hpp"

#include <gtest/gtest.h>

#include "rock/start/borehole.hpp"

namespace tdbd::simulation::start_check_test {

/// A bowl: flat bottom of radius 0.1 at depth 0.05, wall up to depth 0.02.
mesh::Surface bowl() {
  return mesh::make_surface(rock::borehole(rock::flat_bottom(0.1, 0.05, 0.03), 0.01));
}

TEST(CoverAbove, is_nothing_in_the_hole) {
  for (const Vec3& x : {Vec3(0, 0, 0.049), Vec3(0.05, 0.03, 0.03), Vec3(0.09, 0, -1)})
    EXPECT_EQ(cover_above(bowl(), x), 0.0);
}

TEST(CoverAbove, is_the_depth_below_the_bottom) {
  for (const Vec3& x : {Vec3(0, 0, 0.06), Vec3(0.05, 0.03, 0.06), Vec3(0.01, 0, 0.06)})
    EXPECT_NEAR(cover_above(bowl(), x), 0.01, 1e-9);
}

TEST(CoverAbove, is_nothing_where_there_is_no_surface_above) {
  EXPECT_EQ(cover_above(bowl(), Vec3(0.2, 0, 0.06)), 0.0);
}

/// Below a ledge the open is what lies under its lower face, and rock what lies in it.
TEST(CoverAbove, knows_a_ledge_from_the_open_below_it) {
  using rock::MeridianPoint;
  const mesh::Surface hollow = mesh::make_surface(rock::borehole(
      {{0.0, 0.1}, {0.1, 0.1}, {0.1, 0.08}, {0.05, 0.07}, {0.05, 0.05}, {0.1, 0.04}}, 0.005));
  EXPECT_EQ(cover_above(hollow, Vec3(0.08, 0.0, 0.09)), 0.0);
  EXPECT_GT(cover_above(hollow, Vec3(0.08, 0.0, 0.06)), 0.01);
  EXPECT_GT(cover_above(hollow, Vec3(0.08, 0.0, 0.11)), 0.01);
  EXPECT_EQ(cover_above(hollow, Vec3(0.0, 0.0, 0.06)), 0.0);
}

}  // namespace tdbd::simulation::start_check_test
