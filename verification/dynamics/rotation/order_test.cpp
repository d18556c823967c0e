#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verification/battery/evidence.hpp"
#include "verification/battery/rotation_orders.hpp"

namespace tdbd::battery::order_test {

/// How far a slope may be from the order; the asymptotic range is that of observed_orders.
double tolerance_of(const RotationScheme& scheme) {
  if (scheme.order != 2) return scheme.order == 4 ? 0.1 : 0.2;
  if (scheme.name == "lie-mean x2") return 0.05;
  return scheme.name.starts_with("lie-midpoint") ? 0.008 : 0.024;
}

constexpr int least_levels = 5;

/// Free rotation about the middle axis by the split drift of order 8: errors fall faster than with order 8 in all
/// levels above rounding.
bool falls_faster(const RotationScheme& scheme, const std::string& name) {
  return scheme.name == "split order 8" && name == "free_asym_unstable";
}

void record_faster(const RotationScheme& scheme, const std::string& name, const VariableOrder& o) {
  EXPECT_GT(o.order, scheme.order) << o.variable;
  record({"ours/compositions",
          fmt::format("{}: observed order of {} on {}", scheme.name, o.variable, name), o.order,
          "1",
          fmt::format("{} +- {} is missed: errors fall faster in all levels above rounding",
                      scheme.order, tolerance_of(scheme)),
          Verdict::holds_with_limits});
}

/// Checks every variable of every golden case; returns the largest deviation.
double check_orders(const RotationScheme& scheme) {
  double worst = 0.0;
  for (const std::string& name : golden_names()) {
    for (const VariableOrder& o : observed_orders(scheme, read_golden_case(name))) {
      const std::string where = fmt::format("{}, {}, {}: order {:.3f} from {} levels", scheme.name,
                                            name, o.variable, o.order, o.levels);
      if (o.exact) continue;
      if (falls_faster(scheme, name)) {
        record_faster(scheme, name, o);
        continue;
      }
      EXPECT_GE(o.levels, least_levels) << where;
      EXPECT_NEAR(o.order, scheme.order, tolerance_of(scheme)) << where;
      worst = std::max(worst, std::abs(o.order - scheme.order));
    }
  }
  return worst;
}

void check_and_record(const RotationScheme& scheme, const std::string& claim) {
  const double worst = check_orders(scheme);
  const double limit = tolerance_of(scheme);
  record({claim,
          fmt::format("{}: largest deviation of an observed order from {}, {} golden cases, all "
                      "state variables",
                      scheme.name, scheme.order,
                      falls_faster(scheme, "free_asym_unstable") ? "eight" : "nine"),
          worst, "1", fmt::format("<= {}", limit),
          worst <= limit ? Verdict::holds : Verdict::refuted});
}

TEST(ObservedOrders, second_order_schemes_are_of_order_2_in_every_variable) {
  for (const RotationScheme& scheme : second_order_schemes())
    check_and_record(scheme, scheme.name.starts_with("lie-midpoint") ? "chapter5/second-order"
                                                                     : "ours/second-order");
}

TEST(ObservedOrders, suzuki_compositions_are_of_order_4_in_every_variable) {
  for (const RotationScheme& scheme : composed_schemes(4))
    check_and_record(scheme, "ours/compositions");
}

TEST(ObservedOrders, kahan_li_compositions_are_of_order_6_in_every_variable) {
  for (const RotationScheme& scheme : composed_schemes(6))
    check_and_record(scheme, "ours/compositions");
}

TEST(ObservedOrders, kahan_li_compositions_are_of_order_8_in_every_variable) {
  for (const RotationScheme& scheme : composed_schemes(8))
    check_and_record(scheme, "ours/compositions");
}

}  // namespace tdbd::battery::order_test
