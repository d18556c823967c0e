#pragma once

#include "rock/maintain/verdict.hpp"

namespace tdbd::rock {

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

}  // namespace tdbd::rock
