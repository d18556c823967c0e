#pragma once

#include <string>

#include "bit/bit.hpp"
#include "reference/literature/roller/roller_bit.hpp"

namespace tdbd::reference {

/// Converts a TDBD roller cone bit to the form of the models of thesis 2.2: cones on journals,
/// teeth as spheres about their tips, which are at the same places as in TDBD at the cones' angle
/// 0. Elevations are in the bit's frame, z down from its lowest tip. A cone's inertia is that of
/// its parts, the sum of shell and teeth, from their meshes. The sphere of a hemispherical tooth is
/// its own; that of a conical tooth has the radius of its tip, that of a chisel half the width of
/// its crest.
///
/// These models have no skew, but any line is a journal without skew: a skewed journal of azimuth
/// A, offset e, skew k and angle J becomes one of azimuth A + k and offset e cos k, which its
/// common perpendicular with the bit's axis meets e sin k / cos J further inwards.
///
/// Throws InputError that begins with `model` for a bit with cutters or without cones, for a cone
/// without rows (read from meshes), and for a skewed journal along the bit's axis.
RollerBit roller_bit_of(const bit::Bit& bit,
                        const std::string& model = "models of roller cone bits");

}  // namespace tdbd::reference
