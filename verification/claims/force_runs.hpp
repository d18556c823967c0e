#pragma once

#include <string>
#include <vector>

#include "claims/rock_runs.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::claims {

/// Of the sharp bits here: the literature's common rock.
inline constexpr double sharp_eps = 100e6, sharp_zeta = 0.8;  // Pa, 1

/// Settings of a sharp bit in the sense of Detournay and Defourny: faces that cut, no friction
/// anywhere. Means of the second revolution.
std::vector<std::string> sharp(std::vector<std::string> more);

/// Settings of the law that is reconstructed from appendix C, for a case that gives it. Means of
/// the second revolution.
std::vector<std::string> reconstructed(std::vector<std::string> more);

/// Drills the whole case.
simulation::LoadStatisticsSummary loads_of(const simulation::Case& c);

/// Of bit B, sharp; of bit B under 3000 psi by the reconstructed law.
simulation::LoadStatisticsSummary sharp_loads(const std::vector<std::string>& more);
simulation::LoadStatisticsSummary reconstructed_loads(const std::vector<std::string>& more);

/// Advance of a revolution, m.
double depth_of_cut(const simulation::Case& c);

}  // namespace tdbd::claims
