#pragma once

#include <array>
#include <optional>

#include "rock/maintain/maintain.hpp"

namespace tdbd::rock {

/// What the guards say about the collapse of an edge; nothing is changed.
struct CollapseVerdict {
  int corner = -1;  ///< that faces the edge; -1: there is no such edge, or a boundary
  std::optional<Refusal> refused;  ///< the first refusal; nothing: accepted, or no such edge
  Vec3 x_W = Vec3::Zero();         ///< where the vertex that stays would go
  double volume = 0.0;             ///< m3 of hole gained
  double stray = 0.0;  ///< m: how far the surface then is from that before the maintenance
};

/// Asks the guards of try_collapse about the edge (a, b). Thesis: 4.2.1.
CollapseVerdict judge_collapse(const mesh::Surface& s, int a, int b,
                               const MaintenanceLimits& limits, const Strays& strays = {});

inline bool is_accepted(const CollapseVerdict& v) { return v.corner >= 0 && !v.refused; }

/// What they say about each of the three places, the one that changes the volume least first.
std::array<CollapseVerdict, 3> judge_collapses(const mesh::Surface& s, int a, int b,
                                               const MaintenanceLimits& limits,
                                               const Strays& strays);

/// Carries out an accepted collapse and counts it as `what`. `ring` receives the vertices whose
/// triangles changed.
void collapse(Rock& rock, const CollapseVerdict& verdict, Operation what, std::vector<int>& ring,
              Strays& strays, MaintenanceReport& report);

/// Collapses the edge (a, b) to whichever of its ends or midpoint changes the volume least, if
/// every guard agrees: boundary, topology (fig. 4.18), no normal turned too far, no edge too long,
/// no triangle worse than what was there and than the limit, volume and distance (of the dropped
/// vertices to the new triangles) within the bounds, no more than `ridge_cut` off a sharp ridge.
/// Counts the first refusal's reason. `ring` receives the vertices whose triangles changed. Returns
/// whether it was carried out. Thesis: 4.2.1.
bool try_collapse(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                  Strays& strays, MaintenanceReport& report);

}  // namespace tdbd::rock
