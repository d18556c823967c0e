#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Exposure of every cutter above its neighbours, m, when all rims are turned into one half-plane
/// (turned_outline): along the cutter's profile normal, from the envelope of the other rims to its
/// tip. Positive: it stands out and cuts by itself; negative: others stand out beyond its tip; NaN
/// where no other rim passes within its own diameter. Two equal cutters of radius R without rakes,
/// side by side at a distance d < R on a flat profile: R - sqrt(R^2 - d^2). Ours.
std::vector<double> exposures(const std::vector<Cutter>& cutters);

}  // namespace tdbd::bit
