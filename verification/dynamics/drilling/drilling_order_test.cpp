#include <gtest/gtest.h>

#include <array>

#include "core/observed_order.hpp"
#include "reference/dynamics/lumped_drilling.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::drilling_order_test {

constexpr double end = 0.8;  ///< s

constexpr std::array variables = {"centre",           "momentum",      "attitude",
                                  "angular momentum", "cone angles",   "cone momenta",
                                  "rock place",       "rock momentum", "residual of energy"};
using Errors = std::array<double, variables.size()>;

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

Errors errors(const DrillingSystem& s, const DrillingRun& d, const reference::LumpedState& exact) {
  const DrillingState& x = d.state;
  const reference::GyrostatState& bit = exact.bit;
  return {(x.c_W - exact.c_W).norm(),
          (x.momentum_W - s.mass * exact.v_W).norm(),
          (x.rotation.q_WB.toRotationMatrix() - bit.R_WB).norm(),
          (x.rotation.momentum_W - bit.R_WB * bit.body_momentum_B).norm(),
          distance(x.rotation.cone_angles, bit.cone_angles),
          distance(x.rotation.cone_momenta, bit.cone_momenta),
          std::abs(x.rock_z - exact.rock_z),
          std::abs(x.rock_momentum - s.rock.mass * exact.rock_v),
          std::abs(residual(s, d))};
}

/// Largest errors at a half and at the whole of the time, where neither is small by chance alone. The
/// residual, which changes sign, at 200 instants.
Errors largest_errors(const DrillingSystem& s, const std::array<reference::LumpedState, 2>& exact,
                      LawMomenta momenta, long n) {
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  Errors largest{};
  for (const reference::LumpedState& there : exact) {
    for (long i = 0; i < n / 2; ++i) {
      step(s, smooth_law, end / static_cast<double>(n), d, momenta);
      if (i % (n / 200) == 0) largest.back() = std::max(largest.back(), std::abs(residual(s, d)));
    }
    const Errors now = errors(s, d, there);
    for (std::size_t v = 0; v < now.size(); ++v) largest[v] = std::max(largest[v], now[v]);
  }
  return largest;
}

/// Orders of all variables over six levels, by least squares.
Errors orders(const DrillingSystem& s, LawMomenta momenta, long coarsest) {
  const reference::LumpedState from = reference::lumped_state(s, coupled_start(s));
  const auto half = reference::lumped_drilling(s, smooth_law, from, 0.5 * end).state;
  const auto whole = reference::lumped_drilling(s, smooth_law, half, end).state;
  std::vector<double> steps;
  std::array<std::vector<double>, variables.size()> found;
  for (long n = coarsest; n <= 32 * coarsest; n *= 2) {
    const Errors e = largest_errors(s, {half, whole}, momenta, n);
    steps.push_back(end / static_cast<double>(n));
    for (std::size_t v = 0; v < e.size(); ++v) found[v].push_back(e[v]);
  }
  Errors result{};
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = least_squares_order(steps, found[v]);
  return result;
}

TEST(DrillingOrder, is_two_in_every_variable_under_a_law_of_velocity) {
  double worst = 0.0;
  for (const AxialMode axial : {AxialMode::rate, AxialMode::load})
    for (const DamperEnd damper : {DamperEnd::space, DamperEnd::top}) {
      const Errors found = orders(coupled_bit(axial, damper), LawMomenta::predicted, 200);
      for (std::size_t v = 0; v < found.size(); ++v) {
        EXPECT_NEAR(found[v], 2.0, 0.06) << variables[v];
        worst = std::max(worst, std::abs(found[v] - 2.0));
      }
    }
  battery::record({"ours/drilling-order",
                   "largest deviation of an order from 2, nine variables, four kinds of string",
                   worst, "1", "<= 0.06",
                   worst <= 0.06 ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// What the last wrench's prediction is for: without it the law's velocity is a half step old.
TEST(DrillingOrder, is_one_where_the_law_sees_the_momenta_after_the_drift) {
  const Errors found =
      orders(coupled_bit(AxialMode::rate, DamperEnd::space), LawMomenta::drifted, 3200);
  for (std::size_t v = 0; v + 1 < found.size(); ++v)
    EXPECT_NEAR(found[v], 1.0, 0.1) << variables[v];
}

}  // namespace tdbd::dynamics::drilling_order_test
