#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case_warning.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// Whether any rock breaks out.
inline bool breaks_out(const rock::BreakoutRule& rule) {
  return rule.depth_share > 0.0 || rule.ahead_share > 0.0;
}

/// Reads angle and shares of a table. An angle outside (0, 90) degrees is noted as a mistake.
rock::BreakoutRule read_breakout_rule(Config& c);

/// Reads [spalling] and [spalling.areas.NAME] (spalling_keys); without the table, or where every bed
/// is confined by more than up_to_pressure, no rock breaks out. The latter is a warning.
/// Notes as mistakes: those of bit::read_areas, two areas of equal rank that disagree, an area with
/// a part that is no face of a cutter, one without a property, an angle outside (0, 90) degrees or
/// one that the update direction of a face cannot follow, a material that is not in [rock], a bit
/// without faces of cutters, and sections that are off.
SpallingPlan read_spalling(Config& whole, const bit::Bit& bit, const MeasurePlan& measure,
                           const ForcePlan& forces, std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
