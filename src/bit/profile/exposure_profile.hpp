#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// A point of the half-plane through the bit's axis, m; z down.
struct ProfilePoint {
  double r = 0.0;
  double z = 0.0;
};

/// The exposure profile: what the cutting parts touch when all are turned about the bit's axis into
/// one half-plane, from the axis (r = 0) to the gage, with points about `spacing` (m) apart. Found
/// along rays from the axis, at the height of the topmost cutting part's centre, from straight down
/// to horizontal: on each, the farthest point of the parts' triangles, to a few micrometres. Where
/// no part reaches, the profile is straight, and flat at the axis. r never decreases towards the
/// gage: above the widest place the wall goes straight up, as the bit leaves it. Throws InputError
/// when no part cuts. Thesis: fig. 3.8 (its title is all that we hold); the construction is ours.
std::vector<ProfilePoint> exposure_profile(const std::vector<Part>& parts, double spacing);

}  // namespace tdbd::bit
