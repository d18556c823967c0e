#pragma once

#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Bisects the edge (a, b) at its midpoint if it still exists and is still too long. The new vertex
/// lies on the edge, so no volume changes. Boundary edges are refused. `ring` receives the vertices
/// whose triangles changed. Returns whether the edge was bisected. Thesis: 4.2.2.
bool bisect_edge(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                 MaintenanceReport& report);

}  // namespace tdbd::rock
