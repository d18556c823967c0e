#include "mesh/shape/clip_convex.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>

#include "mesh/measures.hpp"

namespace tdbd::mesh::clip_convex_test {

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

}  // namespace tdbd::mesh::clip_convex_test
