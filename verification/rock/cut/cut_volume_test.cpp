#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "bit/cutter/cutter.hpp"
#include "core/random.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"
#include "reference/mesh/exact_volume.hpp"
#include "reference/rock/close_surface.hpp"
#include "reference/rock/prism.hpp"
#include "reference/rock/swept_boolean.hpp"
#include "rock/cut/convex_union.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/cut/swept_part.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::cut_volume_test {

constexpr double depth = 0.15, advance = 0.317;         // m
const Vec3 heading(std::cos(0.4), std::sin(0.4), 0.0);  // oblique to the rock's rows

/// A disc on edge, as a cutter without back rake: radius 0.4, its axis along the heading, 0.15 deep
/// in the rock. Its widest part is above the surface, so that no rock is left hanging over its
/// groove.
bit::Bit upright_disc() {
  bit::Part p;
  p.name = "disc";
  p.mesh_P = battery::cylinder(0.4, 0.1, 24);
  p.X_BP.R.col(2) = heading;
  p.X_BP.R.col(1) = Vec3::UnitZ();
  p.X_BP.R.col(0) = Vec3::UnitZ().cross(heading);
  bit::Bit b;
  b.parts = {p};
  return b;
}

Pose at(const Vec3& place, double way) {
  return {Mat3::Identity(), place + way * heading + Vec3(0, 0, depth - 0.4)};
}

/// What the program removes from flat rock of n x n cells, with the disc at a place.
double removed(int n, const Vec3& place) {
  const mesh::TriangleMesh flat = battery::flat_rock(0.8, 0.0, n);
  Rock rock = make_rock(mesh::make_surface(flat), 3.2 / n, mesh::bounding_box(flat));
  CutWorkspace work;
  CutReport report;
  cut_rock(rock, prepare_cutting_bit(upright_disc()), at(place, 0.0), at(place, advance), work,
           report);
  return report.removed;
}

/// Exact, by CGAL's booleans.
double twin() {
  const bit::Bit b = upright_disc();
  const auto block = reference::close_surface(battery::flat_rock(0.8, 0.0, 2), 1.0);
  const Pose X_BP = b.parts.front().X_BP;
  return reference::swept_boolean(block, b.parts.front().mesh_P,
                                  {at(Vec3::Zero(), 0.0) * X_BP, at(Vec3::Zero(), advance) * X_BP})
      .removed;
}

/// The rock's mesh resolves a groove's upright walls to an edge length, so the order is 1 or
/// better; the mean over places on the mesh falls faster, because what is missed at one wall is
/// taken at another.
TEST(CutRock, removes_what_the_exact_boolean_does_as_edges_shrink) {
  const double exact = twin();
  constexpr int places = 40;
  double before = 0.0, first = 0.0;
  for (const int n : {16, 32, 64, 128, 256}) {
    Random random{5};
    double square = 0.0;
    for (int k = 0; k < places; ++k) {
      const double cell = 1.6 / n;
      const Vec3 place(random.uniform(-cell, cell), random.uniform(-cell, cell), 0.0);
      const Vec3 middle = place - 0.5 * advance * heading;
      const double error = removed(n, middle) / exact - 1.0;
      square += error * error / places;
    }
    const double error = std::sqrt(square);
    std::printf("  edges %.4f of the disc's diameter: error %.2e of the volume, order %.2f\n",
                1.6 / n / 0.8, error, before > 0.0 ? std::log2(before / error) : 0.0);
    first = first > 0.0 ? first : error;
    before = error;
  }
  const double order = std::log2(first / before) / 4.0;
  std::printf("  observed order over all levels: %.2f\n", order);
  EXPECT_GT(order, 0.9);
  EXPECT_LT(before, 3.9e-4);
}

}  // namespace tdbd::rock::cut_volume_test

namespace tdbd::rock::convex_union_test {

using mesh::TriangleMesh;

std::vector<ConvexPart> pieces_of(const std::vector<TriangleMesh>& meshes) {
  std::vector<ConvexPart> pieces;
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
  const std::vector<ConvexPart> pieces = pieces_of(meshes);
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
  const std::vector<ConvexPart> pieces = pieces_of(meshes_of(GetParam()));
  const auto whole = convex_union(pieces);
  ASSERT_TRUE(whole.has_value());
  for (int i = -10; i <= 10; ++i)
    for (int j = -10; j <= 10; ++j)
      for (int k = 0; k <= 20; ++k) {
        const Vec3 x(-0.713e-3 * k, 0.917e-3 * i, 0.873e-3 * j);
        double depth = -1.0;
        for (const ConvexPart& p : pieces) depth = std::max(depth, depth_inside(p.solid_P, x));
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

TEST(ConvexUnion, is_rejected_of_pieces_that_do_not_fill_a_convex_solid) {
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

namespace tdbd::rock::star_volume_test {
namespace {

/// The sheet spans 2 m and moves by up to 0.3 m; sums of some hundred products of its coordinates.
constexpr double rounding = 3e-15 * 8.0;

mesh::Surface random_sheet() {
  return mesh::make_surface(
      battery::bumpy_rock(1.0, *rc::gen::inRange(3, 8), 0.3, *rc::gen::arbitrary<std::uint64_t>()));
}

/// Moves about half of the inner vertices, one after another, and returns the sum of what each removed.
double move_one_by_one(mesh::Surface& s) {
  double sum = 0.0;
  for (int v = 0; v < s.vertex_slots(); ++v) {
    if (s.is_boundary(v) || *rc::gen::arbitrary<bool>()) continue;
    const Vec3 d = *battery::point(0.3);
    sum += star_volume(s, v, d);
    s.place(v, s.position(v) + d);
  }
  return sum;
}

double sum_of_prisms(const mesh::Surface& before, const mesh::Surface& after) {
  double sum = 0.0;
  for (const mesh::Triangle& t : before.triangles)
    sum += reference::prism_volume(
        {before.position(t[0]), before.position(t[1]), before.position(t[2])},
        {after.position(t[0]), after.position(t[1]), after.position(t[2])});
  return sum;
}

}  // namespace

/// Each vertex alone, or all at once along straight lines: the same volume.
RC_GTEST_PROP(StarVolume, summed_over_moves_is_the_sum_of_the_prisms, ()) {
  const mesh::Surface before = random_sheet();
  mesh::Surface after = before;
  const double sum = move_one_by_one(after);
  RC_ASSERT(std::abs(sum - sum_of_prisms(before, after)) < rounding);
}

RC_GTEST_PROP(StarVolume, summed_over_moves_is_what_the_hole_gains, ()) {
  const mesh::Surface before = random_sheet();
  mesh::Surface after = before;
  const double sum = move_one_by_one(after);
  RC_ASSERT(std::abs(sum - (mesh::hole_volume(after, Vec3::Zero()) -
                            mesh::hole_volume(before, Vec3::Zero()))) < rounding);
}

/// The tip of a flat fan of area 2 lowered by 3/4: a pyramid of volume 1/2 is removed.
TEST(StarVolume, of_a_pyramid) {
  mesh::TriangleMesh m{
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0)}, {}};
  for (int i = 0; i < 4; ++i) m.triangles.push_back({0, 1 + i, 1 + (i + 1) % 4});
  EXPECT_DOUBLE_EQ(star_volume(mesh::make_surface(m), 0, Vec3(0.1, 0.2, 0.75)),
                   0.5);  // z points down, the normal up
}

}  // namespace tdbd::rock::star_volume_test
