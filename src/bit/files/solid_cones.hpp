#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Reads the journals of cones whose solids are in a mesh file at the cone angle 0:
/// [[solids.cones]].
///   name       "cone-1"; the solids cone-1/... turn with it
///   azimuth, journal_angle, offset, skew, apex, foot_height    as in ConeLayout
///   rolling_ratio                                              Cone::rolling_ratio
/// Their shells and rows are the solids themselves, so gaps between cones are not checked.
std::vector<Cone> read_solid_cones(Config& solids);

/// Index of the cone to which a part belongs according to its name, or -1.
int cone_of(const std::vector<Cone>& cones, const std::string& part);

/// The [[solids.cones]] table of a cone; values read back exactly.
std::string cone_text_of(const Cone& cone);

}  // namespace tdbd::bit
