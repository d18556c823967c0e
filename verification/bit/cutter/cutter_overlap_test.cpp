#include "bit/cutter/cutter_overlap.hpp"

#include <gtest/gtest.h>

#include "bit/generate_design.hpp"
#include "core/random.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::cutter_overlap_test {

/// A bit of cutters at these poses.
Bit bit_of(const std::vector<Cutter>& cutters, const PdcOptions& options = {}) {
  return pdc_bit("pair", cutters, options);
}

Cutter cutter_at(int id, double radius, double height) {
  Cutter c;
  c.id = id;
  c.diameter = 16e-3;
  c.tip_radius = radius;
  c.tip_height = height;
  c.chamfer = 0.4e-3;
  c.chamfer_angle = pi / 4;
  c.land = 0.3e-3;
  c.land_angle = 70 * degree;
  c.length = 13e-3;
  c.table_thickness = 2e-3;
  c.X_BC = cutter_pose(c);
  return c;
}

/// Two sharp cylinders side by side share a lens times their length: with rims inscribed in n
/// corners less by about (2 pi / n)^2 / 6 of it.
TEST(CutterOverlap, of_parallel_cylinders_is_a_lens) {
  Cutter a = cutter_at(1, 50e-3, 0.0), b = cutter_at(2, 60e-3, 0.0);
  for (Cutter* c : {&a, &b}) c->chamfer = c->land = 0.0, c->X_BC = cutter_pose(*c);
  PdcOptions options;
  options.meshing.rim_segments = 200;
  const auto overlaps = cutter_overlaps(bit_of({a, b}, options));
  ASSERT_EQ(overlaps.size(), 1u);
  const double r = 8e-3, half = std::acos(5e-3 / r);
  const double lens = 2 * r * r * (half - std::sin(half) * std::cos(half));
  EXPECT_NEAR(overlaps[0].volume / (lens * 13e-3), 1.0, 1e-3);
}

/// A cutter at the place of another shares all of it: the sum over its parts.
TEST(CutterOverlap, of_a_cutter_with_itself_is_its_volume) {
  const Bit bit = bit_of({cutter_at(1, 50e-3, 0.0), cutter_at(2, 50e-3, 0.0)});
  double volume = 0.0;
  for (const Part& part : bit.parts)
    if (part.cutter == 0 && part.density > 0.0) volume += mesh::enclosed_volume(part.mesh_P);
  const auto overlaps = cutter_overlaps(bit);
  ASSERT_EQ(overlaps.size(), 1u);
  EXPECT_NEAR(overlaps[0].volume, volume, 1e-12 * volume);
}

TEST(CutterOverlap, of_cutters_that_are_clear_is_nothing) {
  EXPECT_TRUE(
      cutter_overlaps(bit_of({cutter_at(1, 50e-3, 0.0), cutter_at(2, 67e-3, 0.0)})).empty());
}

RC_GTEST_PROP(CutterOverlap, of_a_generated_bit_is_nothing, ()) {
  RC_ASSERT(cutter_overlaps(bit_of(laid_out(any_design()))).empty());
}

bool inside_cylinder(const Cutter& c, const Vec3& x_B) {
  const Vec3 x = c.X_BC.R.transpose() * (x_B - c.X_BC.p);
  return x.x() < 0.0 && x.x() > -c.length && std::hypot(x.y(), x.z()) < c.diameter / 2;
}

/// Points thrown into the first cylinder: the share that lies in the second, to five standard
/// errors and what the polygons lose.
RC_GTEST_PROP(CutterOverlap, is_what_monte_carlo_finds, ()) {
  Cutter a = cutter_at(1, 50e-3, 0.0), b = cutter_at(2, number(50e-3, 62e-3), number(0.0, 6e-3));
  b.azimuth = number(-0.15, 0.15);
  b.back_rake = number(0.0, 0.5);
  for (Cutter* c : {&a, &b}) c->chamfer = c->land = 0.0, c->X_BC = cutter_pose(*c);
  PdcOptions options;
  options.meshing.rim_segments = 48;
  const auto overlaps = cutter_overlaps(bit_of({a, b}, options));
  const double volume = overlaps.empty() ? 0.0 : overlaps[0].volume;
  const double whole = pi * 64e-6 * 13e-3;
  constexpr int points = 40000;
  Random random{7};
  int hits = 0;
  for (int k = 0; k < points; ++k) {
    const double r = 8e-3 * std::sqrt(random.uniform()), angle = 2 * pi * random.uniform();
    const Vec3 x_C(-13e-3 * random.uniform(), r * std::sin(angle), r * std::cos(angle));
    hits += inside_cylinder(b, a.X_BC * x_C);
  }
  const double share = static_cast<double>(hits) / points;
  const double error = 5 * std::sqrt(std::max(share, 1.0 / points) / points) + 3e-3;
  RC_ASSERT(std::abs(volume / whole - share) < error);
}

}  // namespace tdbd::bit::cutter_overlap_test
