#pragma once

#include <string_view>

namespace tdbd::forces {

inline constexpr double MPa = 1e6;  ///< Pa

/// How a number is known.
enum class Evidence {
  seen,     ///< read in a source
  derived,  ///< computed from numbers that were read
  recall,   ///< from memory, no source at hand
  assumed,  ///< assumed by TDBD, for lack of any source
};

/// "seen", "derived", "recall", "assumed".
constexpr std::string_view evidence_name(Evidence e) {
  return e == Evidence::seen      ? "seen"
         : e == Evidence::derived ? "derived"
         : e == Evidence::recall  ? "recall"
                                  : "assumed";
}

/// A number (SI) and how it is known.
struct Quoted {
  double value = 0.0;
  Evidence evidence = Evidence::assumed;
};

}  // namespace tdbd::forces
