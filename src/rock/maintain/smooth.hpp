#pragma once

#include "rock/maintain/verdict.hpp"

namespace tdbd::rock {

/// Result of the guards on smoothing at a vertex. The volume is zero to rounding.
struct SmoothVerdict : Verdict {
  Vec3 x_W = Vec3::Zero();  ///< the new place of the vertex
};

/// Applies the guards of try_smooth at vertex v.
SmoothVerdict judge_smooth(const mesh::Surface& s, int v, const MaintenanceLimits& limits,
                           const SurfaceDrift& drift = {});

/// Laplacian smoothing at v, rock (17): moves v to the mean of its neighbours, without the
/// component along the sum N of the area vectors around v. The volume is an affine function of the
/// vertex's position with slope -N/3, so it does not change, and the loss of fig. 4.22 cannot
/// occur. Refused, and counted by reason: the boundary; a sharp ridge at v (the vertex would leave
/// it); a normal turned too far; an overhang; an edge outside its limits; the worst quality at v
/// not raised; local volume (sum of the magnitudes of the tetrahedra that the triangles sweep) or
/// distance above the limits. Thesis: 4.2.3, figs. 4.19 to 4.22 (reconstructed). Returns whether
/// the vertex moved.
bool try_smooth(Rock& rock, int v, const MaintenanceLimits& limits, SurfaceDrift& drift,
                MaintenanceReport& report);

}  // namespace tdbd::rock
