#pragma once

#include <string>

#include "bit/bit.hpp"
#include "reference/literature/roller/roller_bit.hpp"

namespace tdbd::reference {

/// A roller cone bit of ours as the models of thesis 2.2 draw it: cones on journals, teeth as
/// spheres about their tips, which stand where ours do at the cones' angle 0. Elevations are those
/// in the bit's frame, z down from its lowest tip. A cone's inertia is that of its parts, shell and
/// teeth added, as their meshes enclose them. The sphere of a hemispherical tooth is its own; that
/// of a conical one has its tip's radius, that of a chisel half of its crest's width.
///
/// These models have no skew, but any line is a plain journal: a skewed journal of azimuth A, offset e,
/// skew k and angle J becomes one of azimuth A + k and offset e cos k, whose common perpendicular with the
/// bit's axis meets it e sin k / cos J further inwards.
///
/// Throws InputError that begins with `model` for a bit with cutters or without cones, for a cone
/// without rows (read from meshes), and for a skewed journal along the bit's axis.
RollerBit roller_bit_of(const bit::Bit& bit,
                        const std::string& model = "models of roller cone bits");

}  // namespace tdbd::reference
