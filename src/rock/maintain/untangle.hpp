#pragma once

#include "rock/maintain/maintenance_work.hpp"

namespace tdbd::rock {

/// Among the triangles that were steep when maintenance began: the corners of those that overhang
/// and are turned by more than 90 degrees against a triangle at one of their corners; sorted. A
/// part that takes rock along a wall by more than an edge at once moves it past its neighbours;
/// where that folds layers into each other, some triangle between them is turned over (M4).
std::vector<int> folded_places(Rock& rock, const MaintenanceLimits& limits,
                               MaintenanceWorkspace& work);

/// Fills work.suspects with the triangles that may pass through others: those that are turned over
/// now, and all at the remaining `folded` places. Repairs may have turned the latter back while
/// they still wind twice around a vertex; otherwise triangles that all face one way cannot meet.
void find_suspects(Rock& rock, const std::vector<int>& folded, const MaintenanceLimits& limits,
                   MaintenanceWorkspace& work);

/// Takes apart the suspects that intersect: edges of intersecting pairs of triangles collapse,
/// shortest first, where that leaves fewer pairs around them, in rounds until none is left or
/// nothing helps. These collapses may change more volume and move the surface farther than others
/// (`untangle_volume`, `untangle_farthest`), cut ridges and turn normals; all other guards apply.
/// They are counted as untanglings. work.region receives the vertices around. Returns whether
/// anything changed. Ours, not in the thesis.
bool untangle(Rock& rock, const std::vector<int>& folded, const MaintenanceLimits& limits,
              MaintenanceWorkspace& work, MaintenanceReport& report);

}  // namespace tdbd::rock
