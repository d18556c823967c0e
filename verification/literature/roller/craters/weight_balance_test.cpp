#include "reference/literature/roller/craters/weight_balance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "core/error.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::reference::weight_balance_test {
namespace {

constexpr std::array heights{0.0, 0.4e-3, 0.7e-3, 1.1e-3, 1.6e-3, 2.0e-3};

/// The worked places are those of a search down to 1e-6 mm; forces are printed to 0.01 N.
constexpr double of_print = 1e-10, of_force = 6e-3;

struct SixTeeth {
  ToothLaw law = PowerTooth{5000.0 / std::pow(1e-3, 1.5), 1.5, 6e-3};
  double operator()(double z) const {
    double sum = 0.0;
    for (const double h : heights) sum += tooth_force(law, z - h);
    return sum;
  }
};

void expect_forces(double z, const std::array<double, 6>& expected, double tolerance) {
  const SixTeeth teeth;
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(tooth_force(teeth.law, z - heights[i]), expected[i], tolerance) << i;
}

BalanceOptions finely(BalanceSearch search) {
  BalanceOptions options;
  options.tolerance = 1e-13;
  options.search = search;
  return options;
}

TEST(WeightBalance, gives_the_worked_places_and_forces) {
  for (const BalanceSearch search : {BalanceSearch::bisection, BalanceSearch::itp}) {
    const auto light = weight_balance(SixTeeth{}, 0.0, 20e3, finely(search), "test");
    EXPECT_NEAR(light.z, 1.5071192e-3, of_print);
    expect_forces(light.z, {9251.06, 5824.54, 3625.57, 1298.83, 0, 0}, of_force);
    const auto heavy = weight_balance(SixTeeth{}, 0.0, 88964.0, finely(search), "test");
    EXPECT_NEAR(heavy.z, 2.9714520e-3, of_print);
    expect_forces(heavy.z, {25610.8, 20617.6, 17116.9, 12800.8, 8030.5, 4787.4}, 0.06);
  }
}

/// [0, 10] mm down to 1e-6 mm.
TEST(WeightBalance, takes_24_halvings_or_a_third_of_them) {
  const SixTeeth teeth;
  const WeightBracket in{0.0, 10e-3, teeth(0.0) - 20e3, teeth(10e-3) - 20e3};
  BalanceOptions options;
  options.search = BalanceSearch::bisection;
  EXPECT_EQ(narrow_balance(teeth, in, 20e3, options).narrowings, 24);
  options.search = BalanceSearch::itp;
  const WeightBalance found = narrow_balance(teeth, in, 20e3, options);
  EXPECT_LE(found.narrowings, 9);
  EXPECT_NEAR(found.z, 1.5071192e-3, 1e-9);
}

RC_GTEST_PROP(WeightBalance, more_weight_goes_deeper_and_the_weight_is_carried, ()) {
  const auto search = *rc::gen::element(BalanceSearch::bisection, BalanceSearch::itp);
  const double weight = *battery::number(0.1, 200.0) * 1e3,
               more = *battery::number(0.1, 50.0) * 1e3;
  const double start = *battery::number(-30.0, 30.0) * 1e-3;
  const auto a = weight_balance(SixTeeth{}, start, weight, finely(search), "test");
  const auto b = weight_balance(SixTeeth{}, start, weight + more, finely(search), "test");
  RC_ASSERT(b.z > a.z);
  RC_ASSERT(std::abs(SixTeeth{}(a.z) - weight) <= 1e-7 * weight);
}

/// A tooth that does not spring back gives a weight with jumps: no more than one step beyond halves.
RC_GTEST_PROP(WeightBalance, finds_jumps_in_as_many_steps_as_bisection_and_one, ()) {
  const double jump = *battery::number(0.0, 9.0) * 1e-3;
  const auto weight_at = [&](double z) { return z < jump ? 0.1 * z : 1e4 + z; };
  const WeightBracket in{-1e-3, 10e-3, weight_at(-1e-3) - 5e3, weight_at(10e-3) - 5e3};
  const WeightBalance found = narrow_balance(weight_at, in, 5e3, {});
  RC_ASSERT(std::abs(found.z - jump) <= 1e-9);
  RC_ASSERT(found.narrowings <= 24 + 1);
}

TEST(WeightBalance, counts_what_it_asked_for) {
  int asked = 0;
  const auto weight_at = [&](double z) {
    ++asked;
    return SixTeeth{}(z);
  };
  for (const double start : {-50e-3, 0.0, 1.5e-3, 2e-3, 300e-3}) {
    asked = 0;
    EXPECT_EQ(weight_balance(weight_at, start, 20e3, {}, "test").evaluations, asked) << start;
  }
}

TEST(WeightBalance, says_that_nothing_carries_the_weight) {
  const auto table = [](double z) { return std::min(1e4, std::max(0.0, z * 1e6)); };
  try {
    weight_balance(table, 0.0, 2e4, {}, "Ma, Zhou and Deng");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).substr(0, 62),
              "Ma, Zhou and Deng: no root for z: found 10000 N at the end of ");
  }
}

}  // namespace
}  // namespace tdbd::reference::weight_balance_test
