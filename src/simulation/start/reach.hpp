#pragma once

#include <vector>

#include "mesh/surface.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/case_warning.hpp"

namespace tdbd::simulation {

/// How far the bit stays from the rock during its motion at least, m: between the rock's box and that of the bit's way,
/// widened all around by the cutting point that is farthest from the bit's origin. 0: they may meet. Of a bit that forces
/// move it is the way on which it would follow its top.
double gap_on_the_way(const Case& c, const mesh::Surface& rock);

/// A warning at `motion` when there is such a gap.
std::vector<CaseWarning> reach_warnings(const Case& c, const mesh::Surface& rock);

}  // namespace tdbd::simulation
