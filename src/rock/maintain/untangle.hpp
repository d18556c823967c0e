#pragma once

#include "rock/maintain/maintain.hpp"

namespace tdbd::rock {

/// The corners of the triangles that overhang and are turned by more than 90 degrees against a
/// triangle at one of their corners, among those that were steep when maintenance looked; sorted.
/// Rock is moved past its neighbours when a part takes it along a wall by more than an edge at
/// once; where that folds layers into each other, some triangle between them is turned over.
/// Formulation 3, M4.
std::vector<int> folded_places(const Rock& rock, const MaintenanceLimits& limits,
                               const TouchedRegion& touched);

/// Fills work.suspects with the triangles that may pass through others: those that are turned over
/// so now, and all at `folded` places that are left. Repairs may have turned the latter back, and
/// yet they wind twice around a vertex; but for that, triangles that all face one way cannot meet.
void find_suspects(const Rock& rock, const std::vector<int>& folded,
                   const MaintenanceLimits& limits, MaintenanceWorkspace& work);

/// Takes apart what passes through itself among the suspects: edges of pairs of triangles that
/// intersect collapse, shortest first, where that leaves fewer pairs around them, in rounds until
/// none is left or nothing helps. These collapses may change more volume and move the surface
/// farther than others (`untangle_volume`, `untangle_farthest`), cut ridges and turn normals; all
/// else is asked as of any collapse, and counted as untanglings. work.region receives the vertices
/// around. Returns whether anything changed. Not in the thesis; ours.
bool untangle(Rock& rock, const std::vector<int>& folded, const MaintenanceLimits& limits,
              MaintenanceWorkspace& work, MaintenanceReport& report);

}  // namespace tdbd::rock
