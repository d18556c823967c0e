#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "reference/literature/roller/huang_cawthorne.hpp"
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

TEST(IsolatedCraters, of_our_own_tooth_fall_short_of_the_whole_bit) {
  const std::string claim = "chapter2/isolated-craters";
  const simulation::Case c =
      rock_case("compare-r", {"time.revolutions=2", "output.means_from='0.667 s'"});
  const Turn ours = whole_bit(c);
  const auto table = reference::read_tooth_table(TDBD_SOURCE_DIR "/cases/compare/single-tooth.csv",
                                                 "Huang and Cawthorne");
  const double revolutions = 8.0;
  const auto r = huang_cawthorne(reference::roller_bit_of(c.bit), table,
                                 {c.motion.rotary_speed, ours.weight, 1e-3, revolutions, 3.0});
  const double taken = ours.removed * r.rate / ours.rate;
  battery::record_table("isolated-craters",
                        {{{"model", "whole bit"},
                          {"weight_N", ours.weight},
                          {"rate_m_h", 3600.0 * ours.rate},
                          {"torque_N_m", ours.torque},
                          {"removed_m3_per_revolution", ours.removed}},
                         {{"model", "isolated craters"},
                          {"weight_N", r.weight},
                          {"rate_m_h", 3600.0 * r.rate},
                          {"torque_N_m", r.torque},
                          {"removed_m3_per_revolution", r.volumes.isolated / revolutions}}});
  const std::string what =
      "three free cones at 90 rpm under the weight that the whole bit needs for 2 mm a "
      "revolution: ";
  record_near(claim, what + "rate over the whole bit's", r.rate / ours.rate, 1.0, 0.5);
  record_bound(claim, what + "torque over the whole bit's", r.torque / ours.torque, "1", 0.5);
  record_bound(claim, what + "sum of isolated craters over what the whole bit takes at that rate",
               r.volumes.isolated / revolutions / taken, "1", 0.8);
  EXPECT_EQ(r.beyond_law, 0);
}

}  // namespace
}  // namespace tdbd::claims::isolated_craters_test
