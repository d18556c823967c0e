#include "reference/literature/drag/spokes/wall_ledger.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/observed_order.hpp"
#include "reference/literature/drag/spokes/rk4.hpp"
#include "verification/battery/evidence.hpp"

namespace tdbd::reference::wall_ledger_test {
namespace {

/// One step of an oscillator of frequency 1.
std::array<double, 2> oscillator_step(double wh, std::array<double, 2> y) {
  rk4_step(
      [](double, const auto& x, auto& rates) {
        rates[0] = x[1];
        rates[1] = -x[0];
      },
      0.0, wh, y);
  return y;
}

/// Worked numbers, as printed.
TEST(RungeKutta, keeps_a_share_of_an_oscillators_energy_in_each_step) {
  const std::pair<double, double> printed[] = {{0.1, 0.99999998613},
                                               {0.5, 0.99978976780},
                                               {1.0, 0.98784722222},
                                               {std::sqrt(2.0), 0.91666667}};
  for (const auto& [wh, factor] : printed) {
    const auto [q, v] = oscillator_step(wh, {0.6, 0.8});
    EXPECT_NEAR(q * q + v * v, factor, 1e-8);
    EXPECT_NEAR(q * q + v * v, runge_kutta_energy_factor(wh), 1e-15);
  }
}

TEST(RungeKutta, is_stable_for_steps_below_the_root_of_eight) {
  EXPECT_LT(runge_kutta_energy_factor(2.828), 1.0);
  EXPECT_GT(runge_kutta_energy_factor(2.829), 1.0);
  EXPECT_NEAR(runge_kutta_energy_factor(std::sqrt(8.0)), 1.0, 1e-12);
}

TEST(RungeKutta, is_of_fourth_order) {
  std::vector<double> steps, errors;
  for (int n = 10; n <= 160; n *= 2) {
    const double h = 1.0 / n;
    std::array<double, 2> y{1.0, 0.0};
    for (int i = 0; i < n; ++i) y = oscillator_step(h, y);
    steps.push_back(h);
    errors.push_back(std::hypot(y[0] - std::cos(1.0), y[1] + std::sin(1.0)));
  }
  EXPECT_NEAR(least_squares_order(steps, errors), 4.0, 0.02);
}

void record_kept(const std::string& what, double kept, const std::string& limit, bool holds) {
  battery::record({"chapter2/runge-kutta-loses-energy", what, kept, "1", limit,
                   holds ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// 1e9 N/m, 500 kg, 1 ms: wh = sqrt 2.
TEST(WallLedger, loses_a_twelfth_of_the_energy_in_every_step_on_a_stiff_wall) {
  const WallLedger ledger = wall_ledger({.duration = 0.1});
  for (std::size_t i = 1; i < ledger.time.size(); ++i)
    EXPECT_NEAR(ledger.runge_kutta[i] / ledger.runge_kutta[i - 1], 0.91666667, 1e-8);
  const auto [least, most] = std::ranges::minmax(ledger.symplectic);
  EXPECT_GT(least, 0.49 * ledger.symplectic.front());  // 1 - (wh)^2/4 = 1/2
  EXPECT_LT(most, 2.01 * ledger.symplectic.front());
  const double kept = ledger.runge_kutta[1] / ledger.runge_kutta[0];
  record_kept("energy kept in a step of 1 ms by a bit of 500 kg on a wall of 1e9 N/m, Runge-Kutta",
              kept, "0.91666667 +- 1e-8", std::abs(kept - 0.91666667) <= 1e-8);
}

/// Both energies over time, ten rows a second.
void record_energies(const WallLedger& ledger) {
  nlohmann::ordered_json rows;
  for (std::size_t i = 0; i < ledger.time.size(); i += 100)
    rows.push_back({{"t_s", ledger.time[i]},
                    {"runge_kutta_J", ledger.runge_kutta[i]},
                    {"symplectic_J", ledger.symplectic[i]}});
  battery::record_table("wall-ledger", rows);
}

/// A minute of bouncing on the spring in a hole of 1.5 mm clearance, 1 ms steps. Runge-Kutta's loss ends when the
/// bounces fall into a rhythm of whole steps; at which energy, rounding decides.
TEST(WallLedger, of_a_bouncing_bit_is_halved_by_runge_kutta_and_kept_by_the_symplectic_method) {
  WallLedgerCase bouncing{.spring = 2e5, .wall = 1e8, .clearance = 1.5e-3, .duration = 60.0};
  bouncing.v[1] = 0.03;
  const WallLedger ledger = wall_ledger(bouncing);
  const double start = ledger.symplectic.front();
  const auto [least, most] = std::ranges::minmax(ledger.symplectic);
  EXPECT_LT(ledger.runge_kutta.back(), 0.55 * start);  // seen: 0.483
  EXPECT_GT(least, 0.9 * start);                       // seen: 0.957
  EXPECT_LT(most, 1.02 * start);                       // seen: 1.006
  const std::string of =
      "energy of a bit that bounces 60 s in a round hole, over its first, steps of 1 ms, ";
  const double kept = ledger.runge_kutta.back() / start;
  record_kept(of + "Runge-Kutta, at the end", kept, "< 0.55", kept < 0.55);
  record_kept(of + "velocity Verlet, the least of all steps", least / start, "> 0.9",
              least / start > 0.9);
  record_energies(ledger);
}

}  // namespace
}  // namespace tdbd::reference::wall_ledger_test
