#pragma once

#include <string>
#include <vector>

#include "rock/maintain/maintain.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// The promises M1 to M7 of the rock's surface (formulation 3; thesis 4.2, reconstructed). M4 here
/// is only that no operation turns a normal by more than 90 degrees; that nothing intersects is
/// asked by reference/mesh/self_intersections.
enum class Invariant {
  disc,      ///< M1: oriented 2-manifold with one boundary loop; adjacency and index in step
  quality,   ///< M2: no triangle whose shortest edge would collapse or longest edge would flip
  edges,     ///< M3: no edge outside its limits that would collapse or be bisected
  normals,   ///< M4
  ledger,    ///< M5: the reported change of volume is the change, to tolerance::ledger
  distance,  ///< M6: before and after are nearer to each other than shortest_edge / 2
  locality   ///< M7: the boundary, and what hangs together with no touched vertex, unchanged bits
};

/// One promise that is broken, and where: vertices or triangles by slot, positions in mm.
struct Violation {
  Invariant which;
  std::string where;
};

/// "M3: edge 3-7 ...", a line each, the first `max` and how many more.
std::string describe(const std::vector<Violation>& found, std::size_t max = 10);

/// M1. Also every living vertex is once in the index, where it is, and no dead one.
std::vector<Violation> check_disc(const Rock& rock);

/// M2 and M3 where asked[v] is 1 at a vertex of a triangle or an end of an edge: the guards are
/// asked again about every repair that is left. Where it is 2 not about bisections. `strays`: those
/// of the maintenance, since a repair may be refused for what others have moved already.
std::vector<Violation> check_repairs(const mesh::Surface& s, const std::vector<std::uint8_t>& asked,
                                     const MaintenanceLimits& limits, const Strays& strays = {});

/// M4 of one operation (a collapse or a bisection): of each triangle that is in its slot before and
/// after.
std::vector<Violation> check_normals(const mesh::Surface& before, const mesh::Surface& after);

/// M5: hole(after) - hole(before) = change, m3, to tolerance::ledger of the cube over the surface.
std::vector<Violation> check_ledger(const mesh::Surface& before, const mesh::Surface& after,
                                    double change);

/// Largest distance of the changed triangles' corners, middles of edges and centroids in `from` to
/// the surface `to`, m: the one-sided Hausdorff distance, sampled. No more than `reach` is told.
struct Deviation {
  double distance = 0.0;
  Vec3 x_W = Vec3::Zero();  ///< where
};
Deviation deviation(const mesh::Surface& from, const mesh::Surface& to, double reach);

/// M6 in both directions. The bound is `untangle_farthest` if the report has an untangling, else
/// L_min/2.
std::vector<Violation> check_distance(const mesh::Surface& before, const mesh::Surface& after,
                                      const MaintenanceLimits& limits,
                                      const MaintenanceReport& report = {});

/// M7. Changed triangles hang together when they share a corner or an edge joins them; each such
/// patch needs a vertex that was touched before.
std::vector<Violation> check_locality(const Rock& before, const mesh::Surface& after);

/// M1 to M3 and M5 to M7 of one maintenance, with what it alone reported.
std::vector<Violation> check_maintenance(const Rock& before, const Rock& after,
                                         const MaintenanceLimits& limits,
                                         const MaintenanceReport& report,
                                         const Strays& strays = {});

}  // namespace tdbd::rock
