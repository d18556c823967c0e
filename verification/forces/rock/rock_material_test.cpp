#include "forces/rock/rock_material.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/error.hpp"
#include "forces/generate.hpp"

namespace tdbd::forces::rock_material_test {

constexpr double psi = 6894.757293168361;

RockMaterial any_rock() {
  return {.name = "rock",
          .unconfined = number(5 * MPa, 200 * MPa),
          .friction_angle = number(0.0, 55 * degree),
          .porosity = number(0.0, 0.4)};
}

BottomHole any_hole() {
  return {.pressure = number(0.0, 100 * MPa),
          .pore_pressure = number(0.0, 100 * MPa),
          .overburden = number(0.0, 200 * MPa)};
}

struct Row {
  std::string_view rock;
  double at_3000, at_6000;  // psi
};

/// Published values, in thousands of psi to three digits.
TEST(StrengthOf, rocks_under_pressure_is_that_of_the_literature) {
  for (const Row& r : {Row{"mancos-shale", 16.5, 23.5},
                       {"berea-sandstone", 18.2, 29.2},
                       {"carthage-marble", 27.1, 38.1},
                       {"sierra-white-granite", 39, 56}}) {
    const RockMaterial rock = rock_named(r.rock);
    const auto confined = [&](double p) {
      return strength_of(rock, {.pressure = p * psi}, Confinement::permeable).confined / psi;
    };
    EXPECT_NEAR(confined(3000) / 1000, r.at_3000, 0.06) << r.rock;
    EXPECT_NEAR(confined(6000) / 1000, r.at_6000, r.at_6000 == 56 ? 0.5 : 0.06) << r.rock;
  }
}

TEST(Strengthening, is_that_of_the_literature) {
  EXPECT_NEAR(strengthening(23.8 * degree), 2.35, 0.005);
  EXPECT_NEAR(strengthening(35 * degree), 3.69, 5e-4);
  EXPECT_EQ(strengthening(0.0), 1.0);
}

/// On Mohr's circle of (dp, Scc) the rock's line of cohesion and friction is a tangent.
RC_GTEST_PROP(StrengthOf, puts_mohrs_circle_on_the_line_of_coulomb, ()) {
  const RockMaterial rock = any_rock();
  const BottomHole hole = any_hole();
  const double phi = rock.friction_angle;
  const double cohesion = rock.unconfined * (1 - std::sin(phi)) / (2 * std::cos(phi));
  const double dp = confining_pressure(hole, Confinement::permeable, rock.porosity);
  const double Scc = strength_of(rock, hole, Confinement::permeable).confined;
  const double centre = (Scc + dp) / 2, radius = (Scc - dp) / 2;
  const double distance = cohesion * std::cos(phi) + centre * std::sin(phi);
  RC_ASSERT(std::abs(distance - radius) < 1e-12 * Scc);
}

TEST(ConfiningPressure, of_tight_rock_is_relieved_by_the_hole) {
  const BottomHole hole{.pressure = 30 * MPa, .pore_pressure = 25 * MPa, .overburden = 60 * MPa};
  EXPECT_DOUBLE_EQ(confining_pressure(hole, Confinement::permeable, 0.1), 5 * MPa);
  EXPECT_DOUBLE_EQ(confining_pressure(hole, Confinement::impermeable, 0.1), 15 * MPa);
  EXPECT_DOUBLE_EQ(confining_pressure(hole, Confinement::by_porosity, 0.05), 15 * MPa);
  EXPECT_DOUBLE_EQ(confining_pressure(hole, Confinement::by_porosity, 0.125), 10 * MPa);
  EXPECT_DOUBLE_EQ(confining_pressure(hole, Confinement::by_porosity, 0.30), 5 * MPa);
}

RC_GTEST_PROP(StrengthOf, is_never_below_the_unconfined_strength, ()) {
  const RockMaterial rock = any_rock();
  for (const Confinement c :
       {Confinement::permeable, Confinement::impermeable, Confinement::by_porosity})
    RC_ASSERT(strength_of(rock, any_hole(), c).confined >= rock.unconfined);
}

TEST(RockNamed, finds_every_rock_of_the_table_and_names_them) {
  std::set<std::string_view> names;
  for (const KnownRock& rock : known_rocks()) {
    EXPECT_TRUE(names.insert(rock.name).second) << rock.name;
    EXPECT_FALSE(rock.source.empty());
    EXPECT_EQ(rock_named(rock.name).unconfined, rock.unconfined.value);
    EXPECT_GT(rock.unconfined.value, 0.0);
    EXPECT_GT(rock.friction_angle.value, 0.0);
    EXPECT_LE(rock.friction_angle.value, 60 * degree);
  }
  EXPECT_THROW(rock_named("granite"), InputError);
}

/// Uniaxial strength from cohesion and angle, as the table has it of the granitoid.
TEST(KnownRocks, derive_the_granitoids_strength_from_its_cohesion) {
  const double phi = 38.66 * degree, derived = 2 * 44.8 * MPa * std::cos(phi) / (1 - std::sin(phi));
  EXPECT_NEAR(rock_named("forge-granitoid").unconfined, derived, 0.05 * MPa);
}

}  // namespace tdbd::forces::rock_material_test
