#pragma once

#include <optional>
#include <vector>

#include "benchmarks/rotation/method.hpp"

namespace tdbd::bench {

/// One run of a case to its end: what it cost and how good it was.
struct WorkPoint {
  double setting = 0.0;  ///< step (s) or tolerance
  long steps = 0;
  long torque_evaluations = 0;
  double microseconds = 0.0;  ///< CPU time of the run alone, median of a few; building not counted
  EndErrors errors;
};

/// A method on a case, coarse to fine, and what it needs for each of the targets.
struct WorkPrecision {
  std::vector<WorkPoint> curve;
  std::vector<std::optional<WorkPoint>> at_target;  ///< empty: not reached within the bounds
};

/// Target errors of the attitude in a table, rad.
inline constexpr double attitude_targets[] = {1e-3, 1e-6, 1e-9};

/// Halves the setting bit by bit until the error is at rounding or a run takes too long. A target
/// is reached by the coarsest run from which on all finer ones reach it too, so that a lucky
/// crossing of zero does not count.
WorkPrecision measure_work(const RotationCase& c, const Method& method);

}  // namespace tdbd::bench
