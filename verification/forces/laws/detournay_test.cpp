#include <gtest/gtest.h>

#include "forces/generate.hpp"
#include "forces/law.hpp"
#include "forces/laws/laws.hpp"

namespace tdbd::forces::detournay_test {

using bit::PartKind;

Detournay sharp() {
  Detournay d;
  d.eps = 100 * MPa;
  d.zeta = 0.8;
  d.slip_speed = 0.0;
  return d;
}

Detournay blunt() {
  Detournay d = sharp();
  d.sigma = 60 * MPa;
  d.mu = 0.6;
  d.l = 2e-3;
  d.kappa = 5.0;
  return d;
}

struct BitLoad {
  double weight = 0.0;  // N
  double torque = 0.0;  // N m
};

constexpr double R = 0.108;  // m

/// A flat bit of many square-ended cutters side by side from the axis to R, at d of depth a turn.
BitLoad flat_bit(const Detournay& law, double d) {
  constexpr int cutters = 50;
  const double width = R / cutters;
  BitLoad sum;
  for (int k = 0; k < cutters; ++k) {
    const double r = (k + 0.5) * width, azimuth = 2.4 * k;
    PartCut c = plain_cut(PartKind::face);
    c.cut_area = width * d;
    c.engaged_edge = width;
    c.depth = d;
    c.point = Vec3(r * std::cos(azimuth), r * std::sin(azimuth), 0.0);
    c.velocity = 12.0 * Vec3(-c.point.y(), c.point.x(), 0.0);
    const PartForce f = law_force(law, c);
    sum.weight -= f.force.z();
    sum.torque -= f.point.cross(f.force).z();
  }
  return sum;
}

/// T = eps R^2 d/2 and W = zeta eps R d, to rounding.
TEST(Detournay, summed_over_a_sharp_bit_is_its_law_of_the_whole_bit) {
  const double d = 2e-3;
  const BitLoad b = flat_bit(sharp(), d);
  EXPECT_NEAR(b.torque, 100 * MPa * R * R * d / 2, rounding(b.torque));
  EXPECT_NEAR(b.weight, 0.8 * 100 * MPa * R * d, rounding(b.weight));
}

/// E = E0 + mu S with E0 = (1 - mu zeta) eps, at any depth, contact growing or whole.
TEST(Detournay, of_a_blunt_bit_lies_on_the_friction_line) {
  const Detournay law = blunt();
  for (const double d : {0.1e-3, 0.3e-3, 0.5e-3, 1e-3, 3e-3}) {
    const BitLoad b = flat_bit(law, d);
    const double E = 2 * b.torque / (R * R * d), S = b.weight / (R * d);
    EXPECT_NEAR(E, (1.0 - law.mu * law.zeta) * law.eps + law.mu * S, rounding(E)) << d;
  }
}

/// Phase I: the contact grows with the depth, S* = zeta eps + kappa sigma; phase II: it is whole
/// and the load grows by zeta eps alone.
TEST(Detournay, of_a_blunt_bit_has_two_phases) {
  const Detournay law = blunt();
  const double whole = law.l / law.kappa;  // m, depth at which the contact is whole: 0.4 mm
  const double S1 = law.zeta * law.eps + law.kappa * law.sigma;
  const double half = S1 * R * 0.5 * whole;
  EXPECT_NEAR(flat_bit(law, 0.5 * whole).weight, half, rounding(half));
  const double at = flat_bit(law, whole).weight, beyond = flat_bit(law, 3 * whole).weight;
  EXPECT_NEAR(beyond - at, law.zeta * law.eps * R * 2 * whole, rounding(beyond));
}

TEST(Detournay, of_a_sharp_cutter_doubles_with_the_depth_of_cut) {
  PartCut c = plain_cut(PartKind::face);
  const Vec3 once = law_force(sharp(), c).force;
  c.cut_area *= 2;
  EXPECT_LT((law_force(sharp(), c).force - 2 * once).norm(), rounding(once.norm()));
}

/// Whatever way it goes into the rock, its power is eps times the rate of volume: the specific
/// energy.
RC_GTEST_PROP(Detournay, of_a_sharp_cutter_spends_eps_on_every_volume, ()) {
  PartCut c = plain_cut(PartKind::face);
  c.velocity = number(0.01, 2.0) * any_direction();
  if (c.velocity.dot(c.normal) < 0.0) c.normal = -c.normal;
  const double rate = c.cut_area * c.velocity.norm();  // m3/s
  const double power = -law_force(sharp(), c).force.dot(c.velocity);
  RC_ASSERT(std::abs(power - 100 * MPa * rate) <= 1e-15 * (100 * MPa * rate));
}

/// A wear flat that the mesh has: contact stress on its area, friction, nothing cut.
TEST(Detournay, of_a_wear_flat_in_the_mesh_is_friction) {
  for (const PartKind kind : {PartKind::chamfer, PartKind::cutter_body}) {
    const PartForce f = force(Law{blunt()}, plain_cut(kind));
    EXPECT_NEAR(f.normal, 60e6 * 4e-6, 1e-12);
    EXPECT_NEAR(f.tangential, 0.6 * 60e6 * 4e-6, 1e-12);
  }
}

Friction pad() {
  Friction f;
  f.stress = 50 * MPa;
  f.mu = 0.3;
  f.slip_speed = 0.0;
  return f;
}

TEST(Friction, of_a_pad_that_slides_along_the_wall_is_none) {
  EXPECT_EQ(force(pad(), plain_cut(bit::PartKind::gage_pad)).force, Vec3::Zero());
}

/// 4 mm2 at 50 MPa: 200 N; half of it at half the slope.
TEST(Friction, grows_with_the_angle_into_the_rock_until_the_stress_is_whole) {
  PartCut c = plain_cut(bit::PartKind::gage_pad);
  for (const auto& [angle, share] : {std::pair{0.5, 0.5}, {1.0, 1.0}, {3.0, 1.0}}) {
    c.velocity = Vec3(1.0, 0.0, angle * std::tan(0.01));
    const PartForce f = force(pad(), c);
    EXPECT_DOUBLE_EQ(f.normal, 200.0 * share) << angle;
    EXPECT_DOUBLE_EQ(f.force.z(), -200.0 * share) << angle;
    EXPECT_DOUBLE_EQ(f.force.x(), -0.3 * 200.0 * share) << angle;
  }
}

TEST(Friction, of_a_flat_without_an_angle_is_whole_while_it_slides) {
  Friction f = pad();
  f.full_angle = 0.0;
  EXPECT_DOUBLE_EQ(force(f, plain_cut(bit::PartKind::bit_body)).normal, 200.0);
}

TEST(Friction, is_capped_by_what_the_rock_carries) {
  Friction f = pad();
  f.full_angle = 0.0;
  PartCut c = plain_cut(bit::PartKind::gage_pad);
  c.strength.confined = 20 * MPa;
  EXPECT_DOUBLE_EQ(force(f, c).normal, 1.5 * 20e6 * 4e-6);
}

TEST(Friction, of_a_pad_pulled_out_is_none) {
  PartCut c = plain_cut(bit::PartKind::gage_pad);
  c.velocity = Vec3(0.0, 0.0, -1.0);
  EXPECT_EQ(force(pad(), c).force, Vec3::Zero());
}

constexpr double inch = 25.4e-3, lbf = 4.4482216152605;

/// The 0.5 in cutter in Berea sandstone (Glowka 1989).
PartCut cutter_j(double area) {
  PartCut c = plain_cut(bit::PartKind::face);
  c.diameter = 0.5 * inch;
  c.cut_area = area;
  return c;
}

Glowka berea() {
  Glowka law = std::get<Glowka>(fit_named("glowka-berea-0.5in").law);
  law.slip_speed = 0.0;
  return law;
}

struct Row {
  double share, depth, normal, drag;  // 1, in, lbf, lbf
};

/// Whole, half and quarter of the groove of 0.06 in; printed to five digits: half of the last.
TEST(Glowka, on_the_effective_depth_is_that_of_the_literature) {
  const double whole = groove_area({0.5 * inch, 20 * degree}, 0.06 * inch);
  EXPECT_NEAR(whole, 0.01373336 * inch * inch, 1e-8 * inch * inch);
  for (const Row& r : {Row{1.0, 0.06, 87.079, 104.924},
                       {0.5, 0.0374094, 42.871, 53.393},
                       {0.25, 0.0234203, 21.236, 27.330}}) {
    const PartCut c = cutter_j(r.share * whole);
    EXPECT_NEAR(groove_depth({c.diameter, c.back_rake}, c.cut_area).depth, r.depth * inch,
                5e-8 * inch);
    const PartForce f = law_force(berea(), c);
    EXPECT_NEAR(f.normal, r.normal * lbf, 1e-3 * lbf);
    EXPECT_NEAR(f.tangential, r.drag * lbf, 5e-4 * lbf);
  }
}

/// Twice the depth of a groove: 2^1.5 times the normal force, 2^1.43 the drag.
TEST(Glowka, grows_with_its_powers_of_the_depth) {
  const GrooveCutter cutter{0.5 * inch, 20 * degree};
  const PartForce once = law_force(berea(), cutter_j(groove_area(cutter, 1e-3)));
  const PartForce twice = law_force(berea(), cutter_j(groove_area(cutter, 2e-3)));
  EXPECT_NEAR(once.normal, berea().Cn, 1e-12 * once.normal);
  EXPECT_NEAR(twice.normal, std::pow(2.0, 1.50) * once.normal, 1e-12 * twice.normal);
  EXPECT_NEAR(twice.tangential, std::pow(2.0, 1.43) * once.tangential, 1e-12 * twice.tangential);
}

TEST(Glowka, rejects_a_missing_diameter) {
  EXPECT_EQ(law_problem(Glowka{}, bit::PartKind::face, 0.0),
            "the law \"glowka\" requires the cutter's diameter, which this face does not have");
  EXPECT_EQ(law_problem(Glowka{}, bit::PartKind::face, 13e-3), "");
  PartCut c = cutter_j(1e-6);
  c.diameter = 0.0;
  EXPECT_EQ(law_force(berea(), c).force, Vec3::Zero());
}

constexpr double a = 6e-3;  // m, radius of a spherical tooth

Indentation smooth() { return {.ratio = 1.2, .mu = 0.0, .slip_speed = 0.0}; }

/// Seen along its normal, the contact of a sphere at depth s is a disc: pi (2 a s - s^2).
double disc(double s) { return pi * (2 * a * s - s * s); }

PartCut pressed(double area) {
  PartCut c = plain_cut(bit::PartKind::tooth);
  c.contact_area = area;
  c.velocity = Vec3(0, 0, 0.1);
  return c;
}

/// Computed manually: 11 pi mm2 at 1 mm; 1.2 times 100 MPa on it.
TEST(Indentation, of_a_sphere_is_the_pressure_on_its_disc) {
  EXPECT_DOUBLE_EQ(disc(1e-3), 11e-6 * pi);
  EXPECT_DOUBLE_EQ(force(smooth(), pressed(disc(1e-3))).force.z(), -120e6 * disc(1e-3));
}

/// The force on one contact is that on many patches of it with their own normals.
TEST(Indentation, adds_up_over_patches_of_a_curved_contact) {
  const double s = 1.5e-3, edge = std::acos(1.0 - s / a);
  constexpr int rings = 400, turns = 60;
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < turns; ++k) {
      const double angle = (i + 0.5) * edge / rings, turn = 2 * pi * k / turns;
      PartCut c = pressed(a * a * std::sin(angle) * (edge / rings) * (2 * pi / turns));
      c.normal =
          Vec3(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle));
      sum += force(smooth(), c).force;
    }
  const Vec3 whole = force(smooth(), pressed(disc(s))).force;
  // The midpoint rule over the rings: (edge/rings)^2/6 of the whole.
  EXPECT_LT((sum - whole).norm(), 1.5e-6 * whole.norm());
}

/// Computed manually: a smooth wedge of 30 degrees to its side, 10 mm long, 2 mm deep, flanks under
/// 153.884 MPa: 2 p l d tan 30 = 3553.8 N, and linear in its depth.
TEST(Indentation, of_a_wedge_is_the_pressure_on_its_flanks) {
  const double half = 30 * degree, length = 10e-3;
  for (const double depth : {1e-3, 2e-3}) {
    double weight = 0.0;
    for (const double side : {-1.0, 1.0}) {
      PartCut c = pressed(length * depth / std::cos(half));
      c.normal = Vec3(side * std::cos(half), 0.0, std::sin(half));
      c.strength.confined = 153.884 * MPa / smooth().ratio;
      weight -= force(smooth(), c).force.z();
    }
    const double by_hand = 2.0 * 153.884 * MPa * length * depth * std::tan(half);
    EXPECT_NEAR(weight, by_hand, 1e-12 * by_hand);
  }
}

TEST(Indentation, drags_against_the_slip) {
  Indentation law = smooth();
  law.mu = 0.3;
  PartCut c = pressed(10e-6);
  c.velocity = Vec3(0.0, -0.2, 0.1);
  EXPECT_LT((force(law, c).force - Vec3(0.0, 360.0, -1200.0)).norm(), 1e-12);
}

TEST(Indentation, lets_a_tooth_go_that_leaves_the_rock) {
  PartCut c = pressed(10e-6);
  c.velocity = Vec3(0.0, 0.0, -0.1);
  EXPECT_LT(force(smooth(), c).force.norm(), 1e-12);
}

}  // namespace tdbd::forces::detournay_test

namespace tdbd::forces::depth_of_cut_test {

/// 10 mm wide, 1 mm deep.
TEST(DepthOfCut, is_width_times_depth_and_doubles_with_the_depth) {
  const DepthOfCut law{.kn = 80 * MPa, .kt = 100 * MPa, .slip_speed = 0.0};
  PartCut c = plain_cut(bit::PartKind::face);
  EXPECT_LT((law_force(law, c).force - Vec3(-1000, 0, -800)).norm(), 1e-12);
  c.depth *= 2;
  EXPECT_LT((law_force(law, c).force - Vec3(-2000, 0, -1600)).norm(), 1e-12);
}

/// Equal to the law of Detournay with kt = eps and kn = zeta eps, of a square-ended cutter.
TEST(DepthOfCut, of_a_square_cutter_is_that_of_a_sharp_one) {
  const DepthOfCut law{.kn = 80 * MPa, .kt = 100 * MPa, .slip_speed = 0.0};
  const Detournay sharp{.eps = 100 * MPa, .zeta = 0.8, .slip_speed = 0.0};
  const PartCut c = plain_cut(bit::PartKind::face);  // its area is edge times depth
  EXPECT_LT((law_force(law, c).force - law_force(sharp, c).force).norm(), 1e-12);
}

}  // namespace tdbd::forces::depth_of_cut_test
