#include "reference/literature/roller/wheel/winters.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "battery/generators.hpp"
#include "core/error.hpp"

namespace tdbd::reference::winters_test {
namespace {

constexpr double inch = 25.4e-3, klbf = 4448.2216152605, psi = 6894.757293168;  // m, N, Pa
constexpr double foot_per_hour = 0.3048 / 3600.0;                               // m/s
constexpr double rpm = std::numbers::pi / 30.0;                                 // rad/s
constexpr double printed = 1e-6;  // relative, of the worked numbers

/// Made up: chosen to give 20 ft/h, not the paper's.
const WintersConstants constants{.ductility = 0.0324, .offset = 0.96, .teeth = 19.0};
constexpr double strength = 16500.0 * psi;

WintersRun run(double weight_klbf) { return {weight_klbf * klbf, 8.5 * inch, 90.0 * rpm}; }

double between(double lo, double hi) { return lo + (hi - lo) * *battery::number(0.0, 1.0); }

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(Winters, the_worked_bit_has_the_worked_terms_and_rate) {
  const double w = winters_weight(run(20.0), strength);
  expect_near(w, 0.01677676, printed);
  const WintersTerms t = winters_terms(constants, w);
  expect_near(t.ductility, 115.114, 1e-5);
  expect_near(t.offset, 57.222, 1e-5);
  expect_near(t.sum(), 191.336, 1e-5);
  expect_near(winters_rate(constants, run(20.0), strength) / foot_per_hour, 19.9910, 3e-6);
}

TEST(Winters, rates_from_5_to_80_klbf_are_the_worked_ones) {
  constexpr std::array weights{5.0, 10.0, 20.0, 40.0, 80.0};
  constexpr std::array rates{1.8304, 6.4405, 19.9910, 50.0723, 94.4441};  // ft/h
  for (std::size_t i = 0; i < weights.size(); ++i)
    EXPECT_NEAR(winters_rate(constants, run(weights[i]), strength) / foot_per_hour, rates[i],
                0.6e-4);
}

TEST(Winters, the_local_exponent_falls_from_2_to_0) {
  const auto exponent = [](double klbf_) {
    return winters_exponent(constants, winters_weight(run(klbf_), strength));
  };
  EXPECT_NEAR(exponent(5.0), 1.8723, 0.6e-4);
  EXPECT_NEAR(exponent(20.0), 1.5023, 0.6e-4);
  EXPECT_NEAR(exponent(80.0), 0.7085, 0.6e-4);
  EXPECT_NEAR(winters_exponent(constants, 1e-9), 2.0, 1e-6);
  EXPECT_NEAR(winters_exponent({.offset = 0.96}, 0.02), 1.0, 1e-15);
  EXPECT_NEAR(winters_exponent(constants, 1e9), 0.0, 1e-6);
}

TEST(Winters, the_exponent_is_the_slope_of_the_logarithms) {
  for (const double weight : {5.0, 20.0, 80.0}) {
    constexpr double h = 1e-4;
    const double up = winters_rate(constants, run(weight * std::exp(h)), strength),
                 down = winters_rate(constants, run(weight * std::exp(-h)), strength);
    EXPECT_NEAR(std::log(up / down) / (2.0 * h),
                winters_exponent(constants, winters_weight(run(weight), strength)), 1e-8);
  }
}

TEST(Winters, the_inverse_of_the_worked_rate_is_16500_psi) {
  expect_near(winters_strength(constants, run(20.0), 19.9910 * foot_per_hour) / psi, 16500.0, 3e-6);
}

RC_GTEST_PROP(Winters, strength_from_rate_undoes_rate_from_strength, ()) {
  const WintersConstants k{.ductility = between(0.0, 0.1),
                           .offset = between(0.1, 2.0),
                           .teeth = between(0.0, 40.0),
                           .cleaning = between(0.0, 40.0)};
  const WintersRun r = run(between(2.0, 80.0));
  const double sigma = between(1e6, 4e8);
  const double back = winters_strength(k, r, winters_rate(k, r, sigma));
  RC_ASSERT(std::abs(back / sigma - 1.0) < 1e-9);
}

/// Other units of length, force and time leave R/(N D) as it is.
RC_GTEST_PROP(Winters, the_dimensionless_rate_does_not_depend_on_units, ()) {
  const double length = between(0.01, 100.0), force = between(0.01, 100.0),
               time = between(0.01, 100.0);
  const WintersRun a = run(between(2.0, 80.0));
  const WintersRun b{a.weight * force, a.diameter * length, a.rotary_speed / time};
  const double ratio = winters_rate(constants, b, strength * force / (length * length)) /
                       winters_rate(constants, a, strength);
  RC_ASSERT(std::abs(ratio * time / length - 1.0) < 1e-12);
}

/// The form without the diameter in the term of the offset, as it is often written down.
double rate_without_diameter(const WintersConstants& k, const WintersRun& r, double sigma) {
  const double D = r.diameter, N = r.rotary_speed / (2.0 * std::numbers::pi);
  return 1.0 / (sigma * D * D / (N * r.weight) * (k.ductility * sigma * D / r.weight + k.offset) +
                k.teeth / (N * D));
}

/// It is the same formula for a bit of 1 m, or 1 inch, and another for each other unit: at a twelfth of
/// the length unit its offset weighs twelve times as much.
TEST(Winters, without_the_diameter_the_rate_depends_on_the_unit_of_length) {
  const auto scaled = [](double length) {
    const WintersRun r{20.0 * klbf, 8.5 * inch * length, 90.0 * rpm};
    return rate_without_diameter(constants, r, strength / (length * length)) / length;
  };
  const WintersRun metre{20.0 * klbf, 1.0, 90.0 * rpm};
  expect_near(rate_without_diameter(constants, metre, strength),
              winters_rate(constants, metre, strength), 1e-14);
  EXPECT_GT(std::abs(scaled(12.0) / scaled(1.0) - 1.0), 0.2);
}

std::vector<WintersPoint> points(const std::vector<double>& weights_klbf) {
  std::vector<WintersPoint> all;
  for (const double w : weights_klbf)
    all.push_back({run(w), strength, winters_rate(constants, run(w), strength)});
  return all;
}

TEST(Winters, three_rates_give_the_constants_and_a_fourth_rate) {
  const WintersFit fit = fit_winters(points({10.0, 20.0, 40.0}));
  expect_near(fit.constants.ductility, constants.ductility, 1e-10);
  expect_near(fit.constants.offset, constants.offset, 1e-10);
  expect_near(fit.constants.teeth, constants.teeth, 1e-10);
  EXPECT_LT(fit.residual, 1e-12);
  expect_near(winters_rate(fit.constants, run(80.0), 1.5 * strength),
              winters_rate(constants, run(80.0), 1.5 * strength), 1e-10);
}

TEST(Winters, two_rates_do_where_teeth_and_cleaning_are_known) {
  const WintersFit fit = fit_winters(points({10.0, 40.0}), 19.0);
  expect_near(fit.constants.ductility, constants.ductility, 1e-11);
  expect_near(fit.constants.offset, constants.offset, 1e-11);
  EXPECT_EQ(fit.constants.teeth, 19.0);
}

/// What the fit is worth: 1 % on the middle one of three rates moves b by 20 % and the rate at twice
/// the largest weight by 4 %.
TEST(Winters, an_error_of_a_rate_grows_most_in_the_constants) {
  auto measured = points({10.0, 20.0, 40.0});
  measured[1].rate *= 1.01;
  const WintersFit fit = fit_winters(measured);
  const double next = winters_rate(fit.constants, run(80.0), strength) /
                      winters_rate(constants, run(80.0), strength);
  EXPECT_NEAR(next, 0.9607, 1e-4);
  EXPECT_NEAR(fit.constants.teeth / constants.teeth, 1.1994, 1e-4);
  EXPECT_NEAR(fit.condition, 21.6, 0.1);
}

TEST(Winters, more_rates_than_constants_are_fitted_by_least_squares) {
  auto measured = points({5.0, 10.0, 20.0, 40.0, 80.0});
  for (std::size_t i = 0; i < measured.size(); ++i) measured[i].rate *= i % 2 == 0 ? 1.01 : 0.99;
  const WintersFit fit = fit_winters(measured);
  EXPECT_GT(fit.residual, 1e-4);
  EXPECT_LT(fit.residual, 0.01);
}

/// Where the strength is known up to a factor, so are strengths in other rocks.
TEST(Winters, a_wrong_strength_in_the_fit_scales_the_strengths_that_it_finds) {
  auto measured = points({10.0, 20.0, 40.0});
  for (WintersPoint& p : measured) p.strength *= 2.0;
  const WintersFit fit = fit_winters(measured);
  expect_near(fit.constants.ductility, constants.ductility / 4.0, 1e-10);
  expect_near(fit.constants.offset, constants.offset / 2.0, 1e-10);
  const double rate = winters_rate(constants, run(30.0), 0.7 * strength);
  expect_near(winters_strength(fit.constants, run(30.0), rate), 1.4 * strength, 1e-9);
}

TEST(Winters, names_itself_and_what_it_needs) {
  const auto message = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message([] {
              fit_winters(points({10.0, 20.0}));
            }),
            "Winters, Warren and Onyia: found 2 rates, expected at least 3");
  EXPECT_EQ(message([] {
              fit_winters(points({10.0, 20.0, 20.0}));
            }),
            "Winters, Warren and Onyia: found rates at too few different weights over strength, "
            "expected 3 different W/(sigma D^2)");
  EXPECT_EQ(message([] { winters_rate(constants, {}, strength); }),
            "Winters, Warren and Onyia: found a weight of 0.000000, expected a positive one");
  EXPECT_EQ(message([] { winters_strength(constants, run(20.0), 1.0); }).substr(0, 56),
            "Winters, Warren and Onyia: found a rate of 1.000000 m/s,");
  EXPECT_EQ(message([] { winters_strength({.ductility = -1.0}, run(20.0), 1e-3); }),
            "Winters, Warren and Onyia: found constants with which no strength gives the rate");
}

}  // namespace
}  // namespace tdbd::reference::winters_test
