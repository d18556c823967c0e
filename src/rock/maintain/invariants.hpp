#pragma once

#include <string>
#include <vector>

#include "rock/maintain/limits.hpp"

namespace tdbd::rock {

/// The promises M1 to M7 of the rock's surface (rock README; thesis 4.2, reconstructed). The part
/// of M4 checked here is that no operation turns a normal by more than 90 degrees.
/// reference/mesh/self_intersections checks that no triangles intersect.
enum class Invariant {
  disc,      ///< M1: oriented disc with one boundary loop; consistent adjacency and index
  quality,   ///< M2: no triangle whose shortest edge would collapse or longest edge would flip
  edges,     ///< M3: no edge outside its limits that would collapse or be bisected
  normals,   ///< M4
  ledger,    ///< M5: the reported change of volume is the change, to tolerance::ledger
  distance,  ///< M6: the surfaces before and after are within shortest_edge / 2 of each other
  locality   ///< M7: the boundary, and patches without a touched vertex, are bitwise unchanged
};

/// A broken promise and its place: vertices or triangles by slot, positions in mm.
struct Violation {
  Invariant which;
  std::string where;
};

/// Formats violations as "M3: edge 3-7 ...", one per line: the first `max`, then the number of the
/// others.
std::string describe(const std::vector<Violation>& found, std::size_t max = 10);

/// Checks M1. The index must contain every living vertex once, in its place, and no other vertex.
std::vector<Violation> check_disc(const Rock& rock);

/// What check_repairs examines around a vertex. Bisections precede collapses, so maintenance is not
/// required to bisect long edges beside the result of a collapse.
enum class RepairScope : std::uint8_t { none, all, no_bisections };

/// Checks M2 and M3 of triangles with a vertex in scope and of edges with an end in scope: the
/// guards must refuse every remaining repair. `drift`: of the maintenance, because a repair may be
/// refused for the drift due to others.
std::vector<Violation> check_repairs(const mesh::Surface& s, const std::vector<RepairScope>& scope,
                                     const MaintenanceLimits& limits,
                                     const SurfaceDrift& drift = {});

/// Checks M4 of one operation (a collapse or a bisection), for triangles whose slot is alive before
/// and after.
std::vector<Violation> check_normals(const mesh::Surface& before, const mesh::Surface& after);

/// Checks M5: hole(after) - hole(before) = change (m3), to tolerance::ledger times the cube of the
/// surface's size.
std::vector<Violation> check_ledger(const mesh::Surface& before, const mesh::Surface& after,
                                    double change);

/// The largest distance, m, from corners, edge midpoints and centroids of the changed triangles of
/// `from` to the surface `to`, but at most `reach`: a sampled one-sided Hausdorff distance.
struct Deviation {
  double distance = 0.0;
  Vec3 x_W = Vec3::Zero();  ///< where
};
Deviation deviation(const mesh::Surface& from, const mesh::Surface& to, double reach);

/// Checks M6 in both directions. The limit is `untangle_farthest` if the report contains an
/// untangling, otherwise L_min/2.
std::vector<Violation> check_distance(const mesh::Surface& before, const mesh::Surface& after,
                                      const MaintenanceLimits& limits,
                                      const MaintenanceReport& report = {});

/// Checks M7. Changed triangles that share a corner or an edge form a patch. Each patch must
/// contain a vertex that was touched before, or a neighbour of one. (A flip takes a triangle from a
/// touched vertex; a collapse may restore it, so that only triangles behind it changed.)
std::vector<Violation> check_locality(const Rock& before, const mesh::Surface& after);

/// Checks M1 to M3 and M5 to M7 of one maintenance. `report` must contain this maintenance only.
std::vector<Violation> check_maintenance(const Rock& before, const Rock& after,
                                         const MaintenanceLimits& limits,
                                         const MaintenanceReport& report,
                                         const SurfaceDrift& drift = {});

/// Debug builds check promises M1 and M5 around every operation of maintenance. The run time
/// depends on the operation, not on the size of the rock.
#ifdef TDBD_CHECK_EVERY_OPERATION
inline constexpr bool check_every_operation = true;
#else
inline constexpr bool check_every_operation = false;
#endif

/// The triangles at some vertices before an operation that involves them.
struct LocalState {
  std::vector<int> vertices;
  Vec3 origin_W = Vec3::Zero();
  double volume = 0.0;  ///< m3 of hole between the origin and their triangles
  double size = 0.0;    ///< m, largest distance of these triangles from the origin
};

/// `vertices` must include all vertices whose triangles the operation may change.
LocalState local_state(const mesh::Surface& s, std::vector<int> vertices);

/// Checks M1 around those of the state's vertices that are alive: corners and their opposites
/// agree, no neighbour appears twice, and the index has the vertex in its place. Checks M5: their
/// volume has changed by `volume_change` (m3).
std::vector<Violation> check_around(const Rock& rock, const LocalState& before,
                                    double volume_change);

/// Throws RunError with the first violations if there are any. `what`: the operation's name.
void require_promises_around(const Rock& rock, const LocalState& before, double volume_change,
                             const char* what);

}  // namespace tdbd::rock
