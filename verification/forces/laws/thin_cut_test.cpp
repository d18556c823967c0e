#include "forces/laws/thin_cut.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"
#include "forces/rock/rock_material.hpp"
#include "reference/forces/chip_balance.hpp"

namespace tdbd::forces::thin_cut_test {

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

/// Beyond the largest back rake dead rock stands before the face: nothing changes any more.
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

}  // namespace tdbd::forces::thin_cut_test
