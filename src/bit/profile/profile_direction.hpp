#pragma once

#include <vector>

#include "bit/profile/exposure_profile.hpp"
#include "bit/update_direction.hpp"

namespace tdbd::bit {

/// Update direction of the parts of a cutter whose frame is not known: eq. 4.2 with the normal of
/// the exposure profile into the rock in place of U~ (the same for a cutter without back rake). It
/// is the normal of a chord of the profile, as long as the parts, about the point nearest to their
/// middle, so that the scallops between cutters average out. Within 8 degrees of the direction from
/// the frame on bits A, B and C. Reconstructed; thesis: 4.1.2.1.
Vec3 profile_direction(const std::vector<ProfilePoint>& profile, const std::vector<Part>& parts,
                       DirectionRule rule, InsideRule inside);

}  // namespace tdbd::bit
