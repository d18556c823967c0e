#pragma once

#include "rock/maintain/verdict.hpp"

namespace tdbd::rock {

/// The guards of try_flip on the edge that faces corner c.
Verdict judge_flip(const mesh::Surface& s, int c, const MaintenanceLimits& limits,
                   const SurfaceDrift& drift = {});

/// Replaces the edge that faces corner c by the other diagonal of its two triangles where that
/// raises the worse of their qualities. Refused, and counted by reason: boundary, quality not
/// raised, a normal turned too far from either old one, an overhang, an edge outside its limits,
/// topology (the new edge exists already), volume (of the tetrahedron of the four vertices; its
/// limit falls to zero as the quality before rises to flip_quality) or distance (between the two
/// diagonals) above the limits, a sharp ridge cut. Ours, not in the thesis. Returns whether it was
/// carried out.
bool try_flip(Rock& rock, int c, const MaintenanceLimits& limits, SurfaceDrift& drift,
              MaintenanceReport& report);

}  // namespace tdbd::rock
