#include "dynamics/drilling/residual_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/observed_order.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::residual_order_test {

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
TEST(ResidualOrder, is_not_told_of_rounding) {
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s = make_drilling_system(s);
  DrillingState from = at_rest(s);
  from.momentum_W = Vec3(100.0, 20.0, 300.0);
  const ResidualOrder found = residual_order(1e-3, lumped_window(s, nullptr, from, 1e-3));
  EXPECT_FALSE(found.order);
  EXPECT_NE(found.reason.find("is at rounding"), std::string::npos) << found.reason;
}

TEST(ResidualOrder, of_a_window_without_instants_is_not_told) {
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
      "the residual is at rounding: 1e-30 J with a step of 0.0025 s, where 8 J came and went");
  EXPECT_EQ(reason_where({2, 4}),
            "the residual is at rounding: 1e-30 J with a step of 0.005 s, where 8 J came and went");
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

}  // namespace tdbd::dynamics::residual_order_test
