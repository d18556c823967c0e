#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "forces/rock/rock_material.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::simulation::case_forces_test {

using bit::PartKind;

Case shale(std::vector<std::string> settings) {
  settings.emplace_back("rock.edge_length='4 mm'");
  return read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml", settings);
}

template <class L>
const L& law(const Case& c, PartKind kind) {
  return std::get<L>(law_of(c.forces, kind));
}

TEST(ReadForces, gives_the_law_to_the_kinds_that_it_accepts) {
  const Case c = shale({});
  EXPECT_EQ(law<forces::HansonHansen>(c, PartKind::face).A1, 1.0);
  EXPECT_EQ(law<forces::HansonHansen>(c, PartKind::chamfer).A5, 1.0);
  EXPECT_EQ(law<forces::Friction>(c, PartKind::cutter_body).cap, 1.5);
  EXPECT_EQ(law<forces::Friction>(c, PartKind::gage_pad).full_angle, 0.01);
  EXPECT_EQ(law<forces::Friction>(c, PartKind::bit_body).full_angle, 0.0);
}

/// Friction acts on pads and bodies; on the body of a cutter only if a table enables it.
TEST(ReadForces, gives_friction_to_pads_and_bodies) {
  const Case c = shale({"forces={law='friction', stress='20 MPa', mu=0.25}"});
  EXPECT_EQ(law<forces::Friction>(c, PartKind::gage_pad).stress, 20e6);
  EXPECT_EQ(law<forces::Friction>(c, PartKind::bit_body).stress, 20e6);
  EXPECT_EQ(law<forces::Friction>(c, PartKind::chamfer).stress, 20e6);
  EXPECT_GT(law<forces::Friction>(c, PartKind::cutter_body).stress, 1e300);
  law<forces::NoForce>(c, PartKind::face);
}

TEST(ReadForces, accepts_no_law_where_every_kind_has_its_own) {
  const Case c = shale({"forces={law='none', gage_pad={law='friction', stress='1 MPa', mu=0.1}}"});
  EXPECT_EQ(law<forces::Friction>(c, PartKind::gage_pad).mu, 0.1);
}

TEST(ReadForces, lets_a_kind_have_its_own) {
  const Case c = shale({"forces.gage_pad.law=friction", "forces.gage_pad.mu=0.25",
                        "forces.gage_pad.stress='20 MPa'", "forces.cutter_body.law=none"});
  EXPECT_EQ(law<forces::Friction>(c, PartKind::gage_pad).stress, 20e6);
  law<forces::NoForce>(c, PartKind::cutter_body);
}

/// The bit has no cone.
TEST(ReadForces, warns_of_a_coefficient_without_effect_by_the_full_name_of_its_key) {
  const Case c = shale({"forces.cone.law=friction", "forces.cone.mu=0.25",
                        "forces.cone.stress='20 MPa'", "forces.cone.cap=2"});
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_EQ(c.warnings.front().key, "forces.cone.cap");
}

/// What is usual is what the named coefficients have, not what the law has without them. Bit B has no cse.
TEST(ReadForces, derives_defaults_from_the_given_coefficients) {
  const auto warned = [](const std::string& A7) {
    return shale({"forces.coefficients='hanson-hansen-sharp'", "forces.A7=" + A7}).warnings;
  };
  EXPECT_TRUE(warned("0.5").empty());
  for (const std::string other : {"0", "0.4"}) {
    ASSERT_EQ(warned(other).size(), 1u) << other;
    EXPECT_EQ(warned(other).front().key, "forces.A7");
  }
}

TEST(ReadForces, takes_coefficients_by_name_and_changes_them) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/bit-b-steady.toml",
                           {"rock.edge_length='4 mm'", "rock.material='berea-sandstone'",
                            "forces.coefficients='detournay-berea'", "forces.zeta=0.5"});
  const auto& cutting = law<forces::Detournay>(c, PartKind::face);
  EXPECT_EQ(cutting.zeta, 0.5);
  EXPECT_GT(cutting.eps, 30e6);  // 39 to 51 MPa
  EXPECT_LT(cutting.eps, 60e6);
}

/// Mancos shale, 65 MPa and 23.8 degrees, under 3000 psi: 16.5 ksi.
TEST(ReadFormation, confines_the_rock) {
  const Case c = shale({});
  ASSERT_EQ(c.forces.rock.strengths.size(), 1u);
  constexpr double psi = 6894.757293168361;  // Pa
  const double sine = std::sin(23.8 * std::numbers::pi / 180.0);
  const double expected = 65e6 + 3000.0 * psi * (1.0 + sine) / (1.0 - sine);
  EXPECT_NEAR(c.forces.rock.strengths.front().confined, expected, 1e-12 * expected);
}

TEST(ReadFormation, has_layers_that_dip) {
  const Case c = shale({"rock.layers=[{top='10 mm', material='berea-sandstone'}]",
                        "rock.dip='30 deg'", "rock.dip_azimuth='90 deg'"});
  const forces::Formation& rock = c.forces.rock;
  ASSERT_EQ(rock.strengths.size(), 2u);
  const double sine = std::sin(std::numbers::pi / 6.0), cosine = std::cos(std::numbers::pi / 6.0);
  EXPECT_LT((rock.normal_W - Vec3(0.0, -sine, cosine)).norm(), 1e-15);
  const double sandstone = forces::rock_named("berea-sandstone").unconfined;
  EXPECT_NE(forces::strength_at(rock, Vec3::Zero()).unconfined, sandstone);
  EXPECT_EQ(forces::strength_at(rock, Vec3(0.0, -0.03, 0.0)).unconfined, sandstone);
}

TEST(ReadFormation, rejects_layers_out_of_order) {
  EXPECT_THROW(shale({"rock.layers=[{top='10 mm', material='berea-sandstone'}, {top='5 mm', "
                      "material='mancos-shale'}]"}),
               InputError);
}

}  // namespace tdbd::simulation::case_forces_test
