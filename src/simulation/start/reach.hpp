#pragma once

#include <vector>

#include "mesh/surface.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/case_warning.hpp"

namespace tdbd::simulation {

/// Lower bound of the distance between bit and rock during the motion, m: the distance between the
/// box of the rock and the box of the path of the bit, enlarged by the cutting point farthest from
/// the origin of the bit. 0 means that they may meet. In free motion, the path is that of a bit
/// that follows its top.
double gap_on_the_way(const Case& c, const mesh::Surface& rock);

/// A warning at `motion` when there is such a gap.
std::vector<CaseWarning> reach_warnings(const Case& c, const mesh::Surface& rock);

}  // namespace tdbd::simulation
