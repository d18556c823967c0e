#pragma once

#include <array>
#include <optional>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

struct TrimReport {
  long triangles = 0;   ///< number of triangles removed
  double volume = 0.0;  ///< m3 by which mesh::hole_volume about W's origin decreases
};

/// Buffers of trim_wall.
struct TrimWorkspace {
  std::vector<int> chains, vertices, triangles;
};

/// Removes the triangles that lie wholly above the plane z = z_W (m, z down), from the boundary
/// loop inwards, one by one as long as a disc remains: M1 holds with a new boundary loop. Nothing
/// else changes. The boundary is searched only below z = from_z_W, so the run time of a trim that
/// continues the last one depends only on what it removes. For long runs; not in the thesis
/// (4.4.2).
void trim_wall(Rock& rock, double from_z_W, double z_W, TrimWorkspace& work, TrimReport& report);

/// Result of the guards on the collapse of an edge. `refused` is also empty if there is no such
/// edge.
struct CollapseVerdict : Verdict {
  int corner = -1;          ///< faces the edge; -1: no such edge, or a boundary vertex
  Vec3 x_W = Vec3::Zero();  ///< place of the remaining vertex
};

/// Applies the guards of try_collapse to the edge (a, b). Thesis: 4.2.1.
CollapseVerdict judge_collapse(const mesh::Surface& s, int a, int b,
                               const MaintenanceLimits& limits, const SurfaceDrift& drift = {});

/// Applies the guards on distance to a collapse of the inner edge (a, b) to x_W, after the other
/// guards accepted it. They limit the distances of the dropped vertices and of the midpoints of
/// their edges from the new surface, and of the midpoints of the new edges from the old surface.
/// `drifted`: drift of the surface there if the collapse is not refused, m.
std::optional<Refusal> judge_distance(const mesh::Surface& s, int a, int b, const Vec3& x_W,
                                      const MaintenanceLimits& limits, const SurfaceDrift& drift,
                                      double& drifted);

inline bool is_accepted(const CollapseVerdict& v) { return v.corner >= 0 && !v.refused; }

/// The verdicts on each of the three places, in ascending order of the change of volume.
std::array<CollapseVerdict, 3> judge_collapses(const mesh::Surface& s, int a, int b,
                                               const MaintenanceLimits& limits,
                                               const SurfaceDrift& drift);

/// Carries out an accepted collapse and counts it as `what`. `ring` receives the vertices whose
/// triangles changed.
void collapse(Rock& rock, const CollapseVerdict& verdict, Operation what, std::vector<int>& ring,
              SurfaceDrift& drift, MaintenanceReport& report);

/// Collapses the edge (a, b) to that one of its ends and its midpoint that changes the volume
/// least, if every guard accepts it: boundary; topology (fig. 4.18); no normal turned too far; no
/// edge too long; no triangle worse than both the worst one before and 0.3; volume and distance (of
/// the dropped vertices to the new triangles) within the limits; no more than `ridge_cut` off a
/// sharp ridge. Otherwise counts the first refusal. `ring` receives the vertices whose triangles
/// changed. Returns whether the edge collapsed. Thesis: 4.2.1.
bool try_collapse(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                  SurfaceDrift& drift, MaintenanceReport& report);

}  // namespace tdbd::rock
