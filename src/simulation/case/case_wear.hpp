#pragma once

#include "core/config/config.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// Reads [wear] and [wear.areas.NAME] (wear_keys); without the table the bit does not wear. The law
/// of [wear] holds for all parts of cutters and for teeth, that of an area for its parts
/// (bit::decide); gage pads wear in areas alone. Notes as mistakes: those of bit::read_areas, two
/// areas of equal rank with different laws, an area with parts that are neither of cutters nor teeth
/// nor gage pads, a bit without any that wear, a case without [forces], and tables of rates that do
/// not fit their temperatures.
WearPlan read_wear(Config& whole, const bit::Bit& bit, const ForcePlan& forces);

}  // namespace tdbd::simulation
