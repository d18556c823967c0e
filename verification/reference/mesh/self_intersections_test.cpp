#include "reference/mesh/self_intersections.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::self_intersections_test {

using mesh::TriangleMesh;
using Pairs = std::vector<std::pair<int, int>>;

/// Two triangles without a common vertex; the second one pierces the first, or stays above it.
TriangleMesh two_triangles(double lowest) {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, lowest}, {2, 1, 2}, {1, 2, 2}},
          {{0, 1, 2}, {3, 4, 5}}};
}

TEST(SelfIntersections, finds_the_piercing_pair_and_no_other) {
  EXPECT_EQ(self_intersections(two_triangles(-1.0)), (Pairs{{0, 1}}));
  EXPECT_EQ(self_intersections(two_triangles(1.0)), Pairs{});
}

TEST(SelfIntersections, touching_without_a_common_vertex_counts) {
  EXPECT_EQ(self_intersecting_pairs(two_triangles(0.0)), 1u);
}

/// The inner vertex of a flat rock leaves its ring sideways: triangles fold over each other.
TEST(SelfIntersections, finds_a_fold) {
  TriangleMesh m = battery::flat_rock(1.0, 0.0, 2);
  EXPECT_EQ(self_intersecting_pairs(m), 0u);
  m.positions[4] = Vec3(3, 0.5, 0);
  EXPECT_GT(self_intersecting_pairs(m), 0u);
}

TEST(SelfIntersections, refuses_what_is_not_an_oriented_manifold) {
  TriangleMesh m = two_triangles(1.0);
  m.triangles.push_back({0, 1, 3});
  EXPECT_THROW(self_intersections(m), RunError);
}

RC_GTEST_PROP(SelfIntersections, star_shapes_have_none, ()) {
  RC_ASSERT(self_intersecting_pairs(*battery::star_shape()) == 0u);
}

}  // namespace tdbd::reference::self_intersections_test
