#pragma once

#include "rock/maintain/limits.hpp"
#include "rock/maintain/maintenance_work.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Maintains the region touched since the last maintenance. It blunts spikes and bisects long edges
/// (longest first). In rounds until no repair is left, it collapses short edges and edges of bad
/// triangles (shortest first) and flips edges of bad triangles. It smooths vertices once and makes
/// the repairs that this requires. Finally it removes self-intersections (untangle.hpp). The
/// boundary and untouched triangles stay bitwise unchanged. Adds to `report`. Throws RunError with
/// a place if repairs continue after most_rounds rounds. Thesis: 4.2.1 to 4.2.3; rock (15) to (18).
void maintain(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
              MaintenanceReport& report);

}  // namespace tdbd::rock
