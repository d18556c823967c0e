#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// A groove across its path: the face's edge, y sideways and height above its lowest point, m.
using GrooveProfile = std::vector<Eigen::Vector2d>;

/// How rock breaks out around a groove (rock (20), (21)).
struct GrooveBreakout {
  double angle = 0.0;        ///< rad, of cracks from the vertical
  double depth_share = 0.0;  ///< of the depth, from the top, in which cracks start
  double ahead_share = 0.0;  ///< of the depth, from the top, that chips off ahead
};

/// Cross-sections that leave the rock in one pass, m2.
struct GrooveAreas {
  double cut = 0.0;     ///< by the face: what is left when it comes
  double ahead = 0.0;   ///< chipped off ahead of it
  double beside = 0.0;  ///< broken out beside it
};

/// The slow twin of what breaks out around parallel grooves: the rock as heights in columns of
/// equal width, each pass one look at every column, and cracks from every column in which the
/// profile is in rock. The error falls with order 1 in the width.
class SpalledRock {
 public:
  /// Flat rock from -half_width to half_width (m), in so many columns.
  SpalledRock(double half_width, int columns);

  /// A pass with its lowest point at y = middle, this deep (m) below the flat rock. The profile is
  /// in the order of its y, and convex.
  GrooveAreas pass(const GrooveProfile& profile, double middle, double depth,
                   const GrooveBreakout& breakout);

 private:
  double width_;
  std::vector<double> y_, bottom_;  ///< per column: its middle; depth of the rock's surface, m
};

}  // namespace tdbd::reference
