#pragma once

#include <optional>
#include <vector>

#include "benchmarks/rotation/method.hpp"

namespace tdbd::bench {

/// One run of a case to its end: its run time and its errors.
struct WorkPoint {
  double setting = 0.0;  ///< step (s) or tolerance
  long steps = 0;
  long torque_evaluations = 0;
  double microseconds = 0.0;  ///< CPU time of the run alone, median of a few runs
  EndErrors errors;
};

/// A method on a case, from coarse to fine, and the run for each target.
struct WorkPrecision {
  std::vector<WorkPoint> curve;
  std::vector<std::optional<WorkPoint>> at_target;  ///< empty: not reached within the bounds
};

/// Target errors of the attitude in a table, rad.
inline constexpr double attitude_targets[] = {1e-3, 1e-6, 1e-9};

/// Refines the setting step by step until the error is at rounding level or a run takes too long.
/// The run for a target is the coarsest one from which on all finer runs reach it, too, so that an
/// accidental zero of the error does not count.
WorkPrecision measure_work(const RotationCase& c, const Method& method);

}  // namespace tdbd::bench
