#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verification/battery/evidence.hpp"
#include "verification/battery/rotation_checks.hpp"

namespace tdbd::battery::energy_test {

/// A body that can be built, three unequal cones, gravity: T = 5e4 s.
constexpr double step = 0.04;  ///< s
constexpr long steps = 1'250'000;
constexpr double no_trend = 1.7e-6;  ///< of the energy, last fifth against first

double trend(const EnergyRecord& e) { return e.mean_of_fifth.back() - e.mean_of_fifth.front(); }

EnergyRecord long_run(const RotationScheme& scheme) {
  return energy_record(scheme, read_golden_case("heavy_gyro_phys"), step, steps);
}

/// One drift a step, and two as in the thesis's form.
TEST(LongEnergy, the_thesis_drift_changes_the_energy_for_ever_with_spinning_cones_under_gravity) {
  for (const int drifts : {1, 2}) {
    const RotationScheme scheme =
        production("lie-midpoint", {dynamics::Drift::lie_midpoint, drifts, 2});
    const EnergyRecord e = long_run(scheme);
    const double last = e.mean_of_fifth.back();
    EXPECT_GT(std::abs(trend(e)), 2000.0 * no_trend) << drifts;
    if (drifts == 1) {
      EXPECT_GE(last, 0.08);
      EXPECT_LE(last, 0.15);
    }
    record({"chapter5/energy",
            fmt::format(
                "lie-midpoint, drifts a step {}: change of the energy, mean of the last fifth of T "
                "= 5e4 s, heavy_gyro_phys, h = 0.04 s",
                drifts),
            last, "1", fmt::format("<= {}", no_trend),
            std::abs(last) <= no_trend ? Verdict::holds : Verdict::refuted});
  }
}

TEST(LongEnergy, symplectic_drifts_show_no_trend_over_a_million_steps) {
  for (const RotationScheme& scheme : composed_schemes(2)) {
    if (scheme.name == "lie-midpoint") continue;
    const EnergyRecord e = long_run(scheme);
    EXPECT_LE(std::abs(trend(e)), no_trend) << scheme.name;
    EXPECT_LE(e.largest, 1.3 * e.largest_of_first_hundredth) << scheme.name;
    record({"ours/energy",
            scheme.name + ": energy trend, last fifth against first of T = 5e4 s, heavy_gyro_phys",
            std::abs(trend(e)), "1", fmt::format("<= {}", no_trend),
            std::abs(trend(e)) <= no_trend ? Verdict::holds : Verdict::refuted});
  }
}

TEST(LongEnergy, of_the_slow_top_is_bounded_for_all_drifts) {
  constexpr double top_step = 0.02, no_trend_of_the_top = 1.9e-7;
  const GoldenCase c = read_golden_case("slow_top");
  for (const RotationScheme& scheme : composed_schemes(2)) {
    const EnergyRecord e = energy_record(scheme, c, top_step, 1'000'000);
    EXPECT_LE(e.largest, 1.05 * e.largest_of_first_hundredth) << scheme.name;
    EXPECT_LE(std::abs(trend(e)), no_trend_of_the_top) << scheme.name;
    record({scheme.name == "lie-midpoint" ? "chapter5/energy" : "ours/energy",
            scheme.name + ": largest energy error over 1e6 steps, slow_top, h = 0.02 s", e.largest,
            "1",
            fmt::format("<= 1.05 times that of the first 1e4 steps ({:.3g})",
                        e.largest_of_first_hundredth),
            e.largest <= 1.05 * e.largest_of_first_hundredth ? Verdict::holds : Verdict::refuted});
  }
}

}  // namespace tdbd::battery::energy_test
