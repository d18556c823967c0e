#pragma once

#include "core/config/config.hpp"
#include "simulation/case/case_warning.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// Reads [forces] (force_keys) and the material of [rock] (read_formation); a run without [forces]
/// computes no forces. Mistakes are noted in the Config, coefficients that no part feels in
/// `warnings`.
ForcePlan read_forces(Config& c, const bit::Bit& bit, const MeasurePlan& measure,
                      std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
