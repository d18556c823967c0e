#include "simulation/case/contact_slopes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tdbd::simulation::contact_slopes_test {

constexpr double depth = 1e-3;  // m, at which the slopes are taken

forces::Strength strength(double confined) {
  forces::Strength s;
  s.confined = confined;
  return s;
}

ForcePlan plan_of(bit::PartKind kind, const forces::Law& law) {
  ForcePlan plan;
  plan.laws[static_cast<std::size_t>(kind)] = law;
  plan.rock.strengths = {strength(20e6), strength(80e6), strength(50e6)};
  return plan;
}

bit::Cutter cutter(double diameter, double back_rake, double profile_angle) {
  bit::Cutter c;
  c.diameter = diameter;
  c.back_rake = back_rake;
  c.profile_angle = profile_angle;
  return c;
}

/// Of a disc up to a height, m2: its chords summed.
double area_up_to(double height, double diameter) {
  constexpr int strips = 100'000;
  double area = 0.0;
  for (int i = 0; i < strips; ++i) {
    const double y = height * (i + 0.5) / strips;
    area += 2.0 * std::sqrt(y * (diameter - y)) * height / strips;
  }
  return area;
}

dynamics::ContactSlopes slopes_of(const bit::Cutter& c, const forces::Detournay& law) {
  bit::Bit bit;
  bit.cutters = {c};
  return contact_slopes(bit, plan_of(bit::PartKind::face, law));
}

constexpr double of_slip =
    1e-6;  // relative: at the usual speed a law's force is not yet all of it, by 5e-7
constexpr double of_strips = 7e-7;  // relative: of the sum of strips, whose first is under a root

/// A sharp face: zeta eps A over the depth, A seen along the motion.
TEST(ContactSlopes, of_a_face_are_those_of_the_disc_below_the_rock) {
  forces::Detournay sharp{.eps = 60e6, .zeta = 0.7};
  const double rake = 0.35, tilt = 0.8;
  const double area = std::cos(rake) * area_up_to(depth / std::cos(rake), 0.016);
  const double slope = 0.7 * 60e6 * area / depth;
  const dynamics::ContactSlopes s = slopes_of(cutter(0.016, rake, tilt), sharp);
  EXPECT_NEAR(s.axial_stiffness, slope * std::cos(tilt) * std::cos(tilt), of_strips * slope);
  EXPECT_NEAR(s.lateral_stiffness, 0.5 * slope * std::sin(tilt) * std::sin(tilt),
              0.5 * of_strips * slope);
}

/// A wear flat bears on the edge that is engaged, as long as the flat is, or kappa times the depth of cut.
TEST(ContactSlopes, of_a_blunt_face_count_its_edge) {
  const double rake = 0.3, height = depth / std::cos(rake), radius = 0.008;
  const double edge = 2.0 * radius * std::acos(1.0 - height / radius);
  const double area = std::cos(rake) * area_up_to(height, 2.0 * radius);
  const forces::Detournay blunt{.eps = 1.0, .zeta = 0.0, .sigma = 30e6, .l = 1e-4, .kappa = 5.0};
  EXPECT_NEAR(slopes_of(cutter(0.016, rake, 0.0), blunt).axial_stiffness,
              30e6 * edge * 1e-4 / depth, 0.03);
  const forces::Detournay long_flat{.eps = 1.0, .zeta = 0.0, .sigma = 30e6, .l = 1.0, .kappa = 5.0};
  EXPECT_NEAR(slopes_of(cutter(0.016, rake, 0.0), long_flat).axial_stiffness,
              30e6 * 5.0 * area / depth, of_strips * 30e6 * 5.0 * area / depth);
}

/// Whatever the law makes of a cut: its depth, rake, edge and diameter, the rock's strength.
TEST(ContactSlopes, of_a_face_are_those_of_its_law) {
  const double rake = 0.3, height = depth / std::cos(rake), radius = 0.008;
  forces::PartCut cut;
  cut.kind = bit::PartKind::face;
  cut.cut_area = std::cos(rake) * area_up_to(height, 2.0 * radius);
  cut.engaged_edge = 2.0 * radius * std::acos(1.0 - height / radius);
  cut.depth = cut.cut_area / cut.engaged_edge;
  cut.back_rake = rake;
  cut.diameter = 2.0 * radius;
  cut.velocity = Vec3::UnitX();
  cut.normal = Vec3::UnitZ();
  cut.strength = strength(80e6);
  bit::Bit bit;
  bit.cutters = {cutter(2.0 * radius, rake, 0.0)};
  const forces::Law laws[] = {forces::HansonHansen{.A1 = 1.2, .A3 = 0.3},
                              forces::Glowka{.Cn = 3e3, .nn = 1.4, .Cd = 5e3, .nd = 1.3}};
  for (const forces::Law& law : laws) {
    const double expected = forces::force(law, cut).normal / depth;
    EXPECT_GT(expected, 0.0) << forces::law_name(law);
    EXPECT_NEAR(contact_slopes(bit, plan_of(bit::PartKind::face, law)).axial_stiffness / expected,
                1.0, 8e-9)
        << forces::law_name(law);
  }
}

/// No more than the lower half of a small cutter is in the rock.
TEST(ContactSlopes, of_a_small_cutter_are_those_of_half_its_disc) {
  const double radius = 0.7e-3, half = 0.5 * std::numbers::pi * radius * radius;
  EXPECT_NEAR(slopes_of(cutter(2.0 * radius, 0.0, 0.0), {.eps = 60e6, .zeta = 1.0}).axial_stiffness,
              60e6 * half / depth, 1e-9 * 60e6);
}

/// All cutters, one tooth of each row, in the strongest rock that there is: a print of pi (D - d) d.
TEST(ContactSlopes, are_sums_of_cutters_and_of_a_tooth_of_every_row) {
  bit::Bit bit;
  bit.cones.resize(2);
  double area = 0.0;
  for (bit::Cone& cone : bit.cones)
    for (const double diameter : {0.008, 0.012}) {
      cone.layout.rows.emplace_back().shape.diameter = diameter;
      area += std::numbers::pi * (diameter - depth) * depth;
    }
  const ForcePlan teeth = plan_of(bit::PartKind::tooth, forces::Indentation{.ratio = 1.5});
  EXPECT_NEAR(contact_slopes(bit, teeth).axial_stiffness, 1.5 * 80e6 * area / depth,
              of_slip * 1.5 * 80e6 * area / depth);
  EXPECT_EQ(contact_slopes(bit, teeth).lateral_stiffness, 0.0);
  bit::Bit two;
  two.cutters = {cutter(0.013, 0.2, 0.5), cutter(0.019, 0.3, 1.2)};
  const forces::Detournay sharp{.eps = 60e6, .zeta = 0.7};
  const dynamics::ContactSlopes both = contact_slopes(two, plan_of(bit::PartKind::face, sharp)),
                                a = slopes_of(two.cutters[0], sharp),
                                b = slopes_of(two.cutters[1], sharp);
  EXPECT_DOUBLE_EQ(both.axial_stiffness, a.axial_stiffness + b.axial_stiffness);
  EXPECT_DOUBLE_EQ(both.lateral_stiffness, a.lateral_stiffness + b.lateral_stiffness);
}

}  // namespace tdbd::simulation::contact_slopes_test
