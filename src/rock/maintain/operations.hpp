#pragma once

#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Bisects the edge (a, b) at its midpoint if it still exists and is still too long. The new vertex
/// lies on the edge, so no volume changes. Boundary edges are refused. `ring` receives the vertices
/// whose triangles changed. Returns whether the edge was bisected. Thesis: 4.2.2.
bool bisect_edge(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                 MaintenanceReport& report);

/// Applies the guards of try_flip to the edge that faces corner c.
Verdict judge_flip(const mesh::Surface& s, int c, const MaintenanceLimits& limits,
                   const SurfaceDrift& drift = {});

/// Replaces the edge that faces corner c by the other diagonal of its two triangles if that raises
/// the worse of their qualities. Refused, and counted by reason: boundary; quality not raised; a
/// normal turned too far from either old one; an overhang; an edge outside its limits; topology
/// (the new edge exists already); volume of the tetrahedron of the four vertices above its limit,
/// which falls to zero as the previous quality rises to flip_quality; distance between the two
/// diagonals above its limit; a sharp ridge cut. Not in the thesis. Returns whether the edge was
/// flipped.
bool try_flip(Rock& rock, int c, const MaintenanceLimits& limits, SurfaceDrift& drift,
              MaintenanceReport& report);

/// Result of the guards of try_blunt at a vertex.
struct BluntVerdict : Verdict {
  bool is_spike = false;
  double drop = 0.0;  ///< m, straight down (+z)
};

/// Tests whether v is the tip of a spike: above all its neighbours, more than L_min / 2 above their
/// mean, with triangles that cover less than L_min^2 in the horizontal projection.
BluntVerdict judge_blunt(const mesh::Surface& s, int v, const MaintenanceLimits& limits,
                         const SurfaceDrift& drift = {});

/// Lowers the tip of a spike straight down to the mean height of its neighbours, or as far as the
/// limit on drift allows. Cutters that leave a needle of rock at the axis, thinner than the mesh
/// resolves, would stretch its triangles indefinitely; rock that thin breaks. A vertical move
/// cannot fold the surface. The volume is exact and is added to the ledger. Not in the thesis.
/// Returns whether the tip was lowered.
bool try_blunt(Rock& rock, int v, const MaintenanceLimits& limits, SurfaceDrift& drift,
               MaintenanceReport& report);

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
