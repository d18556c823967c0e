#include "mesh/shape/convex.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/tolerance.hpp"
#include "mesh/measures.hpp"
#include "reference/rock/brute_force_exit.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::convex_test {

constexpr double rounding = 1e-15;  // of a length, over the size of the mesh

double size_of(const TriangleMesh& m) { return bounding_box(m).size().norm(); }

/// How far x is behind plane i, m.
double behind(const ConvexSolid& s, std::size_t i, const Vec3& x) {
  return s.b[i] - Vec3(s.nx[i], s.ny[i], s.nz[i]).dot(x);
}

double depth(const ConvexSolid& s, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < s.planes; ++i) least = std::min(least, behind(s, i, x));
  return least;
}

/// The farthest that any vertex stands out of any triangle's plane, over the mesh's size.
double dent(const TriangleMesh& m) {
  double farthest = 0.0;
  for (const auto& [a, b, c] : m.triangles) {
    const Vec3 n = area_vector(m.positions[a], m.positions[b], m.positions[c]).normalized();
    for (const Vec3& x : m.positions) farthest = std::max(farthest, n.dot(x - m.positions[a]));
  }
  return farthest / size_of(m);
}

RC_GTEST_PROP(ConvexSolid, holds_every_vertex_behind_unit_planes_that_touch, ()) {
  const TriangleMesh m = battery::placed(*battery::pose(2.0), *battery::convex_polyhedron());
  const auto solid = convex_solid(m);
  RC_ASSERT(solid.has_value());
  for (std::size_t i = 0; i < solid->planes; ++i) {
    RC_ASSERT(std::abs(Vec3(solid->nx[i], solid->ny[i], solid->nz[i]).norm() - 1.0) < rounding);
    double least = std::numeric_limits<double>::infinity();
    int touching = 0;
    for (const Vec3& x : m.positions) {
      least = std::min(least, behind(*solid, i, x));
      touching += behind(*solid, i, x) < tolerance::convex * size_of(m);
    }
    RC_ASSERT(std::abs(least) < 4.0 * rounding * (size_of(m) + 2.0));
    RC_ASSERT(touching >= 3);
  }
}

/// Points nearer to the surface than the tolerance may be on either side.
RC_GTEST_PROP(ConvexSolid, inside_equals_the_winding_number, ()) {
  const TriangleMesh m = *battery::convex_polyhedron();
  const auto solid = convex_solid(m);
  const Vec3 x = *battery::point(1.1);
  const double d = depth(*solid, x);
  RC_PRE(std::abs(d) > 2.0 * tolerance::convex * size_of(m));
  RC_TAG(d > 0.0 ? "inside" : "outside");
  RC_ASSERT(reference::inside(m, x) == (d > 0.0));
}

TEST(ConvexSolid, joins_coplanar_triangles) {
  EXPECT_EQ(convex_solid(battery::box({-1, -2, -3}, {1, 2, 3}))->planes, 6U);
  EXPECT_EQ(convex_solid(battery::cylinder(6.7e-3, 13e-3, 32))->planes, 34U);
  EXPECT_EQ(convex_solid(battery::sphere(1.0, 2))->planes, 320U);
}

/// As a binary STL file holds it.
RC_GTEST_PROP(ConvexSolid, survives_single_precision, ()) {
  TriangleMesh m = battery::placed(*battery::pose(0.0), battery::cylinder(6.7e-3, 2e-3, 32));
  for (Vec3& x : m.positions) x = x.cast<float>().cast<double>();
  const auto solid = convex_solid(m);
  RC_ASSERT(solid.has_value());
  RC_ASSERT(solid->planes == 34U);
}

RC_GTEST_PROP(ConvexSolid, rejects_dents_and_only_dents, ()) {
  const TriangleMesh m = *rc::gen::oneOf(battery::star_shape(), battery::convex_polyhedron());
  const double d = dent(m);
  RC_PRE(d < 0.9 * tolerance::convex || d > 2.0 * tolerance::convex);
  RC_TAG(d > tolerance::convex ? "dented" : "convex");
  RC_ASSERT(convex_solid(m).has_value() == (d < tolerance::convex));
}

/// The middle of a box's face is pushed in by a fraction of the box's size.
TEST(ConvexSolid, accepts_up_to_its_tolerance) {
  const auto pressed = [](double part) {
    TriangleMesh m = battery::cylinder(1.0, 1.0, 8);
    m.positions.back().z() -= part * size_of(m);
    return m;
  };
  EXPECT_TRUE(convex_solid(pressed(0.1 * tolerance::convex)));
  EXPECT_FALSE(convex_solid(pressed(10.0 * tolerance::convex)));
  EXPECT_FALSE(convex_solid(battery::torus(3.0, 1.0, 12, 8)));
}

double number(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 10001) / 10000.0;
}

TriangleMesh unit_box() {
  TriangleMesh m;
  for (int k = 0; k < 8; ++k) m.positions.emplace_back(k & 1, (k >> 1) & 1, k >> 2);
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

/// A double pyramid over n corners, stretched: convex, with edges in all directions.
TriangleMesh any_double_pyramid() {
  TriangleMesh m;
  const int n = *rc::gen::inRange(3, 20);
  const double a = number(0.2, 2), b = number(0.2, 2);
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::acos(-1.0) * k / n;
    m.positions.emplace_back(a * std::cos(angle), b * std::sin(angle), 0.0);
    m.triangles.push_back({k, (k + 1) % n, n});
    m.triangles.push_back({(k + 1) % n, k, n + 1});
  }
  m.positions.emplace_back(0, 0, number(0.2, 2));
  m.positions.emplace_back(0, 0, -number(0.2, 2));
  return m;
}

bool is_closed(const TriangleMesh& m) {
  std::map<std::pair<int, int>, int> count;
  for (const Triangle& t : m.triangles)
    for (int k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, times] : count)
    if (times != 1 || !count.contains({edge.second, edge.first})) return false;
  return true;
}

bool is_convex(const TriangleMesh& m) {
  for (const Triangle& t : m.triangles) {
    const Vec3& a = m.positions[t[0]];
    const Vec3 n = area_vector(a, m.positions[t[1]], m.positions[t[2]]);
    for (const Vec3& p : m.positions)
      if (n.dot(p - a) > 1e-12) return false;
  }
  return true;
}

TEST(ClipConvex, cuts_a_slab_and_a_corner_off_a_box) {
  EXPECT_NEAR(enclosed_volume(clipped_convex(unit_box(), Vec3::UnitX(), 0.25)), 0.25, 1e-16);
  const Vec3 n = Vec3::Constant(std::sqrt(1.0 / 3.0));
  EXPECT_NEAR(enclosed_volume(clipped_convex(unit_box(), n, 0.6 * n.x())), 0.216 / 6, 1e-16);
}

TEST(ClipConvex, leaves_all_or_nothing_when_the_plane_misses) {
  EXPECT_EQ(clipped_convex(unit_box(), Vec3::UnitX(), 1.0).positions, unit_box().positions);
  EXPECT_TRUE(clipped_convex(unit_box(), Vec3::UnitX(), 0.0).triangles.empty());
  EXPECT_TRUE(clipped_convex(unit_box(), Vec3::UnitX(), -1.0).triangles.empty());
}

/// The plane may miss a vertex by 1e-12 of the size and still pass through it; by more it cuts it off.
TEST(ClipConvex, takes_a_vertex_for_on_the_plane_up_to_its_slack) {
  TriangleMesh box = unit_box();
  for (Vec3& x : box.positions) x = Vec3(x.x(), 2.0 * x.y(), 2.0 * (x.z() - 1.0));  // diagonal 3
  const double slack = 1e-12 * 3.0;
  EXPECT_EQ(clipped_convex(box, Vec3::UnitZ(), -slack).positions, box.positions);
  EXPECT_NE(clipped_convex(box, Vec3::UnitZ(), -1.01 * slack).positions, box.positions);
}

TEST(ClipConvex, passes_through_vertices_without_slivers) {
  const Vec3 n(std::sqrt(0.5), -std::sqrt(0.5), 0.0);
  const TriangleMesh half = clipped_convex(unit_box(), n, 0.0);
  EXPECT_NEAR(enclosed_volume(half), 0.5, 1e-16);
  EXPECT_TRUE(is_closed(half));
  for (const Triangle& t : half.triangles)
    EXPECT_GT(area_vector(half.positions[t[0]], half.positions[t[1]], half.positions[t[2]]).norm(),
              0.1);
}

RC_GTEST_PROP(ClipConvex, makes_two_closed_convex_pieces_of_the_whole, ()) {
  const TriangleMesh m = any_double_pyramid();
  const Vec3 n = Vec3(number(-1, 1), number(-1, 1), number(0.1, 1)).normalized();
  const double b = number(-0.5, 0.5);
  const TriangleMesh lower = clipped_convex(m, n, b), upper = clipped_convex(m, -n, -b);
  double volume = 0.0;
  for (const TriangleMesh& piece : {lower, upper}) {
    RC_ASSERT(is_closed(piece));
    RC_ASSERT(is_convex(piece));
    if (!piece.triangles.empty()) volume += enclosed_volume(piece);
  }
  for (const Vec3& x : lower.positions) RC_ASSERT(n.dot(x) < b + 1e-14);
  RC_ASSERT(std::abs(volume - enclosed_volume(m)) < 1e-14);
}

}  // namespace tdbd::mesh::convex_test
