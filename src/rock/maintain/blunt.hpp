#pragma once

#include "rock/maintain/verdict.hpp"

namespace tdbd::rock {

/// What the guards say about blunting at a vertex.
struct BluntVerdict : Verdict {
  bool is_spike = false;
  double drop = 0.0;  ///< m, straight down (+z)
};

/// Whether v is the tip of a spike: above all its neighbours, more than L_min / 2 above their mean,
/// while its triangles cover less than L_min^2 seen from above.
BluntVerdict judge_blunt(const mesh::Surface& s, int v, const MaintenanceLimits& limits,
                         const SurfaceDrift& drift = {});

/// Lowers the tip of a spike straight down, to the mean height of its neighbours or as far as the
/// limit on drift allows. Cutters that leave a needle of rock at the axis, thinner than the mesh
/// resolves, would stretch its triangles without end; rock so thin breaks. Nothing can fold on the
/// way straight down. The volume is exact and enters the ledger. Ours, not in the thesis. Returns
/// whether it was carried out.
bool try_blunt(Rock& rock, int v, const MaintenanceLimits& limits, SurfaceDrift& drift,
               MaintenanceReport& report);

}  // namespace tdbd::rock
