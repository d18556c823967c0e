#pragma once

#include "rock/maintain/limits.hpp"
#include "rock/maintain/maintenance_work.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// One maintenance of the region touched since the last: blunts spikes; bisects long edges (longest
/// first); collapses short edges and those of bad triangles (shortest first) and flips edges of bad
/// triangles, in rounds until no repair is left; smooths vertices once and repairs what that made
/// necessary; takes apart what intersects itself (untangle.hpp). The boundary and what was not
/// touched keep every bit. Adds to `report`. Throws RunError with a place if repairs continue after
/// most_rounds. Thesis: 4.2.1 to 4.2.3; rock (15) to (18).
void maintain(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
              MaintenanceReport& report);

}  // namespace tdbd::rock
