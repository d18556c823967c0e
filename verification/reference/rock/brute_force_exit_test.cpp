#include "reference/rock/brute_force_exit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::brute_force_exit_test {

using mesh::TriangleMesh;

const Vec3 down(0, 0, 1);
const TriangleMesh unit_box = battery::box({-1, -1, -1}, {1, 1, 1});

bool in_unit_box(const Vec3& x) { return x.cwiseAbs().maxCoeff() < 1.0; }

RC_GTEST_PROP(Inside, agrees_with_a_box, ()) {
  const Vec3 x = *battery::point(1.5);
  RC_PRE(std::abs(x.cwiseAbs().maxCoeff() - 1.0) > 1e-9);
  RC_ASSERT(inside(unit_box, x) == in_unit_box(x));
}

RC_GTEST_PROP(Inside, agrees_with_a_placed_box, ()) {
  const Pose X = *battery::pose(2.0);
  const Vec3 x = *battery::point(1.5);
  RC_PRE(std::abs(x.cwiseAbs().maxCoeff() - 1.0) > 1e-9);
  RC_ASSERT(inside(battery::placed(X, unit_box), X * x) == in_unit_box(x));
}

RC_GTEST_PROP(Inside, agrees_with_a_ball_away_from_its_facets, ()) {
  const TriangleMesh ball = battery::sphere(1.0, 3);
  const Vec3 x = *battery::point(1.2);
  RC_PRE(x.norm() < 0.98 || x.norm() > 1.0);
  RC_ASSERT(inside(ball, x) == (x.norm() < 1.0));
}

TEST(Inside, sees_the_hole_of_a_torus) {
  const TriangleMesh ring = battery::torus(3.0, 1.0, 24, 12);
  EXPECT_FALSE(inside(ring, {0, 0, 0}));
  EXPECT_TRUE(inside(ring, {3, 0, 0}));
  EXPECT_FALSE(inside(ring, {4.5, 0, 0}));
}

TEST(BruteForceExit, of_a_box_at_rest_is_the_distance_to_its_face) {
  const Vec3 q(0.25, 0.5, -0.5);
  const SweptExit e = brute_force_exit(unit_box, q, q, down, down, 1);
  EXPECT_TRUE(e.swept);
  EXPECT_DOUBLE_EQ(e.t, 1.5);
}

TEST(BruteForceExit, ray_through_vertices_and_edges_is_no_special_case) {
  const Vec3 q(0, 0, 0), diagonal = Vec3(1, 1, 1).normalized(), edge = Vec3(1, 1, 0).normalized();
  EXPECT_NEAR(brute_force_exit(unit_box, q, q, diagonal, diagonal, 1).t, std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(brute_force_exit(unit_box, q, q, edge, edge, 1).t, std::sqrt(2.0), 1e-14);
}

TEST(BruteForceExit, vertex_outside_at_both_ends_is_swept_in_between) {
  const SweptExit e = brute_force_exit(unit_box, {-3, 0, 0.5}, {3, 0, 0.5}, down, down, 6);
  EXPECT_TRUE(e.swept);
  EXPECT_DOUBLE_EQ(e.t, 0.5);
}

TEST(BruteForceExit, vertex_that_only_lies_on_the_ray_is_not_swept) {
  const SweptExit e = brute_force_exit(unit_box, {0, 0, -2}, {0.5, 0, -2}, down, down, 10);
  EXPECT_FALSE(e.swept);
  EXPECT_EQ(e.t, 0.0);
}

/// A thin plate falls by 1: the vertex it met first must go down with it to its lower face's end.
TEST(BruteForceExit, of_a_thin_plate_bridges_the_sub_poses) {
  const TriangleMesh plate = battery::box({-1, -1, -0.01}, {1, 1, 0.01});
  const SweptExit e = brute_force_exit(plate, {0, 0, 0}, {0, 0, -1}, down, down, 10);
  EXPECT_TRUE(e.swept);
  EXPECT_NEAR(e.t, 1.01, 1e-12);
}

/// The ray crosses a ring twice; only the first lobe, in which the vertex lies, counts.
TEST(BruteForceExit, stops_at_the_end_of_the_first_interval) {
  const TriangleMesh ring = battery::torus(3.0, 1.0, 4, 4);
  const Vec3 q(-3, 0, 0), x(1, 0, 0);
  EXPECT_NEAR(brute_force_exit(ring, q, q, x, x, 1).t, 1.0, 1e-12);
}

/// The ring moves sideways by 4, so that its second lobe starts before the first one's trace ends.
TEST(BruteForceExit, joins_intervals_of_different_sub_poses) {
  const TriangleMesh ring = battery::torus(3.0, 1.0, 4, 4);
  const Vec3 x(1, 0, 0);
  const SweptExit e = brute_force_exit(ring, {-3, 0, 0}, {-7, 0, 0}, x, x, 400);
  EXPECT_NEAR(e.t, 11.0, 1e-12);
}

/// Sideways motion under a slanted direction: the exit over all tau is at the end tau = 1.
TEST(BruteForceExit, of_a_moving_box_is_its_last_face_position) {
  const Vec3 slanted = Vec3(1, 0, 1).normalized();
  const SweptExit e = brute_force_exit(unit_box, {0, 0, 0.9}, {0, 0, 0.4}, slanted, slanted, 7);
  EXPECT_NEAR(e.t, 0.6 * std::sqrt(2.0), 1e-14);
}

/// The way passes above the edge of a cube that stands on it: the exact exit, sqrt(2), lies between
/// sub-poses, and at slope 1 the error is at most half the way between two of them.
TEST(BruteForceExit, converges_to_an_edge_from_below) {
  const Mat3 R = Eigen::AngleAxisd(std::numbers::pi / 4.0, Vec3::UnitY()).toRotationMatrix();
  const TriangleMesh diamond = battery::placed({R, Vec3::Zero()}, unit_box);
  const Vec3 q0(-0.5, 0, 0), q1(0.6, 0, 0);
  for (const int substeps : {1, 10, 100, 1000}) {
    const double error = std::sqrt(2.0) - brute_force_exit(diamond, q0, q1, down, down, substeps).t;
    EXPECT_GE(error, -1e-12);
    EXPECT_LE(error, 0.55 / substeps + 1e-12);
  }
}

/// The direction turns from +z to +x while the vertex rests at the centre: the rays fan out, and
/// the one nearest to the box's edge goes farthest.
TEST(BruteForceExit, follows_a_direction_that_turns) {
  const Vec3 q(0, 0, 0), x(1, 0, 0);
  const SweptExit e = brute_force_exit(unit_box, q, q, down, x, 2);
  EXPECT_DOUBLE_EQ(e.t, 2.0);  // u(1/2) = (1/2, 0, 1/2) reaches the edge at t = 2
}

RC_GTEST_PROP(BruteForceExit, of_a_convex_part_grows_with_nested_sub_poses, ()) {
  const TriangleMesh part = *battery::convex_polyhedron();
  const Vec3 q0 = *battery::point(0.6), q1 = q0 + *battery::point(0.5), u = *battery::direction();
  const SweptExit coarse = brute_force_exit(part, q0, q1, u, u, 4);
  const SweptExit fine = brute_force_exit(part, q0, q1, u, u, 16);
  RC_TAG(fine.swept ? "swept" : "missed");
  RC_ASSERT(!coarse.swept || fine.swept);
  RC_ASSERT(coarse.t <= fine.t + 1e-12);
}

RC_GTEST_PROP(BruteForceExit, does_not_depend_on_the_frame, ()) {
  const TriangleMesh part = *battery::star_shape();
  const Pose X = *battery::pose(3.0);
  const Vec3 q0 = *battery::point(0.6), q1 = q0 + *battery::point(0.3), u = *battery::direction();
  const SweptExit here = brute_force_exit(part, q0, q1, u, u, 3);
  const SweptExit there =
      brute_force_exit(battery::placed(X, part), X * q0, X * q1, X.rotate(u), X.rotate(u), 3);
  RC_TAG(here.swept ? "swept" : "missed");
  RC_ASSERT(here.swept == there.swept);
  RC_ASSERT(std::abs(here.t - there.t) < 1e-12);
}

}  // namespace tdbd::reference::brute_force_exit_test
