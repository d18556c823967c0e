#pragma once

#include <algorithm>
#include <optional>

#include "mesh/facet.hpp"
#include "mesh/measures.hpp"
#include "mesh/surface.hpp"
#include "rock/maintain/limits.hpp"

namespace tdbd::rock {

/// @file
/// Measures and guards of the triangles around a vertex, shared by the operations of maintenance.
/// Thesis: 4.2 (reconstructed).

/// The triangle of corner c, with the vertex of c first.
inline mesh::Facet facet_at(const mesh::Surface& s, int c) {
  return {s.position(s.vertex(c)), s.position(s.vertex(mesh::next_corner(c))),
          s.position(s.vertex(mesh::previous_corner(c)))};
}

inline double quality(const mesh::Facet& f) { return mesh::triangle_quality(f.a, f.b, f.c); }
inline Vec3 doubled_area(const mesh::Facet& f) { return (f.b - f.a).cross(f.c - f.a); }
inline Vec3 area_vector(const mesh::Facet& f) { return mesh::area_vector(f.a, f.b, f.c); }

/// The worst quality of the triangles at v.
double worst_quality(const mesh::Surface& s, int v);

/// Refuses a normal that turns by more than the limit, and a triangle that would overhang. Rock
/// that is moved straight down is a height field; this guard keeps it one, except for upright
/// walls. A triangle within `steepest_overhang` of upright may overhang by that much, as the facets
/// of a round core's wall do by their shape.
std::optional<Refusal> judge_turn(const Vec3& before, const Vec3& after,
                                  const MaintenanceLimits& limits);

/// Whether the triangles beside the edge that faces c meet at a sharp ridge or valley.
bool is_sharp(const mesh::Surface& s, int c, const MaintenanceLimits& limits);

/// Whether a sharp edge ends at v.
bool is_on_ridge(const mesh::Surface& s, int v, const MaintenanceLimits& limits);

/// Whether triangle t overhangs and is turned by more than 90 degrees against a triangle at one of
/// its corners. Layers of rock may pass through each other there.
bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t);

}  // namespace tdbd::rock
