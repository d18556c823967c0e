#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Share of a mean diameter by which each cutter overlaps the next one when all are turned into one
/// half-plane, by growing radius, then height. NaN for the last one and for back-ups, which are
/// left out. Negative where tips are farther apart than a diameter.
std::vector<double> overlaps(const std::vector<Cutter>& cutters);

/// Imbalance by the unit law: every cutter pushes along its profile normal with its area, at 1 Pa.
/// The lateral resultant over the sum of the forces' magnitudes, bit frame, z = 0; the rock pushes
/// the bit the other way. 0 is balanced; a length of 1 is a single cutter that pushes sideways.
Vec3 imbalance_vector(const std::vector<Cutter>& cutters, const std::vector<double>& areas);

/// The magnitude of imbalance_vector.
double imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas);

/// Imbalance of the classical planar model (Warren and Sinor 1986): every cutter resists its way with
/// its area and is pushed back along its profile's normal with `normal_ratio` times that. The lateral
/// resultant of both over the weight; NaN without weight.
double planar_imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas,
                        double normal_ratio);

/// Mean number of cutters that cut at a radius, weighted by the area of the hole: how well the bit
/// survives the loss of one. `cutting`: as in Engagement.
double mean_redundancy(const std::vector<int>& cutting);

}  // namespace tdbd::bit
