#pragma once

#include <string>
#include <vector>

#include "rock/maintain/verdict.hpp"

namespace tdbd::rock {

/// The promises M1 to M7 of the rock's surface (rock README; thesis 4.2, reconstructed). Of M4 only
/// that no operation turns a normal by more than 90 degrees is checked here; that nothing
/// intersects is checked by reference/mesh/self_intersections.
enum class Invariant {
  disc,      ///< M1: oriented disc with one boundary loop; adjacency and index agree with it
  quality,   ///< M2: no triangle whose shortest edge would collapse or longest edge would flip
  edges,     ///< M3: no edge outside its limits that would collapse or be bisected
  normals,   ///< M4
  ledger,    ///< M5: the reported change of volume is the change, to tolerance::ledger
  distance,  ///< M6: before and after are nearer to each other than shortest_edge / 2
  locality   ///< M7: the boundary and patches that are not at a touched vertex keep every bit
};

/// A broken promise and where: vertices or triangles by slot, positions in mm.
struct Violation {
  Invariant which;
  std::string where;
};

/// "M3: edge 3-7 ...", a line each, the first `max` and how many more.
std::string describe(const std::vector<Violation>& found, std::size_t max = 10);

/// M1. The index must hold every living vertex once, in its place, and no dead one.
std::vector<Violation> check_disc(const Rock& rock);

/// What check_repairs examines around a vertex. Bisections come before collapses, so long edges
/// beside what a collapse changed are not maintenance's fault.
enum class RepairScope : std::uint8_t { none, all, no_bisections };

/// M2 and M3 of triangles with a vertex in scope and edges with an end in scope: the guards must
/// refuse every repair that is left. `drift`: of the maintenance, since a repair may be refused for
/// what others have moved already.
std::vector<Violation> check_repairs(const mesh::Surface& s, const std::vector<RepairScope>& scope,
                                     const MaintenanceLimits& limits,
                                     const SurfaceDrift& drift = {});

/// M4 of one operation (a collapse or a bisection), for triangles whose slot is alive before and
/// after.
std::vector<Violation> check_normals(const mesh::Surface& before, const mesh::Surface& after);

/// M5: hole(after) - hole(before) = change (m3), to tolerance::ledger of the cube of the surface's
/// size.
std::vector<Violation> check_ledger(const mesh::Surface& before, const mesh::Surface& after,
                                    double change);

/// Largest distance of the changed triangles' corners, middles of edges and centroids in `from` to
/// the surface `to`, m: the one-sided Hausdorff distance, sampled; at most `reach`.
struct Deviation {
  double distance = 0.0;
  Vec3 x_W = Vec3::Zero();  ///< where
};
Deviation deviation(const mesh::Surface& from, const mesh::Surface& to, double reach);

/// M6 in both directions. The limit is `untangle_farthest` if the report has an untangling, else
/// L_min/2.
std::vector<Violation> check_distance(const mesh::Surface& before, const mesh::Surface& after,
                                      const MaintenanceLimits& limits,
                                      const MaintenanceReport& report = {});

/// M7. Changed triangles that share a corner or are joined by an edge form a patch; each patch
/// needs a vertex that was touched before, or a neighbour of one: a collapse can put back the
/// triangle at the touched vertex that a flip took from it, and change only what lies behind it.
std::vector<Violation> check_locality(const Rock& before, const mesh::Surface& after);

/// M1 to M3 and M5 to M7 of one maintenance; `report` must be of that one alone.
std::vector<Violation> check_maintenance(const Rock& before, const Rock& after,
                                         const MaintenanceLimits& limits,
                                         const MaintenanceReport& report,
                                         const SurfaceDrift& drift = {});

}  // namespace tdbd::rock
