#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulation/case/case.hpp"
#include "simulation/result/recorder.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// Parts that start when the flat of a cutter is so high (removal.from_wear).
namespace tdbd::simulation::wear_start_test {
namespace {

constexpr double stress = 100e6, coefficient = 1e-5, hardness = 50e9, acceleration = 8e4;
constexpr double first = 0.2e-3, due = 0.5e-3;  ///< m, height of the flat of cutter-1 at times
constexpr double from = 1.2;                    ///< s, when wear begins
constexpr double radius = 30e-3, speed = 2.0 * std::numbers::pi;  ///< m, rad/s

/// Two cutters, of which the second starts by the wear of `watched`. Only flats wear, under a steady
/// stress.
Case two_cutters(const std::string& watched, double step) {
  const auto folder = bit::test_folder();
  write_file(
      folder / "two.csv",
      fmt::format("bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,"
                  "profile_angle_deg,back_rake_deg,side_rake_deg,wear_mm\n"
                  "two,1,1,nose,13,{0},0,0,0,15,0,{1}\ntwo,2,2,nose,13,14,180,0.5,0,15,0,{1}\n",
                  1e3 * radius, 1e3 * first));
  write_file(folder / "two.toml",
             fmt::format("name = \"two\"\ntable = \"two.csv\"\ngage_diameter = \"80 mm\"\n"
                         "[cutters]\nchamfer = \"0 mm\"\nlength = \"5 mm\"\n"
                         "[areas.late]\nnames = \"cutter-2/*\"\nremoval.from_wear = {}\n"
                         "removal.worn_names = \"{}\"\n",
                         due, watched));
  return read_case(
      write_file(
          folder / "case.toml",
          fmt::format("[bit]\nfile = \"two.toml\"\n[rock]\nshape = \"flat\"\nradius = 0.046\n"
                      "edge_length = 0.003\nwall = 0.01\nmaterial = \"mancos-shale\"\n"
                      "pressure = \"3000 psi\"\n[motion]\nkind = \"steady\"\n"
                      "rotary_speed = {} \nrate_of_penetration = \"2 m/h\"\n"
                      "[time]\nstep = {}\nduration = 3\n[forces]\nlaw = \"hanson-hansen\"\n"
                      "A1 = 1.0\nA2 = 0.3\nA3 = \"18 deg\"\n[forces.cutter_body]\n"
                      "law = \"friction\"\nfull_angle = 0\nstress = {}\nmu = 0.1\n[wear]\n"
                      "law = \"sliding\"\ncoefficient = {}\nhardness = {}\nacceleration = {}\n"
                      "from = {}\nevery_steps = 1\n[wear.areas.faces]\nkind = \"face\"\n"
                      "law = \"none\"\n",
                      speed, step, stress, coefficient, hardness, acceleration, from)),
      {});
}

bool has_started(const Simulation& s) { return s.work.waits == Waits::none; }

/// Time at the beginning of the step in which the second cutter started; 0: it did not.
double start_of(const Case& c) {
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) {
    const double now = time_at(c.time, s.state.steps_done);
    EXPECT_EQ(s.state.ledger.removed_by_part[2].value(), 0.0);
    step(c, s);
    if (has_started(s)) {
      for (int i = 0; i < 20; ++i) step(c, s);
      EXPECT_TRUE(has_started(s));
      EXPECT_GT(s.state.ledger.removed_by_part[2].value(), 0.0);
      return now;
    }
  }
  return 0.0;
}

/// Under a steady stress the flat loses height at the rate k/H s v: the time is in closed form. The
/// height is that of the last wear step, one time step late.
TEST(WearStart, is_when_the_flat_has_its_height) {
  const double rate = acceleration * coefficient / hardness * stress * speed * radius;
  const double expected = from + (due - first) / rate;
  for (const double step : {8e-3, 4e-3}) {
    const double found = start_of(two_cutters("cutter-1/*", step));
    fmt::print("step {:.0f} ms: starts at {:.4f} s, closed form {:.4f} s\n", 1e3 * step, found,
               expected);
    EXPECT_GE(found, expected - 0.1 * step);
    EXPECT_LE(found, expected + 1.5 * step);
  }
}

/// The second cutter has a flat as high as the first one at the start, and wears only when it cuts.
TEST(WearStart, depends_on_the_cutters_of_its_pattern) {
  EXPECT_EQ(start_of(two_cutters("cutter-2/*", 8e-3)), 0.0);
  EXPECT_GT(start_of(two_cutters("*", 8e-3)), from);
}

/// From checkpoints of two steps before the start to two after it.
TEST(WearStart, is_resumed_from_a_checkpoint_bitwise) {
  const Case c = two_cutters("cutter-1/*", 8e-3);
  Simulation s = start(c);
  const long steps = std::lround(start_of(c) / c.time.step) - 2;
  for (long i = 0; i < steps; ++i) step(c, s);
  for (int k = 0; k < 5; ++k) {
    const auto file = bit::test_folder() / "checkpoint.bin";
    write_checkpoint(file, c, s, {});
    Checkpoint saved = read_checkpoint(file, c);
    Simulation again = resume(c, std::move(saved.state), std::move(saved.statistics)), copy = s;
    EXPECT_EQ(has_started(again), k >= 3);
    for (int i = 0; i < 6; ++i) {
      step(c, again);
      step(c, copy);
    }
    EXPECT_EQ(mesh::positions_of(again.state.rock.surface),
              mesh::positions_of(copy.state.rock.surface));
    EXPECT_EQ(again.work.loads.force_W, copy.work.loads.force_W);
    EXPECT_EQ(again.state.wear->pieces[1].height, copy.state.wear->pieces[1].height);
    step(c, s);
  }
}

}  // namespace
}  // namespace tdbd::simulation::wear_start_test
