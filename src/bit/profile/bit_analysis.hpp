#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Share of a mean diameter by which each cutter's tip overlaps the next one's when all are turned
/// into one plane, by growing radius, then height; nothing (not a number) for the last one and for
/// back-ups, which are left out. Tips farther apart than a diameter count negative.
std::vector<double> overlaps(const std::vector<Cutter>& cutters);

/// The unit law: every cutter pushes along its profile normal with its area, 1 Pa. The lateral
/// resultant over the sum of the forces' magnitudes, bit frame, z = 0; the rock pushes the bit the
/// other way. 0 is balanced, a length of 1 is a single cutter sideways.
Vec3 imbalance_vector(const std::vector<Cutter>& cutters, const std::vector<double>& areas);

/// Its magnitude.
double imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas);

/// Mean number of cutters that cut at a radius, weighted by area of the hole: how far the bit
/// survives the loss of one.
double mean_redundancy(const std::vector<int>& cutting);

}  // namespace tdbd::bit
