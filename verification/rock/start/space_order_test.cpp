#include "rock/start/space_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "mesh/measures.hpp"
#include "rock/start/borehole.hpp"

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
RC_GTEST_PROP(SpaceOrder, of_points_does_not_know_their_numbers, ()) {
  std::vector<Vec3> points;
  for (int k = 0; k < 40; ++k) points.push_back(*battery::point(1.0));
  constexpr double cube = 1e-2;  // so small that no two points are in one
  const std::vector<int> order = order_of_space(points, cube);
  std::ranges::reverse(points);
  const std::vector<int> other = order_of_space(points, cube);
  for (std::size_t i = 0; i < points.size(); ++i) RC_ASSERT(other[i] == 39 - order[i]);
}

TEST(SpaceOrder, is_the_same_when_it_is_asked_for_again) {
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
