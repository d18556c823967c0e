#include "simulation/step/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/tolerance.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::drive_test {

/// Bit B (or R) on a string, 4 mm edges, with what a test sets beside.
Case drilling(std::vector<std::string> settings, const std::string& name = "drill-bit-b") {
  settings.insert(settings.end(), {"rock.edge_length='4 mm'", "time.duration='0.2 s'"});
  return read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", settings);
}

Simulation drilled(const Case& c) {
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) step(c, s);
  return s;
}

/// The velocity is the central difference of positions over a short free flight.
TEST(Drive, has_the_velocity_of_its_places) {
  const Case c = drilling({});
  const dynamics::DrillingSystem& system = c.drilling.system;
  dynamics::Drilling d = start_drive(c);
  const double h = 1e-6;
  const BitVelocity v = velocity_of(system, d.state);
  const Place from = place_of(system, d.state);
  dynamics::DrillingWork work = dynamics::drilling_work(system, d);
  dynamics::open_step(system, h, d, work);
  dynamics::close_step(system, h, {}, d, work);
  const Place to = place_of(system, d.state);
  EXPECT_LT(((to.X_WB.p - from.X_WB.p) / h - v.v_W).norm(),
            4.3e-5);  // m/s; forces act for a microsecond
  EXPECT_NEAR((to.turned - from.turned) / h, v.w_W.z(), 3.8e-4);  // rad/s
}

/// The upper end of the damper starts as fast as the bit, whether it follows it or not.
TEST(Drive, starts_at_the_rate_that_is_expected) {
  for (const char* memory : {"0.5 s", "0 s"}) {
    const Case c = drilling(
        {"motion.expected_rate='9 mm/s'", std::string("motion.rate_memory='") + memory + "'"});
    const dynamics::Drilling d = start_drive(c);
    EXPECT_DOUBLE_EQ(d.state.top_rate, 9e-3);
    EXPECT_NEAR(velocity_of(c.drilling.system, d.state).v_W.z(), 9e-3, 1e-15);
  }
}

/// Wrench about the centre of mass: the same power on a rigid motion as about the bit's origin.
TEST(Drive, moves_torques_to_the_centre_of_mass) {
  const Case c = drilling({});
  const dynamics::DrillingSystem& system = c.drilling.system;
  const dynamics::Drilling d = start_drive(c);
  BitLoads loads;
  loads.force_W = Vec3(1.0, -2.0, 3.0);
  loads.torque_W = Vec3(-0.5, 0.7, 0.9);
  const BitVelocity v = velocity_of(system, d.state);
  const dynamics::Wrench w = wrench_of(system, loads, place_of(system, d.state).X_WB);
  const dynamics::DrillingVelocity centre = dynamics::velocity(system, d.state);
  EXPECT_NEAR(w.force_W.dot(centre.v_W) + w.torque_W.dot(centre.w_W),
              loads.force_W.dot(v.v_W) + loads.torque_W.dot(v.w_W), 1e-12);
  EXPECT_EQ(w.rock_force, -loads.force_W.z());
}

/// Above flat rock nothing touches: no force, and the bit follows its top.
TEST(Drive, has_no_force_without_contact) {
  const Case c = drilling({"rock.shape=flat", "motion.start=['0 mm', '0 mm', '-20 mm']",
                           "motion.torque_at_start=0", "motion.weight_on_bit=0"});
  const Simulation s = drilled(c);
  EXPECT_TRUE(s.work.cuts.empty());
  EXPECT_EQ(s.work.loads.force_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(s.state.ledger.removed.value(), 0.0);
}

/// Eq. 2.2: rock that is free to move takes the momentum that the bit loses to it.
TEST(Drive, transfers_momentum_from_the_bit_to_the_rock) {
  const Case c = drilling({"rock_mount.mass='280 kg'", "string.gravity=0", "string.axial_damping=0",
                           "motion.weight_on_bit='0 N'", "string.axial_stiffness=0"});
  Simulation s = start(c);
  s.state.drive->state.momentum_W.z() = 50.0;
  while (s.state.steps_done < c.time.steps) step(c, s);
  const double rock = s.state.drive->state.rock_momentum;
  EXPECT_GT(rock, 1.0);
  EXPECT_NEAR(s.state.drive->state.momentum_W.z() + rock, 50.0, 1e-12);  // N s
}

/// The spin that a cone has is the one at which the torque on it was evaluated.
TEST(Drive, gives_a_cone_the_impulse_of_the_spin_that_it_leads_to) {
  const Case c = drilling({}, "drill-bit-r");
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps / 2) step(c, s);
  const dynamics::DrillingSystem& system = c.drilling.system;
  const dynamics::DrillingState before = s.state.drive->state;
  step(c, s);
  const dynamics::DrillingVelocity after = dynamics::velocity(system, s.state.drive->state);
  for (std::size_t k = 0; k < c.bit.cones.size(); ++k) {
    const double impulse =
        s.state.drive->state.rotation.cone_momenta[k] - before.rotation.cone_momenta[k];
    const double scale = system.gyrostat.cones[k].axial_inertia * std::abs(after.cone_rates[k]);
    EXPECT_NEAR(impulse, c.time.step * s.work.loads.cone_torques[k], 1e-12 * scale) << k;  // N m s
    EXPECT_NEAR(after.cone_rates[k], s.work.velocity.cone_speeds[k], 0.08) << k;           // rad/s
  }
}

/// A law out of all proportion is too steep for an explicit impulse, and the bit stands. The search for
/// its velocity ends near 0, farther from it in some steps than in others: the mean over the second half
/// of the run is compared.
TEST(Drive, is_stopped_by_a_law_out_of_all_proportion) {
  Case c = drilling({});
  for (forces::Law& law : c.forces.laws)
    if (auto* cutting = std::get_if<forces::HansonHansen>(&law)) cutting->A1 = 1e9;
  c.time.steps = 80;
  Simulation s = start(c);
  while (2 * s.state.steps_done < c.time.steps) step(c, s);
  const Place half = s.state.place;
  while (s.state.steps_done < c.time.steps) step(c, s);
  const double time = 0.5 * c.time.step * static_cast<double>(c.time.steps);
  EXPECT_GT(s.statistics.standing.steps, 40);
  constexpr double rest = 1e-6;  // of the rate at the start
  EXPECT_LT((s.state.place.X_WB.p - half.X_WB.p).norm() / time,
            rest * c.motion.rate_of_penetration);
}

/// A string that is too stiff for the time step throws the bit away: the run reports it and keeps
/// the state before.
TEST(Drive, stops_with_the_state_before_a_step_that_diverges) {
  Case c = drilling({});
  c.drilling.system.spring.diagonal().setConstant(1e12);
  Simulation s = start(c);
  const Vec3 c_W = s.state.drive->state.c_W;
  std::string message;
  try {
    while (s.state.steps_done < c.time.steps) step(c, s);
  } catch (const RunError& e) {
    message = e.what();
  }
  EXPECT_NE(message.find("the motion diverges: "), std::string::npos) << message;
  EXPECT_LT((s.state.drive->state.c_W - c_W).norm(), 1e-15);
  EXPECT_TRUE(s.state.drive->state.momentum_W.allFinite());
}

void expect_same(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(a.state.drive->state.c_W, b.state.drive->state.c_W);
  EXPECT_EQ(a.state.drive->state.momentum_W, b.state.drive->state.momentum_W);
  EXPECT_EQ(a.state.drive->state.rotation.momentum_W, b.state.drive->state.rotation.momentum_W);
  EXPECT_EQ(mesh::positions_of(a.state.rock.surface), mesh::positions_of(b.state.rock.surface));
}

TEST(Drive, does_the_same_twice_and_on_two_threads) {
  const Case c = drilling({});
  const Simulation first = drilled(c);
  expect_same(first, drilled(c));
  const ThreadLimit two(2);
  expect_same(first, drilled(c));
}

/// A cone's speed is that of the step, whether teeth or bearings changed it.
TEST(Drive, has_the_speed_of_the_turn_of_its_cones) {
  const Case c = drilling({}, "drill-bit-r");
  Simulation s = start(c);
  for (int i = 0; i < 20; ++i) {
    const std::vector<ConeState> before = s.state.cones;
    step(c, s);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const ConeState& cone = s.state.cones[k];
      EXPECT_EQ(cone.turned, cone.angle - before[k].angle);
      EXPECT_NEAR(cone.speed * c.time.step, cone.turned, 1e-12 * std::abs(cone.angle));
      EXPECT_NE(cone.turned, 0.0);
    }
  }
}

/// Cones turn as the teeth's forces make them; the mesh stays sound and the ledger closes.
TEST(Drive, turns_cones_by_the_forces_on_their_teeth) {
  const Case c = drilling({}, "drill-bit-r");
  const Simulation s = drilled(c);
  EXPECT_LT(ledger_defect(s), tolerance::ledger);
  for (std::size_t k = 0; k < s.state.cones.size(); ++k) {
    const double ratio = -s.state.cones[k].angle / s.statistics.cones[k].bit_turned;
    EXPECT_GT(ratio, 1.2);  // rolling: 1.69 at the gage row
    EXPECT_LT(ratio, 1.9);
  }
}

}  // namespace tdbd::simulation::drive_test
