#pragma once

#include <optional>

#include "rock/maintain/maintain.hpp"

namespace tdbd::rock {

/// What the guards say about smoothing at a vertex; nothing is changed.
struct SmoothVerdict {
  std::optional<Refusal> refused;
  Vec3 x_W = Vec3::Zero();  ///< where the vertex would go
  double volume = 0.0;      ///< m3 of hole gained: zero to rounding
  double stray = 0.0;       ///< m: how far the surface then is from that before the maintenance
};

/// Asks the guards of try_smooth about vertex v.
SmoothVerdict judge_smooth(const mesh::Surface& s, int v, const MaintenanceLimits& limits,
                           const Strays& strays = {});

/// Laplacian smoothing at v: to the mean of its neighbours, without the part along the sum N of the
/// area vectors around v. The volume is an affine function of a vertex's place with slope -N/3, so
/// that none changes: the loss of fig. 4.22 does not happen. Refused, with the reason counted: the
/// boundary, a sharp ridge at v (it would leave it), a normal turned too far, an overhang, an edge
/// outside its limits, the worst quality at v not raised, more local volume (sum of the magnitudes
/// of the tetrahedra that the triangles sweep) or distance than the bounds. Thesis: 4.2.3,
/// figs. 4.19 to 4.22 (reconstructed). Returns whether it was carried out.
bool try_smooth(Rock& rock, int v, const MaintenanceLimits& limits, Strays& strays,
                MaintenanceReport& report);

}  // namespace tdbd::rock
