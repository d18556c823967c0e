#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/parallel.hpp"
#include "dynamics/drilling/energy_ledger.hpp"
#include "simulation/result/figures.hpp"
#include "simulation/result/recorder.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/same_run.hpp"

/// Bit B at the end of 2500 m of pipe and collars.
namespace tdbd::simulation::chain_run_test {

Case on_chain(std::vector<std::string> settings = {}) {
  settings.insert(settings.begin(), {"rock.edge_length='6 mm'", "time.duration='0.1 s'"});
  return read_case(TDBD_SOURCE_DIR "/cases/string-drill-bit-b.toml", settings);
}

void drill(const Case& c, Simulation& s, int steps) {
  for (int i = 0; i < steps; ++i) step(c, s);
}

TEST(ChainRun, continues_from_a_checkpoint_and_on_two_threads_bitwise_identical) {
  const Case c = on_chain();
  Simulation whole = start(c);
  drill(c, whole, 20);
  const auto file = test_folder() / "checkpoint.bin";
  write_checkpoint(file, c, whole, {});
  Checkpoint saved = read_checkpoint(file, c);
  Simulation resumed = resume(c, std::move(saved.state), std::move(saved.statistics));
  const ThreadLimit limit(2);
  drill(c, whole, 20);
  drill(c, resumed, 20);
  expect_same_run(whole, resumed);
}

/// At the start the hook carries what the bit does not: the weight of string and bit in mud, less what
/// the mud takes of a string that goes down, and the surface torque is that at the bit and that of the
/// mud.
TEST(ChainRun, starts_with_the_loads_at_the_surface_that_balance_the_bit) {
  constexpr double rounding = 1e-9;
  const Case c = on_chain();
  const Simulation s = start(c);
  const dynamics::DrillingSystem& system = c.drilling.system;
  const DriveRow row = drive_row(system, *s.state.drive, s.work.drive, 0.0);
  const string::Chain& chain = system.chained->chain;
  double weight = system.mass * system.gravity, masses = 0.0, inertias = 0.0;
  for (std::size_t i = 0; i + 1 < chain.contact.weight.size(); ++i) {
    weight += chain.contact.weight[i];
    masses += chain.elements.mass[i];
    inertias += chain.elements.inertia[i];
  }
  const double rate = c.motion.rate_of_penetration, speed = c.motion.rotary_speed;
  const double damper = system.string.damping(2, 2) * rate;
  EXPECT_NEAR(row.hook_load, weight - 26e3 - damper - chain.axial_damping * masses * rate,
              rounding * weight);
  EXPECT_NEAR(row.surface_torque, 2200.0 + chain.torsional_damping * inertias * speed,
              rounding * row.surface_torque);
}

/// Across a hole of 60 degrees the bit weighs what its own mass does, along it half of that.
TEST(ChainRun, weighs_the_bit_along_and_across_an_inclined_hole) {
  constexpr double rounding = 1e-12, steel_in_mud = 1.0 - 1200.0 / 7850.0, g = 9.80665;
  const Case c = on_chain({"string.survey.measured_depth=[0,600,2500]",
                           "string.survey.inclination=['0 deg','60 deg','60 deg']",
                           "string.survey.azimuth=[0,0,0]"});
  const dynamics::DrillingSystem& s = c.drilling.system;
  const double cell = s.chained->chain.elements.mass.back(), own = s.mass - cell;
  EXPECT_NEAR(s.mass * s.gravity_across / (own * g * std::sqrt(0.75)), 1.0, rounding);
  EXPECT_NEAR(s.mass * s.gravity / (0.5 * g * (own + steel_in_mud * cell)), 1.0, rounding);
  EXPECT_EQ(on_chain().drilling.system.gravity_across, 0.0);
}

/// What the ledger does not explain, over steps: rock is cut once a step, so that only what springs and
/// drift make is left. Its largest value falls with the square of the step.
TEST(ChainRun, closes_the_ledger_of_energy) {
  const auto largest = [](const char* step_length) {
    const Case c = on_chain({std::string("time.step=") + step_length});
    Simulation s = start(c);
    double most = 0.0;
    while (s.state.steps_done < c.time.steps) {
      step(c, s);
      most = std::max(
          most,
          std::abs(dynamics::residual(
              dynamics::stored_energy(c.drilling.system, s.work.drive.at, s.state.drive->state),
              s.state.drive->ledger)));
    }
    return most / dynamics::throughput(s.state.drive->ledger);
  };
  const double coarse = largest("1e-3"), fine = largest("0.25e-3");
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(fine, 0.2 * coarse);
}

/// Means of a run from a time on, s.
struct Means {
  double weight = 0.0, torque = 0.0, rate = 0.0, rotary_speed = 0.0;  ///< N, N m, m/s, rad/s
};

Means means(const Case& c, double from) {
  Simulation s = start(c);
  Means m;
  double depth = 0.0, turned = 0.0, samples = 0.0;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    if (time_at(c.time, s.state.steps_done) <= from) {
      depth = s.state.place.X_WB.p.z();
      turned = s.state.place.turned;
      continue;
    }
    samples += 1.0;
    m.weight -= s.work.loads.force_W.z();
    m.torque -= s.work.loads.torque_W.z();
  }
  m.weight /= samples;
  m.torque /= samples;
  m.rate = (s.state.place.X_WB.p.z() - depth) / (samples * c.time.step);
  m.rotary_speed = (s.state.place.turned - turned) / (samples * c.time.step);
  return m;
}

/// The bit that the chain lets go down, and one that is moved at the speeds that were found.
TEST(ChainRun, drills_at_the_weight_and_torque_of_the_same_motion_without_a_string) {
  constexpr double oscillation = 0.02;  // what is left of the start's in means of two seconds
  const Means found = means(on_chain({"time.duration='4 s'", "string.friction.axial_damping=2",
                                      "string.friction.torsional_damping=2"}),
                            2.0);
  const Means moved = means(read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml",
                                      {"rock.edge_length='6 mm'", "time.revolutions=5",
                                       "measure.section_at_face='extrapolated'",
                                       fmt::format("motion.rate_of_penetration={}", found.rate),
                                       fmt::format("motion.rotary_speed={}", found.rotary_speed)}),
                            0.5);
  EXPECT_NEAR(found.weight, moved.weight, oscillation * moved.weight);
  EXPECT_NEAR(found.torque, moved.torque, oscillation * moved.torque);
}

}  // namespace tdbd::simulation::chain_run_test
