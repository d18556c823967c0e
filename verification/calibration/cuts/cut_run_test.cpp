#include "calibration/cuts/cut_run.hpp"

#include <gtest/gtest.h>

#include "calibration/fit/problem.hpp"
#include "calibration/made_up_laboratory.hpp"
#include "calibration/twin_readings.hpp"
#include "core/error.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::calibration::cut_run_test {
namespace {

constexpr long steps = 60;
constexpr double depth = 1e-3;

/// Bit B in coarse rock.
simulation::Case coarse_case() {
  CalibrationCase c = made_up_case();
  c.grid = {.edge_length = 4e-3, .revolutions = 2, .steps_per_revolution = steps};
  return cut_case(c, {"B", ToolKind::bit, TDBD_SOURCE_DIR "/cases/bits/bit-b.toml", {}}, depth);
}

TEST(CutCase, has_the_break_out_of_the_calibration) {
  EXPECT_FALSE(simulation::spalls(coarse_case().spalling));
  CalibrationCase c = made_up_case();
  c.grid = {.edge_length = 4e-3, .revolutions = 2, .steps_per_revolution = steps};
  c.grid.breakout = {1.1, 0.7, 0.3};
  const simulation::Case made =
      cut_case(c, {"B", ToolKind::bit, TDBD_SOURCE_DIR "/cases/bits/bit-b.toml", {}}, depth);
  EXPECT_NE(made.hash, coarse_case().hash);
  ASSERT_EQ(made.spalling.rules.size(), made.bit.cutters.size());
  for (const auto& rule : made.spalling.rules) {
    ASSERT_TRUE(rule);
    EXPECT_EQ(rule->angle, 1.1);
    EXPECT_EQ(rule->depth_share, 0.7);
    EXPECT_EQ(rule->ahead_share, 0.3);
  }
}

/// One run of two revolutions: its mean cuts, and every step's cuts of the last one at its motion.
struct Drilled {
  CutRun mean;
  std::vector<std::vector<forces::PartCut>> steps;
};

forces::Strength rock() { return {.unconfined = 60e6, .confined = 90e6}; }

bool is_of_a_cutter(const forces::PartCut& cut) {
  return cut.kind == bit::PartKind::face || cut.kind == bit::PartKind::chamfer;
}

Drilled drill() {
  const simulation::Case c = coarse_case();
  Drilled d{make_cut_run(c, depth, steps), {}};
  simulation::Simulation s = simulation::start(c);
  for (long step = 0; step < c.time.steps; ++step) {
    simulation::step(c, s);
    if (step < c.time.steps - steps) continue;
    std::vector<forces::PartCut>& cuts = d.steps.emplace_back();
    for (const simulation::CutOfPart& cut : s.work.cuts) {
      cuts.push_back(
          simulation::cut_at(c.bit, s.state.place.X_WB, s.work.velocity, c.time.step, cut));
      cuts.back().strength = rock();
    }
    std::erase_if(cuts, [](const auto& cut) { return !is_of_a_cutter(cut); });
  }
  return d;
}

const Drilled& drilled() {
  static const Drilled d = drill();
  return d;
}

Record record_at(double speed) {
  Record r;
  r.speed = speed;
  r.depth = depth;
  r.rate = depth * speed / (2 * pi);
  return r;
}

Loads of_mean_cuts(const forces::Law& law, double speed) {
  Sample s = sample_of(drilled().mean, record_at(speed), rock(), law);
  s.others = {};
  return mean_loads(law, s);
}

/// Relative, of the loads: products of what varies within a revolution. Seen 1.2e-5 and 2.3e-6.
constexpr double of_mean_thrust = 3.5e-5, of_mean_torque = 6.7e-6;

TEST(CutRun, the_law_of_mean_cuts_is_the_mean_over_steps) {
  for (const double A3 : {10 * degree, 25 * degree, 40 * degree}) {
    forces::HansonHansen law = hidden_law();
    law.A3 = A3;
    const Loads mean = of_mean_cuts(law, 4 * pi);
    const Eigen::Vector2d twin =
        reference::mean_over_steps(drilled().steps, twin_coefficients(law));
    EXPECT_NEAR(mean[axial] / twin[0], 1.0, of_mean_thrust);
    EXPECT_NEAR(mean[turning] / twin[1], 1.0, of_mean_torque);
  }
}

/// Forces fade at slow parts: seen 4.1e-5.
TEST(CutRun, rotary_speed_carries_no_information) {
  constexpr double fading = 1e-4;
  const Loads fast = of_mean_cuts(hidden_law(), 4 * pi), slow = of_mean_cuts(hidden_law(), 2 * pi);
  for (const std::size_t k : {axial, turning}) EXPECT_NEAR(slow[k] / fast[k], 1.0, fading);
}

TEST(CutRun, its_faces_and_cutters_stand_where_they_are_on_the_bit) {
  const simulation::Case c = coarse_case();
  for (const simulation::CutOfPart& cut : drilled().mean.cuts) {
    if (cut.cut.kind != bit::PartKind::face) continue;
    const bit::Cutter& cutter = c.bit.cutters[at(c.bit.parts[at(cut.part)].cutter)];
    EXPECT_LT((cut.cut.point - cutter.X_BC.p).norm(), cutter.diameter) << cut.part;
    EXPECT_NEAR(cut.forward_W.dot(cutter.X_BC.R.col(0)), 1.0, 1e-14);
    EXPECT_NEAR(cut.cut.normal.norm(), 1.0, 1e-14);
  }
}

/// A revolution removes a slab as thick as the depth, in shares that its steps' cuts add up to.
TEST(CutRun, has_the_diameters_and_the_volume_of_its_cutters) {
  const simulation::Case c = coarse_case();
  double volume = 0.0;
  for (const simulation::CutOfPart& cut : drilled().mean.cuts) {
    volume += cut.cut.removed_volume;
    if (cut.cut.kind != bit::PartKind::face) continue;
    const int cutter = c.bit.parts[at(cut.part)].cutter;
    EXPECT_EQ(cut.cut.diameter, c.bit.cutters[at(cutter)].diameter);
  }
  const double slab = pi * c.bit.gage_radius * c.bit.gage_radius * depth;
  EXPECT_NEAR(volume * steps / slab, 1.0, 4.1e-3);
}

TEST(CutRun, a_depth_is_known_to_a_picometre) {
  Record r = record_at(4 * pi);
  const double before = depth_of_run(r);
  r.depth *= 1.0 + 1e-15;
  EXPECT_EQ(depth_of_run(r), before);
  r.depth += 2e-12;
  EXPECT_NE(depth_of_run(r), before);
}

TEST(CutRun, of_a_bit_with_cones_is_rejected) {
  const CalibrationCase c = made_up_case();
  try {
    cut_case(c, {"R", ToolKind::bit, TDBD_SOURCE_DIR "/cases/bits/bit-r.toml", {}}, depth);
    FAIL() << "expected a refusal";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "case.toml: bits.R: found a bit with cones, expected fixed cutters: the cuts of "
                 "teeth have no mean place on the bit");
  }
}

}  // namespace
}  // namespace tdbd::calibration::cut_run_test
