#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "core/observed_order.hpp"
#include "dynamics/drilling/energy_ledger.hpp"
#include "dynamics/drilling/stability.hpp"
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

TEST(Divergence, a_sound_run_has_none) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  EXPECT_EQ(divergence(s, d, d.work), "");
  for (int i = 0; i < 1000; ++i) {
    step(s, smooth_law, 1e-3, d);
    ASSERT_EQ(divergence(s, d, d.work), "");
  }
}

TEST(Divergence, names_the_force_that_is_no_number) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const LumpedLaw broken = [](const auto&, const DrillingState& x, const auto&, Wrench& w) {
    if (x.rotation.time > 0.0095) w.force_W.y() = std::numeric_limits<double>::quiet_NaN();
  };
  DrillingRun d = start(s, broken, coupled_start(s));
  int steps = 0;
  while (divergence(s, d, d.work).empty() && ++steps < 100) step(s, broken, 1e-3, d);
  EXPECT_EQ(steps, 10);
  EXPECT_EQ(divergence(s, d, d.work), "the force of cutting is not finite at t = 0.01 s");
}

/// A spring far beyond the stability limit: the run ends with the motion that ran away.
TEST(Divergence, names_the_motion_that_runs_away) {
  DrillingSystem s = plain_bit();
  s.string.stiffness.diagonal() = Vec3(0.0, 0.0, 5e9);
  s = make_drilling_system(s);
  DrillingState from = at_rest(s);
  from.momentum_W.z() = 1.0;
  DrillingRun d = start(s, nullptr, from);
  for (int i = 0; i < 100 && divergence(s, d, d.work).empty(); ++i) step(s, nullptr, 1e-3, d);
  EXPECT_EQ(divergence(s, d, d.work).find("the energy residual"), 0U) << divergence(s, d, d.work);
  d.ledger.start = 1e30;  // as if there had been so much to begin with
  while (divergence(s, d, d.work).empty()) step(s, nullptr, 1e-3, d);
  EXPECT_NE(divergence(s, d, d.work).find("the bit's speed along z"), std::string::npos);
}

/// A force law that feeds energy, which no ledger explains, is caught before speeds are absurd.
TEST(Divergence, sees_energy_from_nowhere) {
  const DrillingSystem s = make_drilling_system(plain_bit());
  DrillingRun d = start(s, nullptr, at_rest(s));
  d.state.momentum_W.z() += 500.0;
  step(s, nullptr, 1e-3, d);
  EXPECT_EQ(divergence(s, d, d.work),
            "the energy residual: 250 J with 0 J of energy in and out, mostly in the bit's "
            "translation at t = 0.001 s");
}

/// What came and went is the sum of all ways, of whatever sign.
TEST(Divergence, measures_the_residual_by_every_way_in_and_out) {
  const DrillingSystem s = make_drilling_system(plain_bit());
  DrillingRun d = start(s, nullptr, at_rest(s));
  const auto told = [&](double EnergyLedger::*a, double EnergyLedger::*b) {
    d.ledger = {};
    d.ledger.wall_loss = 1000.0;  // which nothing explains
    d.ledger.*a = 3.0;
    d.ledger.*b = 4.0;
    const std::string why = divergence(s, d, d.work);
    return why.substr(0, why.find(" of energy in"));
  };
  using L = EnergyLedger;
  constexpr std::array ways{&L::start, &L::top, &L::gravity, &L::cut_bit, &L::cut_rock};
  for (const auto a : ways)
    for (const auto b : ways) {
      if (a == b) continue;
      EXPECT_NE(told(a, b).find(" with 7 J"), std::string::npos) << told(a, b);
    }
}

/// The window on a lumped problem: 24 steps of h from its start, as a run has them.
Window lumped_window(const DrillingSystem& s, const LumpedLaw& law, const DrillingState& from,
                     double h) {
  return [=](int parts) {
    DrillingRun d = start(s, law, from);
    WindowResiduals w;
    for (int i = 0; i < 24; ++i) {
      for (int k = 0; k < parts; ++k) step(s, law, h / parts, d);
      w.at_instants.push_back(residual(s, d));
    }
    w.scale = d.ledger.start;
    return w;
  };
}

/// Smooth, everything acting at once: DrillingOrder measures 2.00 of the same problem over six
/// levels and 0.8 s.
TEST(ResidualOrder, is_two_where_all_is_smooth) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const ResidualOrder found =
      residual_order(1e-3, lumped_window(s, smooth_law, coupled_start(s), 1e-3));
  ASSERT_TRUE(found.order) << found.reason;
  EXPECT_NEAR(*found.order, 2.0, 2.9e-4);
  EXPECT_EQ(found.steps, (std::vector<double>{1e-3, 0.5e-3, 0.25e-3}));
  EXPECT_EQ(found.residuals.size(), 3u);
}

/// Residuals of a known power of the step, of both signs.
TEST(ResidualOrder, finds_the_power_of_residuals_that_have_one) {
  for (const double power : {1.0, 1.5, 4.0}) {
    const ResidualOrder found = residual_order(0.01, [power](int parts) {
      const double size = std::pow(0.01 / parts, power);
      return WindowResiduals{{size, -3.0 * size, 0.0, 2.0 * size}, 1.0};
    });
    ASSERT_TRUE(found.order);
    EXPECT_NEAR(*found.order, power, 1e-12);
    EXPECT_DOUBLE_EQ(found.residuals[1], std::sqrt(14.0 / 4.0) * std::pow(0.005, power));
  }
}

/// Constant forces on a symmetric bit: the step is exact, what is left is rounding and has none.
TEST(ResidualOrder, is_undefined_for_rounding) {
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s = make_drilling_system(s);
  DrillingState from = at_rest(s);
  from.momentum_W = Vec3(100.0, 20.0, 300.0);
  const ResidualOrder found = residual_order(1e-3, lumped_window(s, nullptr, from, 1e-3));
  EXPECT_FALSE(found.order);
  EXPECT_NE(found.reason.find("is at rounding"), std::string::npos) << found.reason;
}

TEST(ResidualOrder, of_a_window_without_instants_is_undefined) {
  const ResidualOrder found = residual_order(0.01, [](int /*parts*/) {
    return WindowResiduals{{}, 1.0};
  });
  EXPECT_FALSE(found.order);
  EXPECT_EQ(found.residuals[0], 0.0);
}

/// One level at rounding is enough, whichever it is; the first of several is named.
TEST(ResidualOrder, names_the_first_level_at_rounding) {
  const auto reason_where = [](std::vector<int> at_rounding) {
    const ResidualOrder found = residual_order(0.01, [&](int parts) {
      const bool is_rounding = std::ranges::count(at_rounding, parts) > 0;
      return WindowResiduals{{is_rounding ? 1e-30 : 1.0 / parts}, 8.0};
    });
    EXPECT_FALSE(found.order);
    EXPECT_EQ(found.residuals.size(), 3U);
    return found.reason;
  };
  EXPECT_EQ(
      reason_where({4}),
      "the residual is at rounding level: 1e-30 J with a step of 0.0025 s and 8 J of energy in and "
      "out");
  EXPECT_EQ(
      reason_where({2, 4}),
      "the residual is at rounding level: 1e-30 J with a step of 0.005 s and 8 J of energy in and "
      "out");
}

/// Rounding grows with the steps that were made: with the instants, and with the parts of each.
TEST(ResidualOrder, counts_the_rounding_of_every_part_of_a_step) {
  const auto found_at = [](double share, int level, std::size_t instants) {
    return residual_order(0.01, [=](int parts) {
      const double scale = 8.0;
      const double rounding =
          order_rounding_per_step * static_cast<double>(instants) * parts * scale;
      return WindowResiduals{
          std::vector<double>(instants, (parts == level ? share : 1.01) * rounding), scale};
    });
  };
  for (const std::size_t instants : {1U, 3U, 24U})
    for (const int level : {1, 2, 4}) {
      EXPECT_FALSE(found_at(0.99, level, instants).order) << level;
      EXPECT_TRUE(found_at(1.01, level, instants).order) << level;
    }
}

}  // namespace tdbd::dynamics::drilling_order_test
