#pragma once

#include "rock/maintain/verdict.hpp"

namespace tdbd::rock {

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

}  // namespace tdbd::rock
