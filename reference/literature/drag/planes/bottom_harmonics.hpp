#pragma once

#include <vector>

#include "reference/literature/surface/spokes.hpp"

namespace tdbd::reference {

/// Harmonics of equally spaced samples of the bottom along a circle. K samples cannot distinguish a
/// pattern of n lobes from one of |n - mK|: harmonics beyond K/2 are aliased.
struct BottomHarmonics {
  std::vector<double> amplitude;  ///< m, of cos(n a - phase), n = 0 (magnitude of the mean) to K/2
  double peak_to_peak = 0.0;      ///< m
};

/// Computes the harmonics of depths (m) at azimuths 2 pi k/K; K >= 2.
BottomHarmonics bottom_harmonics(const std::vector<double>& depth);

/// The numbers of the largest harmonics except the mean, in descending order; equal ones by number.
std::vector<int> strongest(const BottomHarmonics& harmonics, int count);

/// Depth of every spoke at a radius (m), linear between nodes.
std::vector<double> depth_on_circle(const Spokes& rock, double r);

}  // namespace tdbd::reference
