#include "reference/rock/brute_force_exit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/exact_volume.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "reference/rock/close_surface.hpp"
#include "reference/rock/prism.hpp"
#include "reference/rock/swept_boolean.hpp"
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

/// Coordinates are at most 2: sums of products of three are good to some units of 8 * 1e-16.
constexpr double rounding = 1e-14;

rc::Gen<Corners> corners(double half) {
  const auto p = battery::point(half);
  return rc::gen::apply(
      [](const Vec3& a, const Vec3& b, const Vec3& c) {
        return Corners{a, b, c};
      },
      p, p, p);
}

TriangleMesh as_mesh(const Corners& x) { return {{x[0], x[1], x[2]}, {{0, 1, 2}}}; }

Corners corners_of(const TriangleMesh& m, const mesh::Triangle& t) {
  return {m.positions[t[0]], m.positions[t[1]], m.positions[t[2]]};
}

double sum_of_prisms(const TriangleMesh& from, const TriangleMesh& to) {
  double sum = 0.0;
  for (const mesh::Triangle& t : from.triangles)
    sum += prism_volume(corners_of(from, t), corners_of(to, t));
  return sum;
}

TEST(PrismVolume, of_a_straight_push_is_area_times_depth) {
  const Corners top{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0)};  // normal along -z, as the rock's
  Corners bottom = top;
  for (Vec3& x : bottom) x.z() += 0.25;
  EXPECT_DOUBLE_EQ(prism_volume(top, bottom), 0.125);
}

/// One corner goes: a tetrahedron.
TEST(PrismVolume, of_one_moved_corner_is_a_tetrahedron) {
  const Corners top{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0)};
  Corners bottom = top;
  bottom[1] += Vec3(0.3, -7.0, 0.6);
  EXPECT_NEAR(prism_volume(top, bottom), 0.1, rounding);
}

/// det J has degree 2 in zeta: two Gauss points are exact, one would not be.
RC_GTEST_PROP(PrismVolume, equals_the_exact_integral, ()) {
  const Corners from = *corners(1.0), to = *corners(1.0);
  const double exact = reference::removed_volume_exact(as_mesh(from), as_mesh(to));
  RC_ASSERT(std::abs(prism_volume(from, to) - exact) < rounding);
}

/// The same by many thin slabs, each a straight prism between its middle's triangles.
RC_GTEST_PROP(PrismVolume, is_the_limit_of_thin_slabs, ()) {
  const Corners from = *corners(1.0), to = *corners(1.0);
  const auto by_slabs = [&](int slabs) {
    double sum = 0.0;
    for (int k = 0; k < slabs; ++k) {
      Corners x;
      for (std::size_t i = 0; i < 3; ++i) x[i] = from[i] + (k + 0.5) / slabs * (to[i] - from[i]);
      const Vec3 push = ((to[0] - from[0]) + (to[1] - from[1]) + (to[2] - from[2])) / 3.0 / slabs;
      sum -= mesh::area_vector(x[0], x[1], x[2]).dot(push);
    }
    return sum;
  };
  const double V = prism_volume(from, to);
  const double coarse = std::abs(by_slabs(4) - V), fine = std::abs(by_slabs(8) - V);
  RC_ASSERT(std::abs(fine - coarse / 4.0) < rounding);  // the middle rule on a quadratic
}

RC_GTEST_PROP(PrismVolume, changes_sign_with_time_and_with_the_normal, ()) {
  const Corners a = *corners(1.0), b = *corners(1.0);
  const double V = prism_volume(a, b);
  RC_ASSERT(std::abs(prism_volume(b, a) + V) < rounding);
  RC_ASSERT(std::abs(prism_volume({a[0], a[2], a[1]}, {b[0], b[2], b[1]}) + V) < rounding);
  RC_ASSERT(std::abs(prism_volume({a[1], a[2], a[0]}, {b[1], b[2], b[0]}) - V) < rounding);
}

RC_GTEST_PROP(PrismVolume, of_two_halves_of_a_way_adds_up, ()) {
  const Corners a = *corners(1.0), c = *corners(1.0);
  const double part = *battery::number(0.0, 1.0);
  Corners b;
  for (std::size_t i = 0; i < 3; ++i) b[i] = (1.0 - part) * a[i] + part * c[i];
  RC_ASSERT(std::abs(prism_volume(a, b) + prism_volume(b, c) - prism_volume(a, c)) < rounding);
}

RC_GTEST_PROP(PrismVolume, does_not_depend_on_the_frame, ()) {
  const Corners a = *corners(1.0), b = *corners(1.0);
  const Pose X = *battery::pose(1.0);
  const double there = prism_volume({X * a[0], X * a[1], X * a[2]}, {X * b[0], X * b[1], X * b[2]});
  RC_ASSERT(std::abs(there - prism_volume(a, b)) < 4.0 * rounding);
}

/// Neighbours share their ruled sides, however every vertex moves. Scale: the cube of side 2.
RC_GTEST_PROP(PrismVolume, summed_over_a_closed_surface_is_the_change_of_its_volume, ()) {
  const TriangleMesh before = *battery::star_shape();
  TriangleMesh after = before;
  for (Vec3& x : after.positions) x += *battery::point(0.5);
  const double lost = enclosed_volume_exact(before) - enclosed_volume_exact(after);
  RC_ASSERT(std::abs(sum_of_prisms(before, after) - lost) < 1e-12 * 8.0);
}

}  // namespace tdbd::reference::brute_force_exit_test

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

TEST(CloseSurface, rejects_a_bottom_that_is_too_high) {
  TriangleMesh dented = battery::flat_rock(1.0, 0.0, 2);
  dented.positions[4].z() = 0.5;
  EXPECT_THROW(close_surface(dented, 0.5), RunError);
}

TEST(CloseSurface, rejects_a_boundary_that_is_not_level) {
  TriangleMesh tilted = battery::flat_rock(1.0, 0.0, 2);
  tilted.positions[0].z() = -0.1;
  EXPECT_THROW(close_surface(tilted, 1.0), RunError);
}

TEST(CloseSurface, rejects_closed_surfaces_and_holes) {
  EXPECT_THROW(close_surface(battery::box({0, 0, 0}, {1, 1, 1}), 2.0), RunError);
  TriangleMesh pierced = battery::flat_rock(1.0, 0.0, 4);
  pierced.triangles.erase(pierced.triangles.begin() + 10);  // away from the outer boundary
  EXPECT_THROW(close_surface(pierced, 1.0), RunError);
}

}  // namespace tdbd::reference::close_surface_test

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
