#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Overlap of each cutter with the next one, over their mean diameter, when all are rotated into
/// one half-plane, in ascending order of radius, then height. Negative if tips are farther apart
/// than a diameter. NaN for the last cutter and for back-ups, which are omitted.
std::vector<double> overlaps(const std::vector<Cutter>& cutters);

/// Imbalance under the unit law: every cutter pushes along its profile normal with its area, at 1
/// Pa. Returns the lateral resultant over the sum of the forces' magnitudes, bit frame, z = 0; the
/// rock pushes the bit in the opposite direction. 0: balanced; length 1: a single cutter that
/// pushes sideways.
Vec3 imbalance_vector(const std::vector<Cutter>& cutters, const std::vector<double>& areas);

/// The magnitude of imbalance_vector.
double imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas);

/// Imbalance of the classical planar model (Warren and Sinor 1986): the force on every cutter is
/// its area against its motion and `normal_ratio` times that along its profile's normal. Returns
/// the lateral resultant of both over the weight; NaN without weight.
double planar_imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas,
                        double normal_ratio);

/// Mean number of cutters that cut at a radius, weighted by the area of the hole. Measures how well
/// the bit tolerates the loss of a cutter. `cutting`: as in Engagement.
double mean_redundancy(const std::vector<int>& cutting);

}  // namespace tdbd::bit
