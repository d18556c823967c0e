#include "reference/rock/prism.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "mesh/measures.hpp"
#include "reference/mesh/exact_volume.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::reference::prism_test {

using mesh::TriangleMesh;

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

}  // namespace tdbd::reference::prism_test
