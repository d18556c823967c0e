#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "reference/literature/roller/craters/huang_cawthorne.hpp"
#include "reference/literature/roller/roller_bit_of.hpp"
#include "simulation/step/load_figures.hpp"

/// Chapter 2: the patent's idea applied to ourselves. Its rock is a table of single-tooth tests; here the
/// table is that of one tooth of our own, so that law and rock are the same, and what is left is what a sum
/// of isolated craters cannot know.
namespace tdbd::claims::isolated_craters_test {
namespace {

/// Means of a turn.
struct Turn {
  double weight = 0.0, torque = 0.0;  // N, N m
  double rate = 0.0;                  // m/s
  double removed = 0.0;               // m3 per revolution
};

/// The whole bit at 2 mm a revolution, its second turn.
Turn whole_bit(const simulation::Case& c) {
  const simulation::Simulation s = drilled(c);
  const auto loads = simulation::figures_of(c.bit, s.statistics.loads,
                                            c.time.step * static_cast<double>(s.state.steps_done));
  return {loads.wob.mean, loads.tob.mean, c.motion.rate_of_penetration, removed_in(s, 1)};
}

/// The patent's second way under this weight: means of five turns after three. Removed: the craters' sum.
Turn isolated_craters(const simulation::Case& c, const reference::ToothTable& table, double weight,
                      double step) {
  constexpr double revolutions = 8.0;
  const auto r = huang_cawthorne(reference::roller_bit_of(c.bit), table,
                                 {c.motion.rotary_speed, weight, step, revolutions, 3.0});
  EXPECT_LT(static_cast<double>(r.beyond_law),
            0.03 * static_cast<double>(
                       r.series.forces_in_contact.size()));  // steps of teeth beyond the table
  return {r.weight, r.torque, r.rate, r.volumes.isolated / revolutions};
}

nlohmann::ordered_json row(const std::string& model, double step, const Turn& t) {
  return {{"model", model},         {"step_ms", step},
          {"weight_N", t.weight},   {"rate_m_h", 3600.0 * t.rate},
          {"torque_N_m", t.torque}, {"removed_m3_per_revolution", t.removed}};
}

/// At 1 ms the prints lock into a pattern in which the bit drills slowest; shorter steps do not.
TEST(IsolatedCraters, of_our_own_tooth_fall_short_of_the_whole_bit) {
  const std::string claim = "chapter2/isolated-craters";
  const simulation::Case c =
      rock_case("compare-r", {"time.revolutions=2", "output.means_from='0.667 s'"});
  const Turn ours = whole_bit(c);
  const auto table = reference::read_tooth_table(TDBD_SOURCE_DIR "/cases/compare/single-tooth.csv",
                                                 "Huang and Cawthorne");
  nlohmann::ordered_json rows = {row("whole bit", 1.0, ours)};
  for (const double step : {1.0, 0.5, 0.25}) {
    const Turn theirs = isolated_craters(c, table, ours.weight, 1e-3 * step);
    rows.push_back(row("isolated craters", step, theirs));
    const std::string what = fmt::format(
        "three free cones at 90 rpm under the weight that the whole bit needs for 2 mm a "
        "revolution, steps of {} ms: ",
        step);
    record_near(claim, what + "rate over the whole bit's", theirs.rate / ours.rate, 1.0, 0.5);
    record_bound(claim, what + "torque over the whole bit's", theirs.torque / ours.torque, "1",
                 0.5);
    record_bound(claim, what + "sum of isolated craters over what the whole bit takes at that rate",
                 theirs.removed / (ours.removed * theirs.rate / ours.rate), "1", 0.8);
  }
  battery::record_table("isolated-craters", rows);
}

}  // namespace
}  // namespace tdbd::claims::isolated_craters_test
