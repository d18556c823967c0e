#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "core/tolerance.hpp"
#include "reference/bit/radial_plane_engagement.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::steady_drilling_test {

constexpr double micron = 1e-6;

Simulation drilled(const Case& c) {
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) step(c, s);
  return s;
}

double advance(const Case& c) {
  return c.motion.rate_of_penetration * 2.0 * std::numbers::pi / c.motion.rotary_speed;
}

/// Bit B from its first whole revolution on, on the mesh for which limits are given.
class SteadyBitB : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    case_ = new Case(read_case(TDBD_SOURCE_DIR "/cases/bit-b-steady.toml", {}));
    simulation_ = new Simulation(drilled(*case_));
  }
  static void TearDownTestSuite() {
    delete simulation_;
    delete case_;
  }
  static const std::vector<double>& revolution(std::size_t k) {
    return simulation_->state.ledger.removed_by_revolution[k];
  }
  static std::vector<double> by_cutter(const std::vector<double>& by_part) {
    std::vector<double> sums(case_->bit.cutters.size(), 0.0);
    for (std::size_t i = 0; i < by_part.size(); ++i)
      if (const int cutter = case_->bit.parts[i].cutter; cutter >= 0)
        sums[static_cast<std::size_t>(cutter)] += by_part[i];
    return sums;
  }

  static inline Case* case_ = nullptr;
  static inline Simulation* simulation_ = nullptr;
};

TEST_F(SteadyBitB, removes_the_gage_circle_times_the_advance) {
  constexpr double within = 0.002;  // of the whole; required: 0.003
  const double r = case_->bit.gage_radius;
  const double expected = std::numbers::pi * r * r * advance(*case_);
  for (std::size_t k = 1; k < 3; ++k) {
    const double removed = std::accumulate(revolution(k).begin(), revolution(k).end(), 0.0);
    fmt::print("revolution {}: {:+.4f} % of pi R^2 d\n", k + 1, 100 * (removed / expected - 1));
    EXPECT_NEAR(removed, expected, within * expected);
  }
}

TEST_F(SteadyBitB, cuts_the_areas_of_the_radial_plane) {
  constexpr double median_within = 3.4e-3, worst_within = 0.03, counts_from = 0.01;
  const auto expected =
      reference::radial_plane_engagement(case_->bit, advance(*case_), 20.0 * micron);
  const std::vector<double> removed = by_cutter(revolution(2));
  std::vector<double> errors;
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const double volume = expected.volume_per_revolution[i];
    if (volume < counts_from * expected.total) continue;
    errors.push_back(std::abs(removed[i] / volume - 1.0));
    fmt::print("cutter {:2}: {:8.3f} mm3, {:+.3f} %\n", case_->bit.cutters[i].id, 1e9 * volume,
               100 * (removed[i] / volume - 1.0));
  }
  std::ranges::sort(errors);
  ASSERT_GT(errors.size(), 10U);
  fmt::print("median {:.3f} %, worst {:.3f} %\n", 100 * errors[errors.size() / 2],
             100 * errors.back());
  EXPECT_LT(errors[errors.size() / 2], median_within);
  EXPECT_LT(errors.back(), worst_within);
}

TEST_F(SteadyBitB, closes_the_ledger) { EXPECT_LE(ledger_defect(*simulation_), tolerance::ledger); }

TEST_F(SteadyBitB, leaves_a_bottom_without_self_intersections) {
  EXPECT_EQ(reference::self_intersecting_pairs(mesh::compact(simulation_->state.rock.surface)), 0U);
}

}  // namespace tdbd::simulation::steady_drilling_test
