#include <gtest/gtest.h>

#include <array>

#include "core/observed_order.hpp"
#include "reference/dynamics/lumped_drilling.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::energy_ledger_test {

constexpr std::array names{"top",      "gravity",    "cut, bit", "cut, rock",    "string",
                           "bearings", "rock mount", "wall",     "wall friction"};
using Entries = std::array<double, names.size()>;

template <class E>
Entries entries(const E& e) {
  return {e.top,         e.gravity,       e.cut_bit,
          e.cut_rock,    e.damped_string, e.damped_bearings,
          e.damped_rock, e.wall_loss,     e.wall_friction};
}

/// Each entry against the integral of its power that the twin carries along.
TEST(EnergyLedger, every_entry_converges_to_the_twins_with_order_two) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::top);
  const DrillingState from = coupled_start(s);
  const Entries exact = entries(
      reference::lumped_drilling(s, smooth_law, reference::lumped_state(s, from), 0.8).energy);
  std::vector<double> steps;
  std::array<std::vector<double>, names.size()> errors;
  for (long n = 800; n <= 12'800; n *= 2) {
    DrillingRun d = start(s, smooth_law, from);
    for (long i = 0; i < n; ++i) step(s, smooth_law, 0.8 / static_cast<double>(n), d);
    steps.push_back(0.8 / static_cast<double>(n));
    const Entries found = entries(d.ledger);
    for (std::size_t e = 0; e < found.size(); ++e)
      errors[e].push_back(std::abs(found[e] - exact[e]));
  }
  for (std::size_t e = 0; e < names.size(); ++e) {
    if (exact[e] == 0.0) {
      EXPECT_EQ(errors[e].back(), 0.0) << names[e];  // restitution 1 loses nothing
      continue;
    }
    EXPECT_NEAR(least_squares_order(steps, errors[e]), 2.0, 0.04) << names[e];
    EXPECT_LT(errors[e].back(), 6e-6 * std::abs(exact[e])) << names[e];
  }
}

/// Each by its size, whatever its sign; what dampers and the wall took is no part of it.
TEST(EnergyLedger, throughput_is_the_sum_of_sizes) {
  for (int signs = 0; signs < 32; ++signs) {
    const auto sized = [signs](int k, double size) { return (signs >> k) % 2 == 0 ? size : -size; };
    const EnergyLedger l{.start = sized(0, 1.0),
                         .top = sized(1, 2.0),
                         .gravity = sized(2, 4.0),
                         .cut_bit = sized(3, 8.0),
                         .cut_rock = sized(4, 16.0),
                         .damped_string = 32.0,
                         .damped_bearings = 64.0,
                         .damped_rock = 128.0,
                         .wall_loss = 256.0,
                         .wall_friction = 512.0};
    EXPECT_EQ(throughput(l), 31.0) << signs;
  }
}

/// Constant forces and torques on bit, cones and rock.
const LumpedLaw steady = [](const auto&, const auto&, const auto&, Wrench& w) {
  w = {Vec3(5.0, -9.0, -8e3), Vec3(0.0, 0.0, -30.0), {2.0}, 8e3};
};

/// Falls under `steady`, with dampers of this size.
DrillingSystem falling_bit(double damping) {
  DrillingSystem s = plain_bit();
  s.gyrostat = make_gyrostat(Vec3(2.0, 2.0, 3.0).asDiagonal(), {{Vec3::UnitZ(), 0.1}});
  s.bearing_damping = {0.2 * damping};
  s.string.damping.diagonal() = damping * Vec3(90.0, 40.0, 3e3);
  s.string.turn_damping.diagonal() = damping * Vec3(3.0, 2.0, 5.0);
  s.rock = {0.7, 0.0, 1.5 * damping};
  s.gravity = 9.81;
  s.top = {{}, AxialMode::load, {}, constant(9e3)};
  return make_drilling_system(s);
}

double through(const EnergyLedger& l) { return std::abs(l.cut_bit) + l.top + l.cut_rock; }

TEST(EnergyLedger, closes_to_rounding_under_constant_forces_without_dampers) {
  const DrillingSystem s = falling_bit(0.0);
  DrillingRun d = start(s, steady, at_rest(s));
  for (int i = 0; i < 1000; ++i) step(s, steady, 0.01, d);
  EXPECT_GT(through(d.ledger), 1e4);
  EXPECT_NEAR(residual(s, d), 0.0, 1e-12 * through(d.ledger));
}

/// The mean velocity over a flow is not the drift's while the speed changes.
TEST(EnergyLedger, residual_under_constant_forces_with_dampers_is_of_second_order) {
  const DrillingSystem s = falling_bit(1.0);
  std::vector<double> steps, residuals;
  for (int n = 250; n <= 4000; n *= 2) {
    DrillingRun d = start(s, steady, at_rest(s));
    for (int i = 0; i < n; ++i) step(s, steady, 10.0 / n, d);
    EXPECT_GT(d.ledger.damped_rock, 1e4);
    steps.push_back(10.0 / n);
    residuals.push_back(std::abs(residual(s, d)) / through(d.ledger));
  }
  EXPECT_NEAR(least_squares_order(steps, residuals), 2.0, 0.05);
  EXPECT_LT(residuals.back(), 1e-10);
}

/// However long the step, once the bit falls at the speed at which dampers bear its load.
TEST(EnergyLedger, closes_to_rounding_at_the_terminal_speed) {
  const DrillingSystem s = falling_bit(1e3);
  DrillingRun d = start(s, steady, at_rest(s));
  for (int i = 0; i < 100; ++i) step(s, steady, 0.1, d);
  const double residual_then = residual(s, d), through_then = through(d.ledger);
  for (int i = 0; i < 100; ++i) step(s, steady, 0.1, d);
  EXPECT_NEAR(residual(s, d), residual_then, 1e-12 * (through(d.ledger) - through_then));
}

/// Half a million steps without anything that damps: the residual swings, it does not drift.
TEST(EnergyLedger, residual_stays_bounded) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.string.damping.setZero();
  s.string.turn_damping.setZero();
  s.bearing_damping.clear();
  s.rock.damping = s.wall.friction = 0.0;
  s.top.speed = constant(8.0);
  s.top.rate = {};
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, coupled_start(s));
  double early = 0.0, late = 0.0;
  constexpr int steps = 500'000;
  for (int i = 0; i < steps; ++i) {
    step(s, nullptr, 5e-4, d);
    double& worst = i < steps / 2 ? early : late;
    worst = std::max(worst, std::abs(residual(s, d)));
  }
  EXPECT_LT(late, 1.1 * early);
  const double relative = std::max(early, late) / d.ledger.start;
  EXPECT_LE(relative, 1e-4);
  battery::record({"ours/drilling-energy",
                   "residual of the ledger over half a million steps, part of the energy", relative,
                   "1", "<= 1e-4",
                   relative <= 1e-4 ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// The lead's share: forces of several parts, each at its own point, add up to the wrench's work.
TEST(EnergyLedger, parts_share_the_work_of_the_wrench) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const std::array<Vec3, 3> forces{Vec3(10.0, 20.0, -500.0), Vec3(-90.0, 5.0, -700.0),
                                   Vec3(30.0, 60.0, -20.0)};
  const std::array<Vec3, 3> arms{Vec3(0.1, 0.0, 0.2), Vec3(-0.04, 0.09, 0.2), Vec3(0.0, -0.1, 0.1)};
  const LumpedLaw parts = [&](const auto&, const auto&, const auto&, Wrench& w) {
    for (std::size_t i = 0; i < forces.size(); ++i) {
      w.force_W += forces[i];
      w.torque_W += arms[i].cross(forces[i]);
    }
  };
  DrillingRun d = start(s, parts, coupled_start(s));
  constexpr double h = 1e-3;
  double shared = 0.0;
  for (int i = 0; i < 300; ++i) {
    step(s, parts, h, d);
    for (std::size_t p = 0; p < forces.size(); ++p)
      for (const DrillingVelocity* v : {&d.work.opening, &d.work.closing})
        shared += 0.5 * h * forces[p].dot(point_velocity(*v, arms[p]));
  }
  EXPECT_NEAR(shared, d.ledger.cut_bit, 1e-12 * std::abs(d.ledger.cut_bit));
}

/// The whole impulse of the cones' own spins at the step's end, none at its start; the ledger has
/// its work.
TEST(EnergyLedger, counts_cone_impulses_at_the_end_of_a_step) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  s.bearing_damping.assign(s.gyrostat.cones.size(), 0.0);
  DrillingRun d = start(s, nullptr, coupled_start(s));
  constexpr double h = 1e-3;
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> before = d.state.rotation.cone_momenta;
    open_step(s, h, d, d.work);
    EXPECT_EQ(d.state.rotation.cone_momenta, before);
    EXPECT_EQ(predicted(s, h, d, d.work).rotation.cone_momenta, before);
    Wrench w;
    w.cones = {0.3, -0.2};
    w.cone_impulse = ConeImpulse::at_end;
    const double cut_before = d.ledger.cut_bit;
    close_step(s, h, w, d, d.work);
    double work = 0.0;
    for (std::size_t k = 0; k < w.cones.size(); ++k) {
      EXPECT_DOUBLE_EQ(d.state.rotation.cone_momenta[k], before[k] + h * w.cones[k]);
      work += h * w.cones[k] * d.work.closing.cone_rates[k];
    }
    EXPECT_NEAR(d.ledger.cut_bit - cut_before, work, 1e-14);
  }
  EXPECT_LT(std::abs(residual(s, d)), 3e-4 * std::abs(d.ledger.start));
}

}  // namespace tdbd::dynamics::energy_ledger_test
