#pragma once

#include <vector>

#include "reference/literature/surface/spokes.hpp"

namespace tdbd::reference {

/// What evenly spaced samples of the bottom along a circle show. K samples cannot tell a pattern of
/// n lobes from one of |n - mK|: harmonics beyond K/2 appear as others.
struct BottomHarmonics {
  std::vector<double> amplitude;  ///< m, of cos(n a - phase), n = 0 (the mean's size) to K/2
  double peak_to_peak = 0.0;      ///< m
};

/// Of depths (m) at azimuths 2 pi k/K; K >= 2.
BottomHarmonics bottom_harmonics(const std::vector<double>& depth);

/// The largest harmonics but the mean, largest first; equal ones by number.
std::vector<int> strongest(const BottomHarmonics& harmonics, int count);

/// Depth of every spoke at a radius (m), linear between nodes.
std::vector<double> depth_on_circle(const Spokes& rock, double r);

}  // namespace tdbd::reference
