#pragma once

#include <optional>

#include "rock/maintain/maintain.hpp"

namespace tdbd::rock {

/// What the guards say about blunting at a vertex; nothing is changed.
struct BluntVerdict {
  bool is_spike = false;
  std::optional<Refusal> refused;
  double drop = 0.0;    ///< m, straight down (+z)
  double volume = 0.0;  ///< m3 of hole gained
  double stray = 0.0;   ///< m: how far the surface then is from that before the maintenance
};

/// Whether v is the tip of a spike: above all its neighbours, more than L_min / 2 above their mean,
/// while its triangles cover less than L_min^2 seen from above.
BluntVerdict judge_blunt(const mesh::Surface& s, int v, const MaintenanceLimits& limits,
                         const Strays& strays = {});

/// Lowers the tip of a spike straight down, to the mean height of its neighbours or as far as the
/// bound on distance allows. Cutters that leave a needle of rock at the axis, thinner than the mesh
/// resolves, would stretch its triangles without end; rock so thin breaks. Straight down nothing
/// can fold. The volume is exact and goes into the ledger. Formulation 3 [+]: not in the thesis.
/// Returns whether it was carried out.
bool try_blunt(Rock& rock, int v, const MaintenanceLimits& limits, Strays& strays,
               MaintenanceReport& report);

}  // namespace tdbd::rock
