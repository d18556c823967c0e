#include "reference/dynamics/lumped_drilling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::reference::lumped_drilling_test {

using dynamics::AxialMode;
using dynamics::DamperEnd;
using dynamics::DrillingSystem;

/// Stored energy of a state by the twin's own formulas, J.
double stored(const DrillingSystem& s, const LumpedState& x) {
  const double eccentricity =
      (x.c_W + x.bit.R_WB * (Vec3(0.0, 0.0, s.wall.ring_z_B) - s.centre_B)).head<2>().norm();
  const double depth = std::max(eccentricity - s.wall.clearance, 0.0);
  return total_energy(s.gyrostat, {}, x.bit) + 0.5 * s.mass * x.v_W.squaredNorm() +
         0.5 * s.rock.mass * x.rock_v * x.rock_v + 0.5 * s.rock.stiffness * x.rock_z * x.rock_z +
         0.5 * s.wall.stiffness * depth * depth + string_energy(s, x);
}

/// Its springs come from differences of an energy, its top works by that energy's change, and
/// losses are integrated apart: that the sum stays put ties them together.
TEST(LumpedDrilling, its_energy_is_accounted_for) {
  for (const AxialMode axial : {AxialMode::rate, AxialMode::load})
    for (const DamperEnd end : {DamperEnd::space, DamperEnd::top}) {
      const DrillingSystem s = dynamics::coupled_bit(axial, end);
      const LumpedState from = lumped_state(s, dynamics::coupled_start(s));
      const LumpedRun run = lumped_drilling(s, dynamics::smooth_law, from, 0.5);
      const LumpedEnergy& e = run.energy;
      const double in = e.top + e.gravity + e.cut_bit + e.cut_rock;
      const double lost =
          e.damped_string + e.damped_bearings + e.damped_rock + e.wall_loss + e.wall_friction;
      EXPECT_NEAR(stored(s, run.state) - stored(s, from), in - lost, 1e-12 * stored(s, from));
    }
}

/// Spring, mass and damper along z, and a torsional pendulum: closed forms.
TEST(LumpedDrilling, damped_oscillations_are_the_closed_forms) {
  DrillingSystem s;
  s.mass = 500.0;
  s.gyrostat = dynamics::make_gyrostat(Vec3(8.0, 8.0, 2.0).asDiagonal(), {});
  s.string.stiffness.diagonal().z() = 7e5;
  s.string.damping.diagonal().z() = 3e3;
  s.string.turn_stiffness.diagonal().z() = 938.0;
  s.string.turn_damping.diagonal().z() = 5.0;
  LumpedState from;
  from.c_W.z() = 0.01;
  from.bit.twist = 0.5;
  from.bit.R_WB = Eigen::AngleAxisd(0.5, Vec3::UnitZ()).toRotationMatrix();
  const LumpedState end = lumped_drilling(s, nullptr, from, 1.0).state;
  const auto ring = [](double inertia, double damping, double stiffness, double t) {
    const double decay = 0.5 * damping / inertia;
    const double w = std::sqrt(stiffness / inertia - decay * decay);
    return std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
  };
  EXPECT_NEAR(end.c_W.z(), 0.01 * ring(500.0, 3e3, 7e5, 1.0), 1e-12);
  EXPECT_NEAR(end.bit.twist, 0.5 * ring(2.0, 5.0, 938.0, 1.0), 1e-12);
}

/// Without a string it is the gyrostat's own twin.
TEST(LumpedDrilling, a_free_bit_is_the_free_gyrostat) {
  DrillingSystem s = dynamics::coupled_bit(AxialMode::rate, DamperEnd::space);
  s.string = {};
  s.wall = {};
  s.rock = {};
  s.bearing_damping = {0.0, 0.0};
  s.gravity = 0.0;
  const LumpedState from = lumped_state(s, dynamics::coupled_start(s));
  const LumpedState end = lumped_drilling(s, nullptr, from, 0.8).state;
  const GyrostatState alone = runge_kutta(s.gyrostat, {}, from.bit, 0.8).state;
  EXPECT_LT((end.bit.R_WB - alone.R_WB).norm(), 1e-12);
  EXPECT_LT((end.bit.body_momentum_B - alone.body_momentum_B).norm(), 1e-12);
  EXPECT_LT((end.c_W - from.c_W - 0.8 * from.v_W).norm(), 1e-12);
}

/// The rock takes what the bit gives, and both move as the masses say.
TEST(LumpedDrilling, free_rock_and_bit_keep_their_momentum) {
  DrillingSystem s;
  s.mass = 500.0;
  s.gyrostat = dynamics::make_gyrostat(Vec3(8.0, 8.0, 2.0).asDiagonal(), {});
  s.rock.mass = 280.0;
  LumpedState from;
  from.v_W.z() = 0.1;
  const LumpedLaw contact = [](const auto&, const dynamics::DrillingState& x, const auto&,
                               dynamics::Wrench& w) {
    w.force_W.z() = -8.6e6 * std::max(x.c_W.z() - x.rock_z, 0.0);
    w.rock_force = -w.force_W.z();
  };
  const LumpedState end = lumped_drilling(s, contact, from, 0.02, {1e-12, 1e-12}).state;
  EXPECT_NEAR(end.v_W.z(), 0.1 * (500.0 - 280.0) / 780.0, 1e-12);
  EXPECT_NEAR(end.rock_v, 0.1 * 1000.0 / 780.0, 1e-12);
}

/// A staircase's jump falls between two integrations.
TEST(LumpedDrilling, a_stair_of_load_is_met_at_its_edge) {
  DrillingSystem s;
  s.mass = 500.0;
  s.gyrostat = dynamics::make_gyrostat(Vec3(8.0, 8.0, 2.0).asDiagonal(), {});
  s.top.axial = AxialMode::load;
  s.top.load = dynamics::make_schedule(dynamics::Interpolation::stepwise, {0.0, 0.3}, {0.0, 1e3});
  const LumpedRun run = lumped_drilling(s, nullptr, LumpedState{}, 1.0);
  const LumpedState& end = run.state;
  EXPECT_LT(run.evaluations, 500);  // no creeping up to the edge
  EXPECT_NEAR(end.v_W.z(), 0.7 * 1e3 / 500.0, 1e-12);
  EXPECT_NEAR(end.c_W.z(), 0.5 * 0.7 * 0.7 * 1e3 / 500.0, 1e-12);
}

}  // namespace tdbd::reference::lumped_drilling_test
