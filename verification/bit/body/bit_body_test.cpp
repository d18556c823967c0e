#include "bit/body/bit_body.hpp"

#include <gtest/gtest.h>

#include "bit/bit.hpp"
#include "bit/body/blade_body.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/generate.hpp"
#include "bit/generate_design.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit::bit_body_test {

constexpr double gage = 107.95e-3;

TEST(BitBody, is_a_closed_solid_that_never_cuts) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Part body = bit_body(table(letter), 0.4, 7850.0, gage);
    EXPECT_TRUE(is_closed_and_oriented(body.mesh_P));
    EXPECT_GT(mesh::enclosed_volume(body.mesh_P), 0.0);
    EXPECT_EQ(body.cutting, Cutting::never);
    EXPECT_EQ(body.density, 7850.0);
  }
}

TEST(BitBody, stays_inside_the_gage_by_the_setback) {
  const Part body = bit_body(table('b'), 0.4, 7850.0, gage);
  double widest = 0.0;
  for (const Vec3& x : body.mesh_P.positions) widest = std::max(widest, x.head<2>().norm());
  EXPECT_NEAR(widest, gage - 0.4 * 19e-3, 1e-12);
}

/// More setback, less body.
TEST(BitBody, shrinks_with_the_setback) {
  const auto volume = [](double setback) {
    return mesh::enclosed_volume(bit_body(table('c'), setback, 1.0, gage).mesh_P);
  };
  EXPECT_GT(volume(0.3), volume(0.4));
  EXPECT_GT(volume(0.4), volume(0.5));
}

/// The order of the rows of the table has no influence.
TEST(BitBody, does_not_depend_on_the_order_of_the_table) {
  std::vector<Cutter> cutters = table('a');
  const Part forwards = bit_body(cutters, 0.4, 1.0, gage);
  std::ranges::reverse(cutters);
  const Part backwards = bit_body(cutters, 0.4, 1.0, gage);
  EXPECT_EQ(mesh::enclosed_volume(forwards.mesh_P), mesh::enclosed_volume(backwards.mesh_P));
}

constexpr double rounding = 1e-12;  ///< m3; scale: the sizes below, about 1 m

mesh::TriangleMesh placed_cylinder(const Pose& X) {
  mesh::TriangleMesh m =
      surface_of_revolution({{0, 0.4, 1}, {0.3, 0.4, 12}, {0.5, -0.4, 12}, {0, -0.4, 1}});
  for (Vec3& x : m.positions) x = X * x;
  return m;
}

Pose any_pose() {
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  return {q.normalized().toRotationMatrix(),
          {number(-0.6, 0.6), number(-0.6, 0.6), number(-0.6, 0.6)}};
}

/// Two convex solids: clipping one by the other's planes is another way to the same volume.
RC_GTEST_PROP(BodyOverlap, of_convex_solids_is_what_their_planes_leave, ()) {
  const mesh::TriangleMesh a = placed_cylinder(any_pose()), b = placed_cylinder(any_pose());
  const auto planes = mesh::convex_solid(b);
  RC_ASSERT(planes.has_value());
  mesh::TriangleMesh clipped = a;
  for (std::size_t i = 0; i < planes->planes && !clipped.triangles.empty(); ++i)
    clipped = mesh::clipped_convex(clipped, mesh::normal(*planes, i), planes->b[i]);
  const double volume = clipped.triangles.empty() ? 0.0 : mesh::enclosed_volume(clipped);
  RC_ASSERT(std::abs(common_volume(a, b) - volume) < rounding);
  RC_ASSERT(std::abs(common_volume(b, a) - volume) < rounding);
}

Bit bladed() {
  PdcOptions options;
  options.blades = BladeOptions{};
  return pdc_bit("plain", make_layout(plain_design()).cutters, options);
}

/// A body without density has its volume counted elsewhere: nothing is to be taken from it.
TEST(BodyOverlap, is_none_with_a_body_without_density) {
  Bit bit = bladed();
  std::erase_if(bit.parts, [](const Part& p) { return p.cutter >= 0 && p.cutter != 20; });
  EXPECT_GT(cutters_in_body(bit), 0.0);
  bit.parts.back().density = 0.0;
  EXPECT_EQ(cutters_in_body(bit), 0.0);
}

/// A cutter's body and blades: the share of a grid of its points that lies inside.
TEST(BodyOverlap, of_cutters_in_blades_is_what_a_grid_of_points_finds) {
  const Bit bit = bladed();
  const Cutter& c = bit.cutters[20];
  const mesh::TriangleTree blades(bit.parts.back().mesh_P);
  mesh::TriangleMesh body;
  for (const Part& part : bit.parts)
    if (part.cutter == 20 && part.kind == PartKind::cutter_body) body = part.mesh_P;
  for (Vec3& x : body.positions) x = c.X_BC * x;
  constexpr int steps = 60;
  int hits = 0, points = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < steps; ++k) {
        const double y = (2.0 * j + 1) / steps - 1, z = (2.0 * k + 1) / steps - 1;
        if (y * y + z * z >= 1.0) continue;
        const double front = chamfer_depth(c),
                     depth = front + (c.length - front) * (i + 0.5) / steps;
        ++points;
        hits += mesh::inside(blades, c.X_BC * Vec3(-depth, y * c.diameter / 2, z * c.diameter / 2));
      }
  const double share = static_cast<double>(hits) / points;
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.9);
  const double whole = mesh::enclosed_volume(body);
  EXPECT_NEAR(common_volume(body, bit.parts.back().mesh_P) / whole, share, 1.4e-3);
}

Part cylinder(double radius, double from, double to) {
  Part p;
  p.density = 1.0;
  p.mesh_P =
      surface_of_revolution({{0, to, 1}, {radius, to, 32}, {radius, from, 32}, {0, from, 1}});
  return p;
}

/// One in the other, whatever their frames; half out, or without a density, is not.
RC_GTEST_PROP(EnclosedParts, are_found_in_any_frame, ()) {
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  const Pose X_BP{q.normalized().toRotationMatrix(), {number(-1, 1), number(-1, 1), number(-1, 1)}};
  Bit bit;
  bit.parts = {cylinder(0.1, 0.1, 0.2), cylinder(0.3, 0.0, 1.0), cylinder(0.1, 0.9, 1.1)};
  for (Part& part : bit.parts) part.X_BP = X_BP;
  RC_ASSERT(enclosed_parts(bit) == (std::vector<std::pair<int, int>>{{0, 1}}));
  bit.parts[0].density = 0.0;
  RC_ASSERT(enclosed_parts(bit).empty());
}

TEST(EnclosedParts, of_the_example_bits_are_none) {
  for (const char letter : {'a', 'b', 'c'})
    EXPECT_TRUE(enclosed_parts(example_bit(letter)).empty());
}

}  // namespace tdbd::bit::bit_body_test

namespace tdbd::bit::rubbing_test {

constexpr double column = 0.02e-3;  // m
/// m: sagitta of a rim of 1440 chords, 8 mm (2 pi/1440)^2 / 8, and of a column.
constexpr double sagitta = 3e-8;

/// A flat cutter in the direction of x whose rim is lowest at radius r, depth 0.
Cutter flat_cutter(double r) {
  Cutter c;
  c.diameter = 16e-3;
  c.tip_radius = r;
  c.length = 13e-3;
  c.X_BC = cutter_pose(c);
  return c;
}

/// A part whose vertices are these points of the bit.
Part points(const std::vector<Vec3>& places_B) {
  Part p;
  p.mesh_P.positions = places_B;
  return p;
}

/// One cutter and a point a quarter of a turn behind it, 2 mm above its groove: at an advance d it
/// clears the rock by 2 mm - d / 4, and touches it at 8 mm a revolution.
TEST(Rubbing, of_a_point_behind_one_cutter_is_that_of_the_helix) {
  const Part p = points({{0.0, -50e-3, -2e-3}});
  const Rubbing r = rubbing({flat_cutter(50e-3)}, p, 3e-3, column);
  EXPECT_EQ(r.points, 1u);
  EXPECT_NEAR(r.clearance, 2e-3 - 3e-3 / 4, sagitta);
  EXPECT_NEAR(r.touching_advance, 8e-3, 4 * sagitta);
}

/// A second cutter half a turn on halves the share that the bit sinks in between.
TEST(Rubbing, depends_on_the_cutter_that_passed_last) {
  Cutter second = flat_cutter(50e-3);
  second.azimuth = pi;
  second.X_BC = cutter_pose(second);
  const Part p = points({{0.0, 50e-3, -2e-3}});
  EXPECT_NEAR(rubbing({flat_cutter(50e-3)}, p, 4e-3, column).clearance, 2e-3 - 3e-3, sagitta);
  EXPECT_NEAR(rubbing({flat_cutter(50e-3), second}, p, 4e-3, column).clearance, 2e-3 - 1e-3,
              sagitta);
}

TEST(Rubbing, leaves_out_what_lies_over_uncut_rock) {
  const Rubbing r = rubbing({flat_cutter(50e-3)}, points({{0.0, 10e-3, -2e-3}}), 4e-3, column);
  EXPECT_EQ(r.points, 0u);
  EXPECT_EQ(r.over_uncut, 1u);
}

/// At the advance at which a body touches, and at no smaller one, its least clearance is 0.
RC_GTEST_PROP(Rubbing, of_blades_begins_where_the_clearance_ends, ()) {
  const PdcDesign d = any_design();
  const std::vector<Cutter> cutters = laid_out(d);
  BladeOptions o;
  o.exposure = number(0.25, 0.45) * d.diameter.gage;
  o.slot_depth = 0.1 * d.profile.gage_radius;
  o.edge = 8e-3;
  RC_PRE(blade_problems(cutters, o, d.profile.gage_radius).empty());
  const Part body = blade_body(cutters, o, d.profile.gage_radius);
  const double touching = rubbing(cutters, body, 1e-3, 0.1e-3).touching_advance;
  RC_PRE(touching > 0.0);
  RC_ASSERT(std::abs(rubbing(cutters, body, touching, 0.1e-3).clearance) < 1e-12);
  RC_ASSERT(rubbing(cutters, body, 0.9 * touching, 0.1e-3).clearance > 0.0);
}

/// A flat plate between two azimuths behind a cutter and between two radii, 2 mm above its groove. It
/// lies in the rock where the bit has sunk by more than that since the cutter passed.
Part plate(double from, double to, int steps) {
  Part p;
  for (int k = 0; k <= steps; ++k)
    for (const double r : {49e-3, 51e-3}) {
      const double azimuth = -std::lerp(from, to, 1.0 * k / steps);
      p.mesh_P.positions.emplace_back(r * std::cos(azimuth), r * std::sin(azimuth), -2e-3);
    }
  for (int k = 0; k < steps; ++k) {
    p.mesh_P.triangles.push_back({2 * k, 2 * k + 2, 2 * k + 1});
    p.mesh_P.triangles.push_back({2 * k + 1, 2 * k + 2, 2 * k + 3});
  }
  for (mesh::Triangle& t : p.mesh_P.triangles) {
    const auto& x = p.mesh_P.positions;
    if (mesh::area_vector(x[at(t[0])], x[at(t[1])], x[at(t[2])]).z() < 0.0) std::swap(t[1], t[2]);
  }
  return p;
}

/// Beside its middle the groove is less deep, and the plate touches sooner: by a third of the rise at
/// its sides, 1 mm away, on average, but for the millimetre between the points that are looked at.
TEST(RubbingAreas, are_those_of_a_sector_behind_the_azimuth_that_touches) {
  constexpr double from = 0.3, to = 1.5, d = 10e-3, inner = 49e-3, outer = 51e-3;
  const double first = 2 * pi * 2e-3 / d;  // rad
  const std::vector<double> areas =
      rubbing_areas({flat_cutter(50e-3)}, plate(from, to, 400), {0.0, 8e-3, d}, column);
  EXPECT_EQ(areas[0], 0.0);
  EXPECT_EQ(areas[1], 0.0) << "it would touch at the azimuth of a quarter of a turn";
  const double sector = 0.5 * (outer * outer - inner * inner);
  const double rise = 8e-3 - std::sqrt(8e-3 * 8e-3 - 1e-3 * 1e-3);  // m, of the rim at the sides
  const double sooner = 2 * pi * rise / 3 / d;                      // rad
  constexpr double of_points = 4e-3;                                // rad
  EXPECT_NEAR(areas[2], sector * (to - first + sooner), of_points * sector);
}

/// The slow twin: the cutters' rims as points that turn and sink; the rock over a vertex is the
/// deepest point that passed within a small angle of it in the last revolution.
double swept_clearance(const std::vector<Cutter>& cutters, const Vec3& x_B, double advance) {
  const double r = x_B.head<2>().norm(), azimuth = std::atan2(x_B.y(), x_B.x());
  double rock = -1.0;
  for (const Cutter& c : cutters) {
    const std::vector<Vec3> rim = turned_outline(c, 20000);
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const Vec3 &a = rim[k], &b = rim[(k + 1) % rim.size()];
      if ((a.x() - r) * (b.x() - r) > 0.0) continue;
      for (int turns = -2; turns <= 2; ++turns) {
        const double since = (a.y() - azimuth) / (2 * pi) + turns;
        if (since >= 0.0) rock = std::max(rock, std::max(a.z(), b.z()) - since * advance);
      }
    }
  }
  return rock - x_B.z();
}

TEST(Rubbing, is_what_points_of_turning_rims_leave) {
  const std::vector<Cutter> cutters = make_layout(plain_design()).cutters;
  for (const double r : {20e-3, 45e-3, 66e-3, 80e-3})
    for (const double azimuth : {0.3, 1.9, 4.0}) {
      const Vec3 x(r * std::cos(azimuth), r * std::sin(azimuth), -0.02);
      EXPECT_NEAR(rubbing(cutters, points({x}), 4e-3, column).clearance,
                  swept_clearance(cutters, x, 4e-3), 2.9e-6)
          << r << ' ' << azimuth;
    }
}

}  // namespace tdbd::bit::rubbing_test
