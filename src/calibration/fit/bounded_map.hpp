#pragma once

#include "core/config/key.hpp"

namespace tdbd::calibration {

/// Maps a free variable u to a coefficient within its range, so that an unbounded search stays
/// inside, calibration (4): logistic between two ends, exponential above one end, identity without
/// ends.
double value_of(const Range& range, double u);
double free_variable(const Range& range, double value);

/// dvalue/du.
double slope_at(const Range& range, double value);

/// Whether a value is at an end of its range as far as the map permits: within this share of the
/// range, or for a single end, of its distance from the start.
inline constexpr double at_bound_share = 1e-4;
bool is_at_bound(const Range& range, double value, double start);

}  // namespace tdbd::calibration
