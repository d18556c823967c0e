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

Strength strong(double confined) { return {.unconfined = 10 * MPa, .confined = confined}; }

/// 10, 20, 30 MPa with planes at 0 and 0.1 m.
Formation beds() {
  Formation f;
  f.tops = {0.0, 0.1};
  f.strengths = {strong(10 * MPa), strong(20 * MPa), strong(30 * MPa)};
  return f;
}

double at(const Formation& f, const Vec3& x_W) { return strength_at(f, x_W).confined / MPa; }

TEST(Formation, of_level_beds_follows_from_depth) {
  EXPECT_EQ(at(beds(), Vec3(1, 2, -1e-9)), 10);
  EXPECT_EQ(at(beds(), Vec3(1, 2, 0.0)), 20);
  EXPECT_EQ(at(beds(), Vec3(-3, 0, 0.0999)), 20);
  EXPECT_EQ(at(beds(), Vec3(0, 0, 0.1)), 30);
  EXPECT_EQ(at(beds(), Vec3(0, 0, 1e9)), 30);
}

/// Beds that dip by 30 degrees to +x lie tan 30 deeper a metre on; along the strike nothing
/// changes.
TEST(Formation, of_dipping_beds_lies_deeper_to_the_side_of_the_dip) {
  Formation f = beds();
  f.normal_W = bedding_normal(30 * degree, 0.0);
  const double deeper = std::tan(30 * degree);
  for (const double x : {-1.0, 0.0, 0.5, 2.0})
    for (const double y : {-4.0, 0.0, 3.0}) {
      EXPECT_EQ(at(f, Vec3(x, y, deeper * x - 1e-9)), 10) << x << ' ' << y;
      EXPECT_EQ(at(f, Vec3(x, y, deeper * x + 1e-9)), 20) << x << ' ' << y;
      EXPECT_EQ(at(f, Vec3(x, y, deeper * x + 0.1 / std::cos(30 * degree) + 1e-9)), 30);
    }
}

/// The slow twin: count the planes that are passed.
RC_GTEST_PROP(LayerAt, counts_the_planes_above_a_point, ()) {
  Formation f;
  f.normal_W = bedding_normal(number(0.0, 90 * degree), number(0.0, 2 * pi));
  double top = number(-1.0, 0.0);
  const std::size_t layers = 1 + index(20);
  f.tops.reserve(layers);
  for (std::size_t k = 0; k + 1 < layers; ++k) f.tops.push_back(top += number(1e-3, 0.1));
  f.strengths.assign(layers, strong(10 * MPa));
  RC_ASSERT(formation_problem(f).empty());
  const Vec3 x = number(0.0, 2.0) * any_direction();
  std::size_t passed = 0;
  for (const double t : f.tops) passed += f.normal_W.dot(x) >= t ? 1 : 0;
  RC_ASSERT(layer_at(f, x) == passed);
}

TEST(FormationProblem, reports_what_is_wrong) {
  EXPECT_EQ(formation_problem(beds()), "");
  Formation f = beds();
  f.tops = {0.1, 0.1};
  EXPECT_EQ(formation_problem(f), "a plane at 0.1 m after one at 0.1 m, expected rising depths");
  f = beds();
  f.strengths.pop_back();
  EXPECT_EQ(formation_problem(f), "2 rocks between 2 planes, expected one rock more than planes");
  f = beds();
  f.normal_W *= 2;
  EXPECT_EQ(formation_problem(f), "a normal of length 2, expected 1");
  f = beds();
  f.strengths[1].confined = 0.0;
  EXPECT_EQ(formation_problem(f), "a strength of 10000000 Pa, confined 0 Pa, expected > 0");
}

}  // namespace tdbd::forces::rock_material_test
