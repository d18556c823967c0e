#include "rock/start/borehole.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/surface.hpp"
#include "rock/start/space_order.hpp"
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
RC_GTEST_PROP(Borehole, has_edges_near_the_requested_length, ()) {
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

const Roughness rough{2e-3, 10e-3, 11};

mesh::TriangleMesh bottom(const Roughness& r) {
  mesh::TriangleMesh m = borehole(flat_bottom(0.1, 0.02, 0.03), 0.005);
  roughen_bottom(m, r);
  return m;
}

/// Mean over surfaces of seeds 1 to n of the product of heights at distance d, over amplitude^2.
double correlation(double d, int n) {
  double sum = 0.0;
  for (int seed = 1; seed <= n; ++seed) {
    const Roughness r{rough.amplitude, rough.correlation_length, static_cast<std::uint64_t>(seed)};
    const std::vector<Wave> waves = rough_waves(r);
    sum += roughness_at(r, waves, 0.01, 0.02) * roughness_at(r, waves, 0.01 + d, 0.02);
  }
  return sum / n / (rough.amplitude * rough.amplitude);
}

/// Of n independent products the mean strays by sqrt((1 + rho^2) / n), n = 4000: 0.022.
TEST(RoughBottom, has_its_amplitude_and_correlation) {
  for (const double over : {0.0, 0.5, 1.0, 2.0})
    EXPECT_NEAR(correlation(over * rough.correlation_length, 4000), std::exp(-0.5 * over * over),
                0.045)
        << over;
}

TEST(RoughBottom, is_the_same_for_the_same_seed) {
  EXPECT_TRUE(bottom(rough).positions == bottom(rough).positions);
  EXPECT_FALSE(bottom(rough).positions == bottom({2e-3, 10e-3, 12}).positions);
}

TEST(RoughBottom, goes_down_from_the_flat_one_and_leaves_the_rim) {
  const mesh::TriangleMesh flat = borehole(flat_bottom(0.1, 0.02, 0.03), 0.005), m = bottom(rough);
  double least = 1.0, most = 0.0;
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    const Vec3 way = m.positions[v] - flat.positions[v];
    EXPECT_EQ(way.head<2>(), Eigen::Vector2d::Zero());
    if (flat.positions[v].z() == -0.01) {
      EXPECT_EQ(way.z(), 0.0);
    }
    if (flat.positions[v].z() < 0.02) continue;
    least = std::min(least, way.z());
    most = std::max(most, way.z());
  }
  EXPECT_EQ(least, 0.0);
  EXPECT_GT(most, 4.0 * rough.amplitude);
}

}  // namespace tdbd::rock::borehole_test

namespace tdbd::rock::space_order_test {

using Corners = std::array<std::array<double, 3>, 3>;

/// Triangles by the places of their corners, in a fixed order: the same whatever the numbers.
std::vector<Corners> shape_of(const mesh::TriangleMesh& m) {
  std::vector<Corners> shape;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& x = mesh::position(m, m.triangles[t][k]);
      corners[k] = {x.x(), x.y(), x.z()};
    }
    shape.push_back(corners);
  }
  std::ranges::sort(shape);
  return shape;
}

mesh::TriangleMesh hole(double edge_length) {
  return borehole(with_wall({{0.0, 0.05}, {0.03, 0.06}, {0.1, 0.04}}, 0.02), edge_length);
}

/// Pages of 64 vertices that hold what lies within `radius` of every 97th vertex, summed.
std::size_t pages_of_places(const mesh::TriangleMesh& m, double radius) {
  std::size_t sum = 0;
  for (std::size_t centre = 0; centre < m.positions.size(); centre += 97) {
    std::set<std::size_t> pages;
    for (std::size_t v = 0; v < m.positions.size(); ++v)
      if ((m.positions[v] - m.positions[centre]).norm() < radius) pages.insert(v / 64);
    sum += pages.size();
  }
  return sum;
}

RC_GTEST_PROP(SpaceOrder, keeps_every_triangle_its_corners_and_its_side, ()) {
  const double edge = 1e-3 * *rc::gen::inRange(4, 30), cube = 1e-3 * *rc::gen::inRange(1, 300);
  const mesh::TriangleMesh m = hole(edge), sorted = in_order_of_space(m, cube);
  RC_ASSERT(sorted.positions.size() == m.positions.size());
  RC_ASSERT(shape_of(sorted) == shape_of(m));
}

/// Cubes by z, y, x, and in each its vertices by their cells.
RC_GTEST_PROP(SpaceOrder, of_a_surface_goes_cube_by_cube_and_cell_by_cell, ()) {
  const double cube = 1e-3 * *rc::gen::inRange(1, 300);
  const mesh::TriangleMesh m = hole(1e-3 * *rc::gen::inRange(4, 30));
  std::vector<PlacedVertex> placed;
  std::vector<int> order;
  order_of_space(mesh::make_surface(m), cube, placed, order);
  RC_ASSERT(std::set<int>(order.begin(), order.end()).size() == m.positions.size());
  const Vec3 lo = mesh::bounding_box(m).lo;
  std::array<double, 6> last{};
  for (const int v : order) {
    const Vec3 cell = ((m.positions[at(v)] - lo) * (4.0 / cube)).array().floor();
    const Vec3 whole = (0.25 * cell).array().floor();
    const std::array<double, 6> place{whole.z(), whole.y(), whole.x(),
                                      cell.z(),  cell.y(),  cell.x()};
    RC_ASSERT(last <= place);
    last = place;
  }
}

/// Places, not numbers, make the order: given backwards, points come out in the same one.
RC_GTEST_PROP(SpaceOrder, of_points_does_not_depend_on_their_numbers, ()) {
  std::vector<Vec3> points;
  for (int k = 0; k < 40; ++k) points.push_back(*battery::point(1.0));
  constexpr double cube = 1e-2;  // so small that no two points are in one
  const std::vector<int> order = order_of_space(points, cube);
  std::ranges::reverse(points);
  const std::vector<int> other = order_of_space(points, cube);
  for (std::size_t i = 0; i < points.size(); ++i) RC_ASSERT(other[i] == 39 - order[i]);
}

TEST(SpaceOrder, is_the_same_when_it_is_computed_again) {
  const mesh::TriangleMesh once = in_order_of_space(hole(0.004), 0.032),
                           twice = in_order_of_space(once, 0.032);
  EXPECT_EQ(once.positions, twice.positions);
  EXPECT_EQ(once.triangles, twice.triangles);
}

TEST(SpaceOrder, brings_what_is_near_into_few_pages) {
  const mesh::TriangleMesh m = hole(0.002);
  const std::size_t by_rings = pages_of_places(m, 0.008),
                    by_place = pages_of_places(in_order_of_space(m, 0.016), 0.008);
  EXPECT_LT(static_cast<double>(by_place), 0.7 * static_cast<double>(by_rings));
}

}  // namespace tdbd::rock::space_order_test
