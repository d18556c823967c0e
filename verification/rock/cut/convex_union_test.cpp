#include "rock/cut/convex_union.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "bit/cutter/cutter_parts.hpp"
#include "mesh/shape/clip_convex.hpp"
#include "rock/cut/swept_convex.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::convex_union_test {

using mesh::TriangleMesh;

std::vector<ConvexPiece> pieces_of(const std::vector<TriangleMesh>& meshes) {
  std::vector<ConvexPiece> pieces;
  for (const TriangleMesh& m : meshes) pieces.push_back({*mesh::convex_solid(m), m});
  return pieces;
}

/// A cutter of 8 mm radius, in its own frame, worn by `wear` (m).
bit::Cutter cutter(double chamfer, double land, double wear) {
  bit::Cutter c;
  c.diameter = 16e-3;
  c.chamfer = chamfer;
  c.chamfer_angle = 0.25 * std::numbers::pi;
  c.land = land;
  c.land_angle = 0.4 * std::numbers::pi;
  c.length = 13e-3;
  c.table_thickness = 2e-3;
  c.wear = wear;
  c.X_BC = {Vec3(1, -1, -1).asDiagonal().toDenseMatrix(), Vec3::Zero()};  // the tip is at -Z
  return c;
}

std::vector<TriangleMesh> meshes_of(const bit::Cutter& c) {
  std::vector<TriangleMesh> meshes;
  for (const bit::Part& p : bit::cutter_parts(c, {})) meshes.push_back(p.mesh_P);
  return meshes;
}

/// The middles of its triangles and of their edges.
std::vector<Vec3> places_of(const TriangleMesh& m) {
  std::vector<Vec3> places;
  for (const auto& [i, j, k] : m.triangles) {
    const Vec3 &a = m.positions[i], &b = m.positions[j], &c = m.positions[k];
    for (const Vec3& x :
         {Vec3((a + b + c) / 3.0), Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a))})
      places.push_back(x);
  }
  return places;
}

/// Sharp, with a chamfer, with a land besides; new and worn.
class ConvexUnionOfCutter : public testing::TestWithParam<bit::Cutter> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ConvexUnionOfCutter,
                         testing::Values(cutter(0, 0, 0), cutter(3e-4, 0, 0), cutter(3e-4, 2e-4, 0),
                                         cutter(0, 0, 1e-3), cutter(3e-4, 0, 1e-3),
                                         cutter(3e-4, 2e-4, 1e-3)));

/// A place on the union's surface belongs to the part that has it on its own surface; of several,
/// as at the edge between chamfer and body, where most exits are, to the first, whatever the plane.
TEST_P(ConvexUnionOfCutter, has_an_owner_for_every_place) {
  const std::vector<TriangleMesh> meshes = meshes_of(GetParam());
  const std::vector<ConvexPiece> pieces = pieces_of(meshes);
  const auto whole = convex_union(pieces);
  ASSERT_TRUE(whole.has_value());
  long places = 0;
  for (const TriangleMesh& m : meshes)
    for (const Vec3& x : places_of(m))
      for (std::size_t k = 0; k < whole->solid_P.planes; ++k) {
        if (std::abs(mesh::normal(whole->solid_P, k).dot(x) - whole->solid_P.b[k]) > 1e-10)
          continue;
        std::size_t first = 0;
        while (depth_inside(pieces[first].solid_P, x) < -1e-10) ++first;
        EXPECT_EQ(owner_at(whole->claims, k, x), static_cast<int>(first));
        ++places;
      }
  EXPECT_GT(places, 1500);
}

/// No point of a part is outside, and none outside all parts is inside.
TEST_P(ConvexUnionOfCutter, is_what_the_parts_fill) {
  const std::vector<ConvexPiece> pieces = pieces_of(meshes_of(GetParam()));
  const auto whole = convex_union(pieces);
  ASSERT_TRUE(whole.has_value());
  for (int i = -10; i <= 10; ++i)
    for (int j = -10; j <= 10; ++j)
      for (int k = 0; k <= 20; ++k) {
        const Vec3 x(-0.713e-3 * k, 0.917e-3 * i, 0.873e-3 * j);
        double depth = -1.0;
        for (const ConvexPiece& p : pieces) depth = std::max(depth, depth_inside(p.solid_P, x));
        EXPECT_EQ(depth > -1e-12, depth_inside(whole->solid_P, x) > -1e-12) << x.transpose();
      }
}

/// A convex solid cut in three, in any order, is found again.
RC_GTEST_PROP(ConvexUnion, of_a_solid_cut_in_pieces_is_the_solid, ()) {
  const TriangleMesh m = *battery::convex_polyhedron();
  const Vec3 n = *battery::direction(), o = *battery::direction();
  const double level = *battery::number(-0.3, 0.3);
  std::vector<TriangleMesh> meshes{mesh::clipped_convex(m, n, level),
                                   mesh::clipped_convex(m, -n, -level)};
  RC_PRE(!meshes[0].triangles.empty() && !meshes[1].triangles.empty());
  const double second = *battery::number(-0.3, 0.3);
  const TriangleMesh upper = meshes[1];
  meshes[1] = mesh::clipped_convex(upper, o, second);
  meshes.push_back(mesh::clipped_convex(upper, -o, -second));
  for (const TriangleMesh& piece : meshes) {
    RC_PRE(!piece.triangles.empty());
    RC_PRE(mesh::convex_solid(piece).has_value());
  }
  const auto whole = convex_union(pieces_of(meshes));
  RC_ASSERT(whole.has_value());
  const Vec3 x = *battery::point(1.0);
  RC_ASSERT(std::abs(depth_inside(whole->solid_P, x) - depth_inside(*mesh::convex_solid(m), x)) <
            1e-12);
}

TEST(ConvexUnion, is_refused_of_pieces_that_do_not_fill_a_convex_solid) {
  const TriangleMesh cube = battery::box({0, 0, 0}, {1, 1, 1});
  const auto with = [&](const Vec3& lo, const Vec3& hi) {
    return convex_union(pieces_of({cube, battery::box(lo, hi)})).has_value();
  };
  EXPECT_TRUE(with({1, 0, 0}, {2, 1, 1}));            // beside it
  EXPECT_TRUE(with({0.5, 0, 0}, {2, 1, 1}));          // across its side
  EXPECT_TRUE(with({0.2, 0.2, 0.2}, {1, 0.5, 0.5}));  // within it
  EXPECT_FALSE(with({1, 0, 0}, {2, 1, 0.9}));         // a step
  EXPECT_FALSE(with({1.001, 0, 0}, {2, 1, 1}));       // a gap
  EXPECT_FALSE(with({3, 0, 0}, {4, 1, 1}));           // far away
  EXPECT_FALSE(with({0.4, 0.4, 0}, {0.6, 0.6, 2}));   // out of its top
}

}  // namespace tdbd::rock::convex_union_test
