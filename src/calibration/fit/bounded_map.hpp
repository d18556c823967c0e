#pragma once

#include "core/config/key.hpp"

namespace tdbd::calibration {

/// A coefficient within its range as a function of a free variable u, so that a search without
/// bounds stays inside, calibration (4): logistic between two ends, an exponential above one, u
/// itself where there is none.
double value_of(const Range& range, double u);
double free_variable(const Range& range, double value);

/// dvalue/du.
double slope_at(const Range& range, double value);

/// Whether a value lies on an end of its range, as far as the map lets it: within this share of the
/// range, or of the start's distance from the only end.
inline constexpr double at_bound_share = 1e-4;
bool is_at_bound(const Range& range, double value, double start);

}  // namespace tdbd::calibration
