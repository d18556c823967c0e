#pragma once

#include "rock/maintain.hpp"

namespace tdbd::rock {

/// Bisects the edge (a, b) at its midpoint if it still exists and is still too long. The new vertex
/// lies on the edge, so no volume changes (formulation 3). Boundary edges are refused.
/// Thesis: 4.2.2.
void bisect_edge(Rock& rock, int a, int b, const MaintenanceLimits& limits,
                 MaintenanceReport& report);

}  // namespace tdbd::rock
