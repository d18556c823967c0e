#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// Cross-section of a groove: the face's edge as y and height above its lowest point, m.
using GrooveProfile = std::vector<Eigen::Vector2d>;

/// How rock breaks out around a groove (rock (20), (21)).
struct GrooveBreakout {
  double angle = 0.0;        ///< rad, of cracks from the vertical
  double depth_share = 0.0;  ///< share of the depth, from the top, in which cracks start
  double ahead_share = 0.0;  ///< share of the depth, from the top, that chips off ahead
};

/// Cross-sections that are removed in one pass, m2.
struct GrooveAreas {
  double cut = 0.0;     ///< by the face, from the rock that is left when it arrives
  double ahead = 0.0;   ///< chipped off ahead of it
  double beside = 0.0;  ///< broken out beside it
};

/// Slow twin of break-out around parallel grooves. The rock is a height in each of many columns of
/// equal width. Each pass visits every column once, and cracks start at every column in which the
/// profile is in rock. The error is of order 1 in the width.
class SpalledRock {
 public:
  /// Flat rock from -half_width to half_width (m), with this number of columns.
  SpalledRock(double half_width, int columns);

  /// Makes a pass with its lowest point at y = middle, at this depth (m) below the flat rock. The
  /// profile must be sorted by y and convex.
  GrooveAreas pass(const GrooveProfile& profile, double middle, double depth,
                   const GrooveBreakout& breakout);

 private:
  double width_;
  std::vector<double> y_, bottom_;  ///< per column: its middle; depth of the rock's surface, m
};

}  // namespace tdbd::reference
