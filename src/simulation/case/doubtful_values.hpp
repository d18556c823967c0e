#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// N per m of diameter: 10 000 lbf per inch, at which the teeth of the hardest roller cone bits break
/// (Bourgoyne, Millheim, Chenevert and Young, Applied Drilling Engineering, 1986, (W/d)max of the table of tooth wear;
/// from memory). Bits with cutters bear less.
inline constexpr double most_weight_per_diameter = 1.75e6;

/// Width of the narrowest part that cuts, m: the middle one of the three sizes of its box. 0 without parts that cut.
double narrowest_width(const bit::Bit& bit);

/// A warning for each value that can be computed with and that is probably not intended: a rock whose edges are longer
/// than half of the narrowest part that cuts is wide (the surface does not show what it cuts), edges that are coarse for
/// the forces on teeth, sections nearer than the longest edge, a weight on bit beyond most_weight_per_diameter, an
/// attachment from which the bit topples, and a time step that does not resolve the bit's contact with its wall.
std::vector<CaseWarning> doubtful_values(const Config& c, const Case& read);

}  // namespace tdbd::simulation
