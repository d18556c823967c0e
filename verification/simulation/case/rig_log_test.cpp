#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "core/read_file.hpp"
#include "io/archive.hpp"
#include "simulation/case/top_settings.hpp"
#include "simulation/chain/chain_run.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/core/temporary_file.hpp"

namespace tdbd::simulation::rig_log_test {

using dynamics::Interpolation;

/// A chain of 20 elements without rock; `more`: settings.
ChainCase chain(const std::string& tables, std::vector<std::string> more = {}) {
  return read_chain_case(
      write_temporary(".toml",
                      "[string]\nmodel = \"chain\"\nmass = 200\ntorsional_inertia = 2\n"
                      "element_length = 50\n[[string.sections]]\nlength = 1000\n"
                      "outer_diameter = 0.127\ninner_diameter = 0.1086\n"
                      "[time]\nstep = 4e-3\nduration = 4\n" +
                          tables),
      more);
}

ChainSimulation finished(const ChainCase& c) {
  ChainSimulation s = start_chain(c);
  advance_chain(c, s, c.time.steps);
  return s;
}

Case drilling(std::vector<std::string> more) {
  more.insert(more.begin(), {"rock.edge_length='6 mm'", "time.duration='20 ms'"});
  return read_case(TDBD_SOURCE_DIR "/cases/string-drill-bit-b.toml", more);
}

std::string state_after(const Case& c, int steps) {
  Simulation s = start(c);
  for (int i = 0; i < steps; ++i) step(c, s);
  std::ranges::sort(s.state.rock.touched_list);
  ArchiveWriter write;
  write(s.state);
  return std::move(write).archive().bytes;
}

/// The case without the two speeds of [motion], which its log gives.
Case logged(const std::string& log) {
  std::string text = read_file(TDBD_SOURCE_DIR "/cases/string-drill-bit-b.toml", "a case");
  for (const char* line : {"rotary_speed = \"120 rpm\"\n", "rate_of_penetration = \"20 m/h\"\n"})
    text.erase(text.find(line), std::strlen(line));
  text.replace(text.find("bits/bit-b.toml"), 15, TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  return read_case(write_temporary(".toml", text + log),
                   {"rock.edge_length='6 mm'", "time.duration='20 ms'"});
}

/// The whole run, rock and all.
TEST(RigLog, with_the_values_of_a_schedule_gives_a_bitwise_identical_run) {
  const std::string file = write_temporary(
      ".csv", "clock [s],speed [rad/s],block [m/s]\n5,12,0.005\n5.01,13,0.006\n5.03,11,0.004\n");
  const Case by_log =
      logged("[string.top.log]\nfile = \"" + file +
             "\"\ntime = \"clock\"\nrotary_speed = \"speed\"\nblock_speed = \"block\"\n");
  // The differences of the file's times are those of the schedule.
  const auto times = fmt::format("times=[0, {}, {}], between='linear'", 5.01 - 5.0, 5.03 - 5.0);
  const Case by_schedule =
      drilling({"motion.rotary_speed={values=[12, 13, 11], " + times + "}",
                "motion.rate_of_penetration={values=[0.005, 0.006, 0.004], " + times + "}"});
  const std::string a = state_after(by_log, 12), b = state_after(by_schedule, 12);
  EXPECT_TRUE(a == b);
  const Case other =
      drilling({"motion.rotary_speed={values=[12, 14, 11], " + times + "}",
                "motion.rate_of_penetration={values=[0.005, 0.006, 0.004], " + times + "}"});
  EXPECT_TRUE(state_after(other, 12) != b);
}

/// A record of constant speeds and hook load against the keys that say the same.
TEST(RigLog, of_constants_moves_a_chain_as_the_keys_do) {
  constexpr double rounding = 3e-11;
  const std::string file = write_temporary(
      ".las",
      "~V\nWRAP. NO :\n~C\nT.MIN :\nRPM.RPM :\nHL.KN :\n~A\n0 60 250\n0.05 60 250\n0.1 60 250\n");
  const ChainSimulation a =
      finished(chain("[string.top]\naxial = \"hook-load\"\n[string.top.log]\nfile = \"" + file +
                     "\"\ntime = \"T\"\nrotary_speed = \"RPM\"\nhook_load = \"HL\"\n"));
  const ChainSimulation b = finished(chain(
      "[string.top]\naxial = \"hook-load\"\nhook_load = \"250 kN\"\n[motion]\nrotary_speed = \"60 "
      "rpm\"\n"));
  const string::BitState &x = a.state.bit, &y = b.state.bit;
  EXPECT_GT(y.displacement, 0.1) << "it falls";
  EXPECT_NEAR(x.displacement, y.displacement, rounding * y.displacement);
  EXPECT_NEAR(x.angle, y.angle, rounding * y.angle);
}

/// Linear between rows: of order 2 in their distance, where the quantity is smooth.
TEST(RigLog, with_finer_rows_of_smooth_quantities_converges_with_order_2) {
  ChainCase c = chain("");
  const auto angle = [&](int rows) {
    std::vector<double> t, v;
    for (int i = 0; i <= rows; ++i) {
      t.push_back(4.0 * i / rows);
      v.push_back(6.0 + 3.0 * std::sin(2.0 * t.back()));
    }
    c.plan.log.rotary_speed = dynamics::make_schedule(Interpolation::linear, t, v);
    return finished(c).state.bit.angle;
  };
  const double fine = angle(4096), a = std::abs(angle(64) - fine), b = std::abs(angle(128) - fine);
  EXPECT_GT(a, 1e-4);
  EXPECT_NEAR(std::log2(a / b), 2.0, 0.06);
}

/// What the ledger does not explain while the hook load of a log changes and friction acts.
TEST(RigLog, keeps_the_ledger_to_order_2_while_the_hook_load_changes) {
  const auto residual = [](double h) {
    ChainCase c = chain(
        "[string.top]\naxial = \"hook-load\"\n[string.friction]\nstatic = 0.2\n"
        "[string.survey]\nmeasured_depth = [0, 1000]\ninclination = [0.2, 0.8]\nazimuth = [0, 0]\n"
        "[motion]\nrotary_speed = 6\n",
        {fmt::format("time.step={}", h)});
    std::vector<double> t, v;
    for (int i = 0; i <= 64; ++i) {
      t.push_back(4.0 * i / 64);
      v.push_back(c.plan.hook_load * (1.0 - 0.1 * std::sin(1.5 * t.back())));
    }
    c.plan.log.hook_load = dynamics::make_schedule(Interpolation::linear, t, v);
    const ChainSimulation s = finished(c);
    EXPECT_GT(std::abs(s.state.chain.ledger.top), 100.0) << "J";
    return s.figures.residual;
  };
  const double a = residual(4e-3), b = residual(2e-3), c = residual(1e-3);
  constexpr double higher_orders = 4e-3;
  EXPECT_NEAR(std::log2(a / b), 2.0, higher_orders);
  EXPECT_NEAR(std::log2(b / c), 2.0, higher_orders);
}

/// A step has the mean of the hook load, not its value at either end.
TEST(RigLog, of_a_changing_hook_load_converges_in_the_step_with_order_2) {
  const auto fallen = [](double h) {
    ChainCase c = chain("[string.top]\naxial = \"hook-load\"\n", {fmt::format("time.step={}", h)});
    std::vector<double> t, v;
    for (int i = 0; i <= 50; ++i) {
      t.push_back(4.0 * i / 50);
      v.push_back(c.plan.hook_load * (1.0 - 0.1 * std::sin(1.5 * t.back())));
    }
    c.plan.log.hook_load = dynamics::make_schedule(Interpolation::linear, t, v);
    return finished(c).state.chain.displacement[0];
  };
  constexpr double higher_orders = 0.4;
  const double fine = fallen(0.25e-3);
  const double a = std::abs(fallen(4e-3) - fine), b = std::abs(fallen(2e-3) - fine);
  EXPECT_GT(a, 1e-6);
  EXPECT_NEAR(std::log2(a / b), 2.0, higher_orders);
}

/// The bit that drills hangs from the log's hook load; its first row is the start of the run.
TEST(RigLog, of_a_hook_load_carries_a_bit_that_drills) {
  constexpr double rounding = 1e-12;
  const std::string file = write_temporary(".csv", "t [s],HL [kN]\n10,690\n10.004,698\n11,698\n");
  const Case c = drilling({"string.top.axial=hook-load",
                           "string.top.log={file='" + file + "', time='t', hook_load='HL'}"});
  Simulation s = start(c);
  for (const double expected : {691e3, 693e3, 695e3, 697e3, 698e3}) {
    step(c, s);
    EXPECT_NEAR(s.state.drive->chain.top.hook_load, expected, rounding * expected);
  }
}

/// A bit that cannot move, the hook load reduced slowly: the top comes down by the change of load times
/// the static compliance, L/(E A).
TEST(RigLog, of_a_hook_load_stretches_the_string_by_its_compliance) {
  ChainCase c = chain(
      "[string.top]\naxial = \"hook-load\"\n[string.bit]\nlaw = \"fixed\"\n"
      "[string.friction]\naxial_damping = 3\n",
      {"time.duration=12"});
  const double load = c.plan.hook_load, change = -20e3;
  c.plan.log.hook_load = dynamics::make_schedule(Interpolation::linear, {0.0, 5.0, 12.0},
                                                 {load, load + change, load + change});
  const double area = 0.25 * std::numbers::pi * (0.127 * 0.127 - 0.1086 * 0.1086),
               compliance = 1000.0 / (206e9 * area);
  const double down = finished(c).state.chain.displacement[0];
  EXPECT_NEAR(down, -change * compliance, 1.5e-6 * down);
}

}  // namespace tdbd::simulation::rig_log_test
