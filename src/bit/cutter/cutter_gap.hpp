#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Whether the gap between the solids of two cutters is less than `clearance` (m, > 0). A solid is
/// the cylinder of the cutter's diameter and length behind its face. The method projects
/// alternately onto one and the other. The distance of the projections never increases, and the
/// planes normal to it that touch both solids bound the gap from below. Cutters that are still
/// undecided after many iterations count as closer; this occurs only if the gap is within a
/// micrometre of the clearance. Reads sizes and poses.
bool closer_than(const Cutter& a, const Cutter& b, double clearance);

}  // namespace tdbd::bit
