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

/// The law of a kind of part where that of the whole run does not hold: what a cutter's body bears
/// (ours), and none for all others.
forces::Law own_law_of(bit::PartKind kind);

/// Whether the law of the whole run holds for parts of this kind, as far as it knows them.
bool follows_the_run(bit::PartKind kind);

}  // namespace tdbd::simulation
