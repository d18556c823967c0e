#include <algorithm>
#include <cmath>

#include "bit/cone/cone_measures.hpp"
#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"

/// Thesis 1.2 and 1.3 on roller cone bits that drill by themselves, beside a drag bit.
namespace tdbd::claims::cone_drilling_test {

/// The second half of a short run, on a coarse mesh.
struct Half {
  std::vector<simulation::RunningVariance> ratio;  ///< of each cone, over the bit's speed
  double weight = 0.0, torque = 0.0;               ///< N, N m, means
};

Half second_half(const simulation::Case& c) {
  simulation::Simulation s = simulation::start(c);
  Half half;
  simulation::RunningVariance weight, torque;
  while (s.state.steps_done < c.time.steps) {
    const double before = s.state.place.turned;
    simulation::step(c, s);
    if (2 * s.state.steps_done <= c.time.steps) continue;
    half.ratio.resize(s.state.cones.size());
    for (std::size_t k = 0; k < half.ratio.size(); ++k)
      simulation::add(half.ratio[k], -s.state.cones[k].turned / (s.state.place.turned - before));
    simulation::add(weight, -s.work.loads.force_W.z());
    simulation::add(torque, -s.work.loads.torque_W.z());
  }
  half.weight = weight.mean;
  half.torque = torque.mean;
  return half;
}

const Half& bit_r() {
  static const Half half =
      second_half(rock_case("drill-bit-r", {"rock.edge_length='4 mm'", "rock.wall='50 mm'",
                                            "time.step='2 ms'", "time.duration='2 s'"}));
  return half;
}

TEST(ConeDrilling, cones_oscillate_as_they_turn) {
  for (std::size_t k = 0; k < bit_r().ratio.size(); ++k) {
    const double swing = simulation::relative_deviation(bit_r().ratio[k]);
    EXPECT_GE(swing, 0.02);
    battery::record({"chapter1/cones-oscillate",
                     fmt::format("bit R drills, cone {}: rms deviation of its speed over the bit's "
                                 "from the mean, over the mean",
                                 k + 1),
                     swing, "1", ">= 0.02", battery::Verdict::holds});
  }
}

/// Where a number lies between the least (0) and the greatest (1) of others.
double place_between(double x, const std::vector<double>& others) {
  const auto [lo, hi] = std::ranges::minmax(others);
  return (x - lo) / (hi - lo);
}

TEST(ConeDrilling, a_cones_speed_is_a_compromise_between_its_rows) {
  const bit::Bit b = example("bit-r");
  for (std::size_t k = 0; k < b.cones.size(); ++k) {
    std::vector<double> rows;
    for (const bit::ToothRow& row : b.cones[k].layout.rows)
      rows.push_back(bit::row_measures(b.cones[k], row).rolling_ratio);
    record_near("chapter1/pitches",
                fmt::format("bit R drills, cone {}: where its mean speed lies between the lowest "
                            "(0) and the highest (1) rolling ratio of its rows",
                            k + 1),
                place_between(bit_r().ratio[k].mean, rows), 0.5, 0.5);
  }
}

/// Torque over weight and gage radius; under laws of their own.
TEST(ConeDrilling, a_drag_bit_needs_more_torque_for_its_weight_than_a_roller_cone_bit) {
  const simulation::Case b = rock_case(
      "drill-bit-b", {"rock.edge_length='2.5 mm'", "time.step='2 ms'", "time.duration='2 s'"});
  const Half drag = second_half(b);
  const double roller_arm = bit_r().torque / bit_r().weight, drag_arm = drag.torque / drag.weight;
  record_bound("chapter1/torque",
               "bits R and B in the same rock: torque over weight of R over that of B",
               roller_arm / drag_arm, "1", 0.3);
}

}  // namespace tdbd::claims::cone_drilling_test
