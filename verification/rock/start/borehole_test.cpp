#include "rock/start/borehole.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/surface.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::rock::borehole_test {

using mesh::TriangleMesh;
constexpr double pi = std::numbers::pi;
constexpr double radius = 0.1, wall = 0.03, cone_depth = 0.025;  // m

/// A bit-like bottom: cone, nose and shoulder, z = a (cos(1.5 pi r / R) - 1), finely sampled.
std::vector<MeridianPoint> cone_and_nose(double depth) {
  std::vector<MeridianPoint> curve;
  constexpr int samples = 20000;
  for (int i = 0; i <= samples; ++i) {
    const double s = static_cast<double>(i) / samples;
    curve.push_back({radius * s, -depth * std::cos(1.5 * pi * s)});
  }
  return curve;
}

/// Volume between that bottom and the plane z = -wall (the bottom's rim is at z = 0), exact:
/// 2 pi integral of (z + wall) r dr.
double exact_volume(double depth) {
  const double a = 1.5 * pi;  // integral of s cos(a s) over [0, 1]
  const double moment = std::sin(a) / a + (std::cos(a) - 1.0) / (a * a);
  return 2.0 * pi * radius * radius * (0.5 * wall - depth * moment);
}

TriangleMesh bit_like(double edge_length) {
  return borehole(with_wall(cone_and_nose(cone_depth), wall), edge_length);
}

RC_GTEST_PROP(Borehole, is_a_disc_whatever_its_curve, ()) {
  const double depth = *battery::number(0.0, 0.05), height = *battery::number(0.0, 0.05);
  const double edge_length = *battery::number(0.003, 0.03);
  const TriangleMesh m = borehole(with_wall(cone_and_nose(depth), height), edge_length);
  RC_ASSERT(mesh::describe(mesh::check_surface(m)) == "");
}

RC_GTEST_PROP(Borehole, has_its_boundary_on_the_last_ring_alone, ()) {
  const double edge_length = *battery::number(0.003, 0.03);
  const TriangleMesh m = bit_like(edge_length);
  const mesh::Surface s = mesh::make_surface(m);
  for (int v = 0; v < s.vertex_slots(); ++v)
    RC_ASSERT(s.is_boundary(v) == (std::abs(s.position(v).z() + wall) < 1e-12));
}

/// Edges run along rings (a round number of them, from 6) and between rings. Fewest: 0.6 lengths;
/// longest, across a quadrilateral: 1.6, the limits within which nothing needs maintenance.
RC_GTEST_PROP(Borehole, has_edges_near_the_length_asked_for, ()) {
  const double h = *battery::number(0.002, 0.01);
  const TriangleMesh m = bit_like(h);
  for (const mesh::Triangle& t : m.triangles)
    for (int i = 0; i < 3; ++i) {
      const double length = (m.positions[t[i]] - m.positions[t[(i + 1) % 3]]).norm();
      RC_ASSERT(length > 0.6 * h);
      RC_ASSERT(length < 1.6 * h);
    }
}

/// Up on the bottom, towards the axis on the wall: away from the rock everywhere.
TEST(Borehole, has_normals_that_point_out_of_the_rock) {
  const TriangleMesh m = bit_like(3e-3);
  for (const mesh::Triangle& t : m.triangles) {
    const Vec3 &a = m.positions[t[0]], &b = m.positions[t[1]], &c = m.positions[t[2]];
    const Vec3 n = mesh::area_vector(a, b, c).normalized(), middle = (a + b + c) / 3.0;
    const bool on_wall = middle.z() < -1e-9 && std::hypot(middle.x(), middle.y()) > 0.99 * radius;
    if (on_wall)
      EXPECT_LT(n.dot(Vec3(middle.x(), middle.y(), 0.0)), 0.0);
    else
      EXPECT_LT(n.z(), 0.0);
  }
}

/// Chords of rings and of the curve: second order in the edge length. A ring's number of vertices
/// is round, so the observed order wavers; its least-squares slope over five levels does not.
TEST(Borehole, encloses_the_volume_of_revolution_to_second_order) {
  constexpr int levels = 5;
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (int k = 0; k < levels; ++k) {
    const double h = 0.012 * std::pow(0.5, k);
    const mesh::Surface s = mesh::make_surface(bit_like(h));
    const double volume = mesh::hole_volume(s, Vec3(0, 0, -wall));
    const double error = std::abs(volume / exact_volume(cone_depth) - 1.0);
    std::printf("  edge length %6.3f mm: relative error of the volume %.2e\n", 1e3 * h, error);
    const double x = std::log(h), y = std::log(error);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double order = (levels * sxy - sx * sy) / (levels * sxx - sx * sx);
  std::printf("  observed order %.3f\n", order);
  EXPECT_GT(order, 1.85);
  EXPECT_LT(order, 2.5);
}

TEST(Borehole, flat_bottom_is_a_cylinder) {
  const mesh::Surface s = mesh::make_surface(borehole(flat_bottom(radius, 0.2, wall), 1e-3));
  const double volume = mesh::hole_volume(s, Vec3(0, 0, 0.2 - wall));
  EXPECT_NEAR(volume / (pi * radius * radius * wall), 1.0, 2.1e-4);
}

}  // namespace tdbd::rock::borehole_test
