#pragma once

#include <vector>

#include "verification/battery/rotation_checks.hpp"

namespace tdbd::battery {

/// Order of one variable's error: the larger of those at half and at all of the golden time.
struct VariableOrder {
  const char* variable = "";
  double order = 0.0;
  int levels = 0;      ///< errors that the slope rests on
  bool exact = false;  ///< all errors are rounding: nothing to fit
};

/// Slopes by least squares through the finest six errors above rounding, over steps that shrink by
/// the fourth root of 2. Steps at which a drift's own iteration does not converge are left out.
///
/// Schemes of order 2 run in double, against the golden states. Higher orders reach the rounding of
/// doubles before six errors are asymptotic: they run in extended precision (64 bits of mantissa),
/// against an eighth-order composition, which golden_test compares with the golden states.
std::vector<VariableOrder> observed_orders(const RotationScheme& scheme, const GoldenCase& c);

}  // namespace tdbd::battery
