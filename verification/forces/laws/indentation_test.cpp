#include "forces/laws/indentation.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"

namespace tdbd::forces::indentation_test {

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

/// By hand: 11 pi mm2 at 1 mm; 1.2 times 100 MPa on it.
TEST(Indentation, of_a_sphere_is_the_pressure_on_its_disc) {
  EXPECT_DOUBLE_EQ(disc(1e-3), 11e-6 * pi);
  EXPECT_DOUBLE_EQ(force(smooth(), pressed(disc(1e-3))).force.z(), -120e6 * disc(1e-3));
}

/// The law asked for one contact, or for many patches of it with their own normals: the same force.
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

/// By hand: a smooth wedge of 30 degrees to its side, 10 mm long, 2 mm deep, flanks under
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

}  // namespace tdbd::forces::indentation_test
