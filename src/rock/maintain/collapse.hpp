#pragma once

#include <array>
#include <optional>

#include "rock/maintain/verdict.hpp"

namespace tdbd::rock {

/// What the guards say about the collapse of an edge. `refused` is empty also if there is no such
/// edge.
struct CollapseVerdict : Verdict {
  int corner = -1;          ///< that faces the edge; -1: no such edge, or a boundary vertex
  Vec3 x_W = Vec3::Zero();  ///< where the remaining vertex would go
};

/// The guards of try_collapse on the edge (a, b). Thesis: 4.2.1.
CollapseVerdict judge_collapse(const mesh::Surface& s, int a, int b,
                               const MaintenanceLimits& limits, const SurfaceDrift& drift = {});

/// The guards on distance of a collapse of the inner edge (a, b) to x_W, once the others agree: of the
/// dropped vertices and the middles of their edges to the new surface, and of the middles of the new
/// edges to the old one. `drifted`: how far the surface has drifted there if it is not refused, m.
std::optional<Refusal> judge_distance(const mesh::Surface& s, int a, int b, const Vec3& x_W,
                                      const MaintenanceLimits& limits, const SurfaceDrift& drift,
                                      double& drifted);

inline bool is_accepted(const CollapseVerdict& v) { return v.corner >= 0 && !v.refused; }

/// The verdict on each of the three places, least change of volume first.
std::array<CollapseVerdict, 3> judge_collapses(const mesh::Surface& s, int a, int b,
                                               const MaintenanceLimits& limits,
                                               const SurfaceDrift& drift);

/// Carries out an accepted collapse and counts it as `what`. `ring` receives the vertices whose
/// triangles changed.
void collapse(Rock& rock, const CollapseVerdict& verdict, Operation what, std::vector<int>& ring,
              SurfaceDrift& drift, MaintenanceReport& report);

/// Collapses the edge (a, b) to whichever of its ends or midpoint changes the volume least, if
/// every guard agrees: boundary, topology (fig. 4.18), no normal turned too far, no edge too long,
/// no triangle worse than both the worst one before and 0.3, volume and distance (of the dropped
/// vertices to the new triangles) within the limits, no more than `ridge_cut` off a sharp ridge.
/// Otherwise counts the first refusal. `ring` receives the vertices whose triangles changed.
/// Returns whether it was carried out. Thesis: 4.2.1.
bool try_collapse(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                  SurfaceDrift& drift, MaintenanceReport& report);

}  // namespace tdbd::rock
