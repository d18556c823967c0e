#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Exposure of every cutter above its neighbours, m, with all rims rotated into one half-plane
/// (turned_outline): along the cutter's profile normal, from the envelope of the other rims to its
/// tip. Positive: the cutter protrudes and cuts by itself. Negative: others protrude beyond its
/// tip. NaN if no other rim passes within its own diameter. Two equal cutters of radius R without
/// rakes, side by side at a distance d < R on a flat profile have R - sqrt(R^2 - d^2). Not in the
/// thesis.
std::vector<double> exposures(const std::vector<Cutter>& cutters);

}  // namespace tdbd::bit
