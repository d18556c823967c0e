#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// A point of the half-plane through the bit's axis, m; z down.
struct ProfilePoint {
  double r = 0.0;
  double z = 0.0;
};

/// Exposure profile (thesis: fig. 3.8): what the cutting parts touch when every one is turned about
/// the bit's axis into one half-plane, from the axis (r = 0) to the gage, points about `spacing`
/// (m) apart. Found along rays from the axis at the height of the topmost cutting part's centre,
/// from straight down to horizontal: on each the farthest point of the parts' triangles, followed
/// to a few micrometres. Where no part reaches the profile is straight, and flat at the axis. r
/// never decreases towards the gage: above a widest place the wall goes straight up, as the bit
/// leaves it. Throws InputError when no part cuts.
std::vector<ProfilePoint> exposure_profile(const std::vector<Part>& parts, double spacing);

}  // namespace tdbd::bit
