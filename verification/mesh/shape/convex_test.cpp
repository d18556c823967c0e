#include "mesh/shape/convex.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

RC_GTEST_PROP(ConvexSolid, refuses_dents_and_only_dents, ()) {
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

}  // namespace tdbd::mesh::convex_test
