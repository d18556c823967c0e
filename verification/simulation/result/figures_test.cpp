#include "simulation/result/figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "simulation/case/case.hpp"
#include "simulation/step/drive.hpp"

namespace tdbd::simulation::drive_figures_test {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// No two numbers are alike.
dynamics::DrillingSystem springs() {
  dynamics::DrillingSystem s;
  s.mass = 900.0;
  s.gyrostat.inertia_B.diagonal() = Vec3(20.0, 21.0, 15.0);
  s.string.turn_stiffness.diagonal() = Vec3(7000.0, 7000.0, 6000.0);
  s.string.stiffness.diagonal() = Vec3(4e7, 4e7, 3e6);
  s.spring.diagonal() = Vec3(4e7, 4e7, 2e6);
  s.wall.stiffness = 1e6;
  s.wall.clearance = 0.002;
  s.wall.ring_radius = 0.09;
  return s;
}

/// sqrt(k/m)/2 pi; a bit that rolls in its hole goes round w R/(Rh - R) times as fast as it turns.
TEST(Expected, are_the_frequencies_of_springs_and_of_rolling) {
  const Expected e = expected_of(springs(), 12.0);
  EXPECT_DOUBLE_EQ(e.torsional, std::sqrt(6000.0 / 15.0) / two_pi);
  EXPECT_DOUBLE_EQ(e.axial, std::sqrt(2e6 / 900.0) / two_pi);
  EXPECT_DOUBLE_EQ(e.lateral, std::sqrt(4e7 / 900.0) / two_pi);
  EXPECT_DOUBLE_EQ(e.rolling_speed, 12.0 * 0.09);
  EXPECT_DOUBLE_EQ(e.rolling, 12.0 * 0.09 / 0.002 / two_pi);
}

TEST(Expected, are_none_without_a_spring_or_a_wall) {
  dynamics::DrillingSystem s = springs();
  s.string.turn_stiffness.setZero();
  s.spring.setZero();
  s.wall.clearance = 0.0;
  const Expected e = expected_of(s, 12.0);
  EXPECT_EQ(e.torsional, 0.0);
  EXPECT_EQ(e.axial, 0.0);
  EXPECT_EQ(e.rolling, 0.0);
}

/// Well a3 of the acceptance tests: 2300 m of pipe and 200 m of collars without mud, a bit of 200 kg and
/// 1.5 kg m2. Roots of its transcendental equation, Hz.
TEST(Expected, of_a_chain_are_the_first_modes_of_the_whole_string) {
  constexpr double torsional = 0.233776, axial = 0.393024, rounding = 5e-7, of_elements = 2e-6;
  dynamics::DrillingSystem s = springs();
  const string::Diameters pipe{0.127, 0.1086, 0.127}, collars{0.1651, 0.0714, 0.1651};
  const std::vector<string::Section> sections{string::pipe(2300.0, pipe, {}, 0.0, {}),
                                              string::pipe(200.0, collars, {}, 0.0, {})};
  s.chained.emplace();
  s.chained->chain.elements = string::make_elements(sections, 250);
  const string::Elements& e = s.chained->chain.elements;
  s.mass = 200.0 + e.mass.back();
  s.gyrostat.inertia_B(2, 2) = 1.5 + e.inertia.back();
  const Expected found = expected_of(s, 12.0);
  EXPECT_NEAR(found.torsional, torsional, rounding + of_elements * torsional);
  EXPECT_NEAR(found.axial, axial, rounding + of_elements * axial);
}

/// A chain of one element whose own mass is small is the lumped string.
TEST(Expected, of_a_light_chain_of_one_element_are_those_of_the_lumped_string) {
  constexpr double rounding = 1e-12;
  dynamics::DrillingSystem s = springs();
  const Expected lumped = expected_of(s, 12.0);
  s.chained.emplace();
  s.chained->chain.elements = {100.0, {2e6}, {6000.0}, {0.1, 0.1}, {0.01, 0.01}};
  const Expected chain = expected_of(s, 12.0);
  EXPECT_NEAR(chain.torsional, lumped.torsional, rounding);
  EXPECT_NEAR(chain.axial, lumped.axial, rounding);
}

TEST(DiagnosisJson, has_what_was_seen_beside_what_was_expected) {
  Diagnosis d;
  d.text = "backward whirl";
  d.stick_slip_severity = 0.1;
  d.stuck_share = 0.2;
  d.torsional_frequency = 0.3;
  d.lost_contact_share = 0.4;
  d.wob_swing = 0.5;
  d.axial_frequency = 0.6;
  d.orbit_radius = 0.001;
  d.orbit_frequency = -80.0;
  d.whirl = WhirlKind::backward;
  const auto j = diagnosis_json(d, expected_of(springs(), 12.0));
  EXPECT_EQ(j["text"], "backward whirl");
  EXPECT_EQ(j["stick_slip_severity"], 0.1);
  EXPECT_EQ(j["stuck_share"], 0.2);
  EXPECT_EQ(j["torsional_frequency_hz"], 0.3);
  EXPECT_EQ(j["lost_contact_share"], 0.4);
  EXPECT_EQ(j["wob_swing"], 0.5);
  EXPECT_EQ(j["axial_frequency_hz"], 0.6);
  EXPECT_EQ(j["orbit_frequency_hz"], -80.0);
  EXPECT_EQ(j["whirl"], "backward");
  EXPECT_DOUBLE_EQ(j["rolling_frequency_expected_hz"].get<double>(), -12.0 * 0.09 / 0.002 / two_pi);
  EXPECT_DOUBLE_EQ(j["rolling_frequency_at_orbit_hz"].get<double>(), -12.0 * 0.09 / 0.001 / two_pi);
  d.orbit_radius = 0.0;
  EXPECT_EQ(diagnosis_json(d, {})["rolling_frequency_at_orbit_hz"], 0.0);
}

dynamics::EnergyLedger ledger() {
  dynamics::EnergyLedger l;
  l.start = 1.0;
  l.top = 200.0;
  l.gravity = 3.0;
  l.cut_bit = -40.0;
  l.cut_rock = 0.5;
  l.damped_string = 6.0;
  l.damped_bearings = 7.0;
  l.damped_rock = 8.0;
  l.wall_loss = 9.0;
  l.wall_friction = 10.0;
  l.chain_gravity = 2.0;
  l.chain_friction = 1.5;
  l.chain_damping = 2.5;
  l.chain_loss = 0.25;
  l.top_damping = 0.75;
  return l;
}

TEST(EnergyJson, has_every_account_and_what_is_left) {
  DriveFigures f;
  f.ledger = ledger();
  f.stored = {11.0, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0};
  f.cutting_by_part = {{"cutter-1/face", 38.0}};
  const auto j = energy_json(f);
  EXPECT_EQ(j["start_j"], 1.0);
  EXPECT_EQ(j["top_j"], 200.0);
  EXPECT_EQ(j["gravity_j"], 3.0);
  EXPECT_EQ(j["cutting_j"], 40.0);
  EXPECT_EQ(j["cutting_to_rock_motion_j"], 0.5);
  EXPECT_EQ(j["damped_string_j"], 6.0);
  EXPECT_EQ(j["wall_friction_j"], 10.0);
  EXPECT_EQ(j["kinetic_j"], 50.0);
  EXPECT_EQ(j["elastic_j"], 48.0);
  EXPECT_EQ(j["chain_gravity_j"], 2.0);
  EXPECT_EQ(j["chain_friction_j"], 1.5);
  EXPECT_EQ(j["chain_damping_j"], 2.5);
  EXPECT_EQ(j["chain_loss_j"], 0.25);
  EXPECT_EQ(j["top_damping_j"], 0.75);
  EXPECT_EQ(j["chain_j"], 18.0);
  const double put_in = 200.0 + 3.0 + 2.0 - 40.0 + 0.5, left = 116.0 + 45.0 - 1.0 - put_in;
  EXPECT_NEAR(j["residual_j"].get<double>(), left, 1e-12);
  EXPECT_NEAR(j["residual_over_top"].get<double>(), left / 200.0, 1e-14);
  EXPECT_EQ(j["cutting_by_part_j"]["cutter-1/face"], 38.0);
  f.ledger.top = 0.0;
  EXPECT_EQ(energy_json(f)["residual_over_top"], 0.0);
}

TEST(DriveRow, has_the_string_and_the_accounts_of_the_step) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/drill-bit-b.toml", {"rock.edge_length='6 mm'"});
  dynamics::Drilling d = start_drive(c);
  const dynamics::DrillingWork work = dynamics::drilling_work(c.drilling.system, d);
  d.state.rock_z = 0.25;
  d.ledger = ledger();
  const DriveRow row = drive_row(c.drilling.system, d, work, 0.125);
  const dynamics::StoredEnergy stored =
      dynamics::stored_energy(c.drilling.system, work.at, d.state);
  EXPECT_EQ(row.rock_z, 0.25);
  EXPECT_DOUBLE_EQ(row.string_twist, 2600.0 / 5000.0 - 0.125);
  EXPECT_EQ(row.stored, dynamics::total(stored));
  EXPECT_EQ(row.top, 200.0);
  EXPECT_EQ(row.cutting, 40.0);
  EXPECT_EQ(row.lost, 45.0);
  EXPECT_EQ(row.residual, dynamics::residual(stored, d.ledger));
}

}  // namespace tdbd::simulation::drive_figures_test
