#include <gtest/gtest.h>

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
TEST(FreeRun, carries_its_weight_whatever_rate_was_expected) {
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

}  // namespace tdbd::simulation::free_run_test
