#include "forces/laws/hanson_hansen.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"
#include "forces/laws/laws.hpp"
#include "forces/rock/rock_material.hpp"
#include "reference/forces/chip_balance.hpp"
#include "reference/forces/groove_by_strips.hpp"

namespace tdbd::forces::hanson_hansen_test {

using bit::PartKind;

HansonHansen example() {
  HansonHansen h;
  h.A1 = 0.9;
  h.A2 = 0.5;
  h.A3 = 20 * degree;
  h.A4 = 0.7;
  h.A5 = 1.3;
  h.A6 = 0.6;
  h.A7 = 0.5;
  h.A8 = 0.3;
  h.slip_speed = 0.0;
  return h;
}

/// Computed manually, 100 MPa: Ft = 100e6 (0.9 (1 + 0.5 tan 20) 10e-6 + 0.7 1e-4 10e-3) = 1133.7865
/// N, Fn = tan 40 Ft.
TEST(HansonHansen, of_a_face_is_the_manual_reconstruction) {
  const PartForce f = law_force(example(), plain_cut(PartKind::face));
  const double Ft = 100e6 * (0.9 * (1.0 + 0.5 * 0.36397023426620236) * 10e-6 + 0.7 * 1e-4 * 10e-3);
  EXPECT_NEAR(f.tangential, Ft, rounding(Ft));
  EXPECT_NEAR(f.normal, 0.83909963117728 * Ft, 1e-13 * Ft);
  EXPECT_LT((f.force - Vec3(-f.tangential, 0, -f.normal)).norm(), rounding(Ft));
}

/// Rake and A3 together beyond 80 degrees: the ratio stays at tan 80 degrees.
TEST(HansonHansen, of_a_face_has_a_bounded_ratio_of_forces) {
  const double most = std::tan(80 * degree);
  for (const double A3 : {62 * degree, 69 * degree, 85 * degree}) {
    HansonHansen law = example();
    law.A3 = A3;
    const PartForce f = law_force(law, plain_cut(PartKind::face));
    EXPECT_NEAR(f.normal, most * f.tangential, 1e-13 * f.normal);
  }
}

TEST(HansonHansen, of_a_chamfer_presses_with_a_share_of_the_strength) {
  const PartForce f = law_force(example(), plain_cut(PartKind::chamfer));
  EXPECT_DOUBLE_EQ(f.normal, 1.3 * 100e6 * 4e-6);
  EXPECT_DOUBLE_EQ(f.tangential, 0.6 * f.normal);
}

TEST(HansonHansen, of_other_surfaces_has_their_own_coefficients) {
  for (const PartKind kind : {PartKind::cse, PartKind::cutter_body}) {
    const PartForce f = force(Law{example()}, plain_cut(kind));
    EXPECT_DOUBLE_EQ(f.normal, 0.5 * 100e6 * 4e-6);
    EXPECT_DOUBLE_EQ(f.tangential, 0.3 * f.normal);
  }
}

/// te is the length scale of A4 and no coefficient beside it.
RC_GTEST_PROP(HansonHansen, feels_an_edge_by_one_product_alone, ()) {
  Law law = any_law({"hanson-hansen"});
  const PartCut c = any_cut();
  auto twice = std::get<HansonHansen>(law);
  twice.te *= 2.0;
  twice.A4 *= 0.5;
  const PartForce f = force(law, c);
  RC_ASSERT((force(twice, c).force - f.force).norm() <= 1e-13 * size(f));
}

/// 4 mm2 of chamfer at 1.34 times 114 MPa is 610 N.
TEST(HansonHansen, of_an_engaged_chamfer_is_that_of_the_literature) {
  HansonHansen h = example();
  h.A5 = 1.34;
  PartCut c = plain_cut(PartKind::chamfer);
  c.strength.confined = 114 * MPa;
  EXPECT_NEAR(law_force(h, c).normal, 610.0, 2.0);
}

/// A share of 0 leaves the strength without pressure, of 1 the rock's.
TEST(HansonHansen, takes_its_share_of_the_pressure) {
  HansonHansen h = example();
  const PartCut c = plain_cut(PartKind::face);  // 60 MPa, confined 100 MPa
  const double whole = law_force(h, c).tangential;
  h.pressure_share = 0.0;
  EXPECT_NEAR(law_force(h, c).tangential, 0.6 * whole, rounding(whole));
  h.pressure_share = 0.5;
  EXPECT_NEAR(law_force(h, c).tangential, 0.8 * whole, rounding(whole));
}

/// Any coefficients and cut: the sum of the basis is the force.
RC_GTEST_PROP(HansonHansen, is_the_sum_of_coefficients_times_its_basis, ()) {
  Law law = HansonHansen{};
  for (const LawField& f : law_fields(law))
    *f.value = number(std::max(f.range.lo, 0.0), std::min(f.range.hi, 5.0));
  PartCut c = any_cut();
  RC_PRE(HansonHansen::knows(c.kind));
  const auto& h = std::get<HansonHansen>(law);
  const auto factors = linear_coefficients(h);
  const auto basis = force_basis(h, c);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < hanson_hansen_terms; ++k) sum += factors[k] * basis[k];
  const PartForce f = force(law, c);
  RC_ASSERT((sum - f.force).norm() <= rounding(f.normal + f.tangential));
}

/// Linear least squares on the basis finds the coefficients behind forces again.
TEST(HansonHansen, is_recovered_from_forces_by_linear_least_squares) {
  const HansonHansen h = example();
  Eigen::MatrixXd rows(3 * 60, hanson_hansen_terms);
  Eigen::VectorXd forces(3 * 60);
  for (int k = 0; k < 60; ++k) {
    PartCut c = plain_cut(static_cast<PartKind>(k % 3));
    c.cut_area *= 1.0 + 0.1 * k;
    c.back_rake += 0.01 * (k % 7);
    c.engaged_edge *= 1.0 + 0.3 * (k % 5);
    const auto basis = force_basis(h, c);
    for (int j = 0; j < hanson_hansen_terms; ++j) rows.block<3, 1>(3 * k, j) = basis[j];
    forces.segment<3>(3 * k) = force(Law{h}, c).force;
  }
  const Eigen::VectorXd found = rows.colPivHouseholderQr().solve(forces);
  const auto factors = linear_coefficients(h);
  for (int j = 0; j < hanson_hansen_terms; ++j) EXPECT_NEAR(found[j], factors[j], 1e-12);
}

/// Zijsling's tests as Miedema has them: cohesion 24.82 MPa, 23.8 and 15.87 degrees, 20 degrees of
/// back rake, 10 mm wide.
PartCut mancos(double pressure, double thickness) {
  PartCut c = plain_cut(bit::PartKind::face);
  const double phi = 23.8 * degree;
  c.strength.friction_angle = phi;
  c.strength.unconfined = 2 * 24.82 * MPa * std::cos(phi) / (1 - std::sin(phi));
  c.strength.pressure = pressure;
  c.cut_area = 10e-3 * thickness;
  return c;
}

ThinCut zijsling() {
  ThinCut law;
  law.interface_share = 15.87 / 23.8;
  law.slip_speed = 0.0;
  return law;
}

struct Row {
  double pressure, energy, ratio;  // MPa, MPa, 1
};

/// Miedema's table, printed to 1 MPa and 0.01.
TEST(ThinCut, gives_specific_energies_under_pressure_of_the_literature) {
  for (const Row& r : {Row{0.1, 282, 0.72},
                       {10, 353, 0.76},
                       {20.7, 430, 0.79},
                       {41.4, 579, 0.83},
                       {68.9, 777, 0.85},
                       {100, 1000, 0.87}})
    for (const double thickness : {0.15e-3, 0.30e-3}) {
      const PartCut c = mancos(r.pressure * MPa, thickness);
      const PartForce f = law_force(zijsling(), c);
      EXPECT_NEAR(f.tangential / c.cut_area, r.energy * MPa, 0.5 * MPa) << r.pressure;
      EXPECT_NEAR(f.normal / f.tangential, r.ratio, 0.005) << r.pressure;
    }
}

/// From 3000 to 6000 psi forces rise 1.35 times, the strength of Mohr and Coulomb 1.43 times.
TEST(ThinCut, rises_with_pressure_a_little_less_than_the_strength_does) {
  const double low = 20.684 * MPa, high = 41.369 * MPa;
  const double forces = law_force(zijsling(), mancos(high, 0.3e-3)).tangential /
                        law_force(zijsling(), mancos(low, 0.3e-3)).tangential;
  EXPECT_NEAR(forces, 1.35, 0.005);
  const RockMaterial shale = rock_named("mancos-shale");
  const auto confined = [&](double p) {
    return strength_of(shale, {.pressure = p}, Confinement::permeable).confined;
  };
  EXPECT_NEAR(confined(high) / confined(low), 1.43, 0.005);
}

/// The closed form against the chip's equilibrium, where chip and blade push on each other.
RC_GTEST_PROP(ThinCut, is_the_equilibrium_of_the_chip, ()) {
  ThinCut law = zijsling();
  law.shear_angle = number(0.1, 0.5);
  law.blade_height = number(1.0, 6.0);
  law.interface_share = number(0.3, 0.9);
  PartCut c = mancos(number(0.0, 100 * MPa), 0.3e-3);
  c.back_rake = number(0.0, 25 * degree);
  const double phi = c.strength.friction_angle, al = pi / 2 + c.back_rake;
  RC_PRE(al + law.shear_angle + (1 + law.interface_share) * phi < 165 * degree);
  const double width = 10e-3, height = c.cut_area / width;
  const reference::BladeLoad twin =
      reference::chip_balance({.blade_angle = al,
                               .shear_angle = law.shear_angle,
                               .friction_angle = phi,
                               .interface_angle = law.interface_share * phi,
                               .cohesion = 24.82 * MPa,
                               .pressure = c.strength.pressure,
                               .shear_length = height / std::sin(law.shear_angle),
                               .blade_length = law.blade_height * height / std::sin(al),
                               .width = width});
  RC_PRE(twin.up >= 0.0 && twin.against_motion >= 0.0);
  const PartForce f = law_force(law, c);
  const double tolerance = 1e-11 * (f.normal + f.tangential);
  RC_ASSERT(std::abs(f.tangential - twin.against_motion) < tolerance);
  RC_ASSERT(std::abs(f.normal - twin.up) < tolerance);
}

/// Beyond the largest back rake there is dead rock before the face: the force is constant.
TEST(ThinCut, has_a_largest_back_rake) {
  ThinCut law = zijsling();
  law.largest_back_rake = 15 * degree;
  PartCut c = mancos(20 * MPa, 0.3e-3);
  c.back_rake = 15 * degree;
  const PartForce at = law_force(law, c);
  c.back_rake = 25 * degree;
  EXPECT_EQ(law_force(law, c).force, at.force);
  law.largest_back_rake = 25 * degree;
  EXPECT_GT(law_force(law, c).tangential, 1.1 * at.tangential);
}

/// Near the formula's pole the sum of angles is held at 170 degrees: here from 28.3 degrees on.
TEST(ThinCut, stays_below_its_pole) {
  ThinCut law = zijsling();
  law.largest_back_rake = 1.0;
  PartCut c = mancos(20 * MPa, 0.3e-3);
  c.back_rake = (170 - 90 - 12 - 23.8 - 15.87) * degree;
  const PartForce at = law_force(law, c);
  for (const double steeper : {29.0, 38.3, 38.4, 50.0}) {
    c.back_rake = steeper * degree;
    EXPECT_LT((law_force(law, c).force - at.force).norm(), 1e-12 * at.force.norm()) << steeper;
  }
}

/// A blade that lies flat on the rock has a wedge of 10 degrees at the least: the forces stay finite.
TEST(ThinCut, has_a_smallest_blade_angle) {
  PartCut c = mancos(20 * MPa, 0.3e-3);
  const auto force_at = [&](double degrees) {
    c.back_rake = degrees * degree;
    return law_force(zijsling(), c).force;
  };
  const Vec3 at = force_at(-80.0);
  EXPECT_GT(at.norm(), 0.0);
  for (const double flatter : {-81.0, -89.0, -90.0, -95.0})
    EXPECT_LT((force_at(flatter) - at).norm(), 1e-12 * at.norm()) << flatter;
  EXPECT_GT((force_at(-75.0) - at).norm(), 0.1 * at.norm());
}

/// Computed manually: a 16 mm face cut at 0.5, 1, 2 mm in its plane; printed to seven digits.
TEST(GrooveArea, is_that_of_the_literature) {
  const GrooveCutter c{.diameter = 16e-3, .back_rake = 20 * degree};
  const double lean = std::cos(c.back_rake);
  for (const auto& [y, segment] : {std::pair{0.5, 1.867841}, {1.0, 5.232189}, {2.0, 14.505976}})
    EXPECT_NEAR(groove_area(c, y * 1e-3 * lean), segment * 1e-6 * lean, 5e-7 * 1e-6) << y;
}

/// Strips of a half circle's end are off by their width to the power 1.5: 1e-5 of the face here.
RC_GTEST_PROP(GrooveArea, is_that_of_strips, ()) {
  const GrooveCutter c{.diameter = number(8e-3, 25e-3), .back_rake = number(-0.3, 0.7)};
  const double depth = number(0.0, 1.2) * c.diameter;
  const double strips = reference::groove_area_by_strips(c.diameter, c.back_rake, depth, 2000);
  RC_ASSERT(std::abs(groove_area(c, depth) - strips) < 8e-6 * c.diameter * c.diameter);
}

/// Also where the difference of angle and chord would lose them: in 64 bits it does not, from 0.01 rad
/// on. The angle itself is known to some ulp, its cube to 16.
RC_GTEST_PROP(GrooveArea, has_all_its_digits, ()) {
  const GrooveCutter c{.diameter = number(8e-3, 25e-3), .back_rake = number(-0.3, 0.7)};
  const double a = c.diameter / 2.0, lean = std::cos(c.back_rake), half = number(0.01, 0.299);
  const double depth = 2.0 * a * lean * std::pow(std::sin(half / 2.0), 2);
  const long double t =
      2.0L * std::asin(std::sqrt(static_cast<long double>(depth) / (2.0L * a * lean)));
  const auto area = static_cast<double>((t - std::sin(t) * std::cos(t)) * a * a * lean);
  RC_ASSERT(std::abs(groove_area(c, depth) - area) <= rounding(area / 3.0));
}

/// Down to cuts of a billionth of the face, and up to all of it.
RC_GTEST_PROP(GrooveDepth, is_the_inverse_of_the_area, ()) {
  const GrooveCutter c{.diameter = number(8e-3, 25e-3), .back_rake = number(-0.3, 0.7)};
  const double face = pi / 4 * c.diameter * c.diameter * std::cos(c.back_rake);
  const double area = face * (index(2) == 0 ? number(0.0, 1.0) : std::pow(10.0, -number(0.0, 9.0)));
  const GrooveDepth g = groove_depth(c, area);
  // Near the whole face the depth loses digits as the root of the rest of the area.
  RC_ASSERT(std::abs(groove_area(c, g.depth) - area) <=
            rounding(face * (area > 0.9 * face)) + rounding(area));
  RC_ASSERT(g.iterations >= 1 || area == 0.0 || area >= (1.0 - 1e-15) * face);
  RC_ASSERT(g.iterations <= 5);
}

TEST(GrooveDepth, of_nothing_is_none_and_of_too_much_the_whole_face) {
  const GrooveCutter c{.diameter = 16e-3, .back_rake = 20 * degree};
  EXPECT_EQ(groove_depth(c, 0.0).depth, 0.0);
  EXPECT_EQ(groove_depth(c, 0.0).iterations, 0);
  EXPECT_NEAR(groove_depth(c, 1.0).depth, 16e-3 * std::cos(c.back_rake), 1e-17);
}

}  // namespace tdbd::forces::hanson_hansen_test
