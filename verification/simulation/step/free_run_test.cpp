#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/temporary_file.hpp"
#include "simulation/result/run.hpp"
#include "simulation/step/simulation.hpp"

/// Whole runs of a bit that forces move, beside closed forms.
namespace tdbd::simulation::free_run_test {

Simulation drilled(const Case& c) {
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) step(c, s);
  return s;
}

/// A case of a shipped bit above a flat rock, which it does not reach.
Case off_bottom(const std::string& bit, const std::string& tables,
                const std::vector<std::string>& settings) {
  const std::string text = std::string("[bit]\nfile = \"") + TDBD_SOURCE_DIR + "/cases/bits/" +
                           bit +
                           ".toml\"\n[rock]\nshape = \"flat\"\nedge_length = \"10 mm\"\n"
                           "wall = \"10 mm\"\nmaterial = \"mancos-shale\"\n" +
                           tables;
  return read_case(write_temporary(".toml", text), settings);
}

/// Its mean is 28.8, 30.1 and 31.9 kN where the damper pulls towards the expected rate
/// (`rate_memory = 0`).
TEST(FreeRun, carries_its_weight_with_any_expected_rate) {
  constexpr double within = 4e-3;
  const auto weight = [](const std::string& rate, const std::string& memory) {
    return drilled(read_case(TDBD_SOURCE_DIR "/cases/drill-bit-b.toml",
                             {"rock.edge_length='4 mm'", "motion.expected_rate='" + rate + " m/h'",
                              memory}))
        .statistics.loads.wob.mean;
  };
  for (const std::string rate : {"0", "25", "60"})
    EXPECT_NEAR(weight(rate, "time.first_step=0"), 30e3, within * 30e3) << rate << " m/h";
  EXPECT_NEAR(weight("0", "motion.rate_memory=0"), 28.8e3, within * 30e3);
}

/// Half a second on the hook at half a metre a second: rad between its axis and the vertical.
double lean_on_hook(const std::vector<std::string>& settings) {
  const Case c = off_bottom("bit-r",
                            "[motion]\nkind = \"drilling\"\nstart = [0, 0, \"-3 m\"]\n"
                            "rotary_speed = \"90 rpm\"\nweight_on_bit = 0\nexpected_rate = 0.5\n"
                            "[string]\ntorsional_stiffness = 0\n"
                            "[time]\nstep = \"1 ms\"\nduration = \"0.5 s\"\n"
                            "[forces]\nlaw = \"indentation\"\n",
                            settings);
  return std::acos(drilled(c).state.place.X_WB.R(2, 2));
}

/// Its centre of mass is 0.4 mm beside its axis and makes it lean by 2 degrees.
TEST(FreeRun, of_a_bit_on_a_hook_does_not_topple) {
  constexpr double degree = std::numbers::pi / 180.0;
  EXPECT_LT(lean_on_hook({}), 4.0 * degree);
  EXPECT_GT(lean_on_hook({"string.attachment_height=0"}), 40.0 * degree);
}

/// Wound up by a radian, with a top at rest.
TEST(FreeRun, of_a_torsional_pendulum_is_not_stick_slip) {
  const Case c =
      off_bottom("bit-b",
                 "[motion]\nkind = \"drilling\"\nstart = [0, 0, \"-300 mm\"]\nrotary_speed = 0\n"
                 "rate_of_penetration = 0\ntorque_at_start = 611.9\n"
                 "[string]\nmass = 1e4\ntorsional_inertia = 288.6\nbending_inertia = 288.6\n"
                 "lateral_stiffness = 1e8\naxial_stiffness = 1e8\nbending_stiffness = 1e8\n"
                 "torsional_stiffness = 611.9\n[time]\nstep = \"2 ms\"\nduration = \"30 s\"\n"
                 "[forces]\nlaw = \"none\"\n",
                 {});
  const Diagnosis d = summary_of(c, drilled(c), RunStatus::completed).diagnosis;
  EXPECT_EQ(d.stick_slip_severity, 0.0);
  EXPECT_EQ(d.text, "off bottom, no contact with rock; torsional vibration at 0.232 Hz");
}

/// Bit M from 0.1 s, when its teeth are in rock.
struct MilledRun {
  double by_part = 0.0,
         total = 0.0;        ///< J, spent on the rock: power by part times step; the ledger's
  double alternation = 0.0;  ///< rad/s, root mean square: of the cones' speeds from step to step
  double tob = 0.0;          ///< N m, mean
};

MilledRun milled(const std::string& step_length, const std::string& edges) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/drill-bit-m.toml",
                           {"time.step='" + step_length + "'", "rock.edge_length='" + edges + "'",
                            "time.duration='0.25 s'", "output.means_from='0.1 s'"});
  Simulation s = start(c);
  MilledRun run;
  std::array<std::vector<double>, 2> before;
  double sum2 = 0.0;
  long count = 0;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    std::vector<double> now;
    for (const ConeState& cone : s.state.cones) now.push_back(cone.speed);
    if (c.time.step * static_cast<double>(s.state.steps_done) > 0.1)
      for (std::size_t k = 0; k < now.size(); ++k, ++count)
        sum2 += std::pow((now[k] - 2.0 * before[1][k] + before[0][k]) / 4.0, 2);
    before = {before[1], now};
  }
  run.alternation = std::sqrt(sum2 / static_cast<double>(count));
  for (const double energy : s.statistics.energy_by_part) run.by_part += energy;
  const dynamics::EnergyLedger& l = s.state.drive->ledger;
  run.total = -l.cut_bit - l.cut_rock;
  run.tob = s.statistics.loads.tob.mean;
  return run;
}

/// With one contact a tooth, its normal between crest and flank, the cones of this bit went to and fro
/// at every step: the alternation was 2.6 to 3.6 rad/s, energies differed by 2.2 % at 1 ms, 3.1 % at
/// 0.5 ms and 4 % at 0.25 ms, and torques by 13 % between edges of 4 and 2 mm.
TEST(MilledTeeth, press_with_crest_and_flanks_apart) {
  const MilledRun shipped = milled("1 ms", "4 mm"), finer = milled("0.5 ms", "4 mm"),
                  smaller = milled("1 ms", "2.8 mm");
  for (const MilledRun& run : {shipped, finer, smaller}) {
    EXPECT_NEAR(run.by_part / run.total, 1.0, 0.005);
    EXPECT_LT(run.alternation, 1.5);
  }
  EXPECT_NEAR(finer.tob / shipped.tob, 1.0, 0.015);
  EXPECT_NEAR(smaller.tob / shipped.tob, 1.0, 0.02);
}

}  // namespace tdbd::simulation::free_run_test
