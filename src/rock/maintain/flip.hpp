#pragma once

#include <optional>

#include "rock/maintain/maintain.hpp"

namespace tdbd::rock {

/// What the guards say about a flip; nothing is changed.
struct FlipVerdict {
  std::optional<Refusal> refused;
  double volume = 0.0;  ///< m3 of hole gained
  double stray = 0.0;   ///< m: how far the surface then is from that before the maintenance
};

/// Asks the guards of try_flip about the edge that faces corner c.
FlipVerdict judge_flip(const mesh::Surface& s, int c, const MaintenanceLimits& limits,
                       const Strays& strays = {});

/// Replaces the edge that faces corner c by the other diagonal of its two triangles where that
/// raises the worse of their qualities. Refused, with the reason counted: boundary, quality not
/// raised, a normal turned too far from either old one, an overhang, an edge outside its limits,
/// topology (the new edge is there already), more volume (of the tetrahedron of the four vertices;
/// the bound falls to nothing as the quality before rises to flip_quality) or distance (of the two
/// diagonals) than the bounds, a sharp ridge cut. Formulation 3 [+]: not in
/// the thesis. Returns whether it was carried out.
bool try_flip(Rock& rock, int c, const MaintenanceLimits& limits, Strays& strays,
              MaintenanceReport& report);

}  // namespace tdbd::rock
