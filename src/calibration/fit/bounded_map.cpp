#include "calibration/fit/bounded_map.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::calibration {
namespace {

/// A Range with an upper end also has a lower one: laws have no other coefficients.
bool has_both_ends(const Range& r) { return std::isfinite(r.lo) && std::isfinite(r.hi); }

}  // namespace

double value_of(const Range& r, double u) {
  if (has_both_ends(r)) return r.lo + (r.hi - r.lo) / (1.0 + std::exp(-u));
  return std::isfinite(r.lo) ? r.lo + std::exp(u) : u;
}

double free_variable(const Range& r, double value) {
  if (has_both_ends(r)) return std::log((value - r.lo) / (r.hi - value));
  return std::isfinite(r.lo) ? std::log(value - r.lo) : value;
}

double slope_at(const Range& r, double value) {
  if (has_both_ends(r)) return (value - r.lo) * (r.hi - value) / (r.hi - r.lo);
  return std::isfinite(r.lo) ? value - r.lo : 1.0;
}

bool is_at_bound(const Range& r, double value, double start) {
  if (has_both_ends(r))
    return std::min(value - r.lo, r.hi - value) < at_bound_share * (r.hi - r.lo);
  return std::isfinite(r.lo) && value - r.lo < at_bound_share * (start - r.lo);
}

}  // namespace tdbd::calibration
