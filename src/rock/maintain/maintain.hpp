#pragma once

#include <vector>

#include "rock/maintain/intersections.hpp"
#include "rock/maintain/limits.hpp"
#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/touched_region.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// An edge that an operation may repair. Smaller keys first.
struct EdgeCandidate {
  double key;
  int a, b;  ///< vertices, a < b
};

/// The edge that faces corner c.
EdgeCandidate edge_facing(const mesh::Surface& s, int c, double key);

/// Sorts by key, then by vertices, and removes duplicate neighbours. The order does not depend on
/// addresses.
void sort_edges(std::vector<EdgeCandidate>& edges);

/// Buffers of maintain(), kept between calls to avoid allocations.
struct MaintenanceWorkspace {
  TouchedRegion touched;
  OldNotes old_notes = OldNotes::used;
  std::vector<int> unknown;  ///< touched vertices without a note
  std::vector<int> waiting;  ///< touched vertices that are not due
  std::vector<int> ring, changed, region;
  std::vector<EdgeCandidate> edges;
  std::vector<int> seen;  ///< per triangle: stamp of the last visit
  int stamp = 0;
  SurfaceDrift drift;         ///< of the last maintenance
  std::vector<int> suspects;  ///< triangles that may pass through others
  Patch patch;
  IntersectionWork intersections;
};

/// Maintains the region touched since the last maintenance. It blunts spikes and bisects long edges
/// (longest first). In rounds until no repair is left, it collapses short edges and edges of bad
/// triangles (shortest first) and flips edges of bad triangles. It smooths vertices once and makes
/// the repairs that this requires. Finally it removes self-intersections (untangle.hpp). The
/// boundary and untouched triangles stay bitwise unchanged. Adds to `report`. Throws RunError with
/// a place if repairs continue after most_rounds rounds. Thesis: 4.2.1 to 4.2.3; rock (15) to (18).
void maintain(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
              MaintenanceReport& report);

}  // namespace tdbd::rock
