#include "forces/laws/detournay.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"

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

}  // namespace tdbd::forces::detournay_test
