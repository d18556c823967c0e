#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// A point of the half-plane through the bit's axis, m; z down.
struct ProfilePoint {
  double r = 0.0;
  double z = 0.0;
};

/// Computes the exposure profile: the envelope of the cutting parts when all are rotated about the
/// bit's axis into one half-plane, from the axis (r = 0) to the gage, with points about `spacing`
/// (m) apart. It is sampled along rays from the point of the axis at the height of the topmost
/// cutting part's centre, from straight down to horizontal: on each ray, the farthest point of the
/// parts' triangles, to a few micrometres. Where no part reaches, the profile is straight, and flat
/// at the axis. r never decreases towards the gage: above the widest place the wall is vertical, as
/// the bit leaves it. Throws InputError if no part cuts. Thesis: fig. 3.8 (we have only its title);
/// the construction is not in the thesis.
std::vector<ProfilePoint> exposure_profile(const std::vector<Part>& parts, double spacing);

/// Update direction of the parts of a cutter whose frame is not known: eq. 4.2 with the normal of
/// the exposure profile into the rock in place of U~ (the same for a cutter without back rake). It
/// is the normal of a chord of the profile, as long as the parts, about the point nearest to their
/// middle, so that the scallops between cutters average out. Within 8 degrees of the direction from
/// the frame on bits A, B and C. Reconstructed; thesis: 4.1.2.1.
Vec3 profile_direction(const std::vector<ProfilePoint>& profile, const std::vector<Part>& parts,
                       DirectionRule rule, InsideRule inside);

}  // namespace tdbd::bit
