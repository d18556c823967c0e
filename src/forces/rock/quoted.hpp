#pragma once

#include <string_view>

namespace tdbd::forces {

/// How well a number is known.
enum class Evidence {
  seen,     ///< read in a source
  derived,  ///< computed from numbers that were read
  recall,   ///< from memory, no source at hand
  assumed,  ///< ours, for want of any
};

/// "seen", "derived", "recall", "assumed".
constexpr std::string_view evidence_name(Evidence e) {
  return e == Evidence::seen      ? "seen"
         : e == Evidence::derived ? "derived"
         : e == Evidence::recall  ? "recall"
                                  : "assumed";
}

/// A number with how it is known; in SI.
struct Quoted {
  double value = 0.0;
  Evidence evidence = Evidence::assumed;
};

}  // namespace tdbd::forces
