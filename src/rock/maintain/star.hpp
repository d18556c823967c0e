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

/// The corners of the triangle of corner c, beginning with its vertex.
inline mesh::Facet facet_at(const mesh::Surface& s, int c) {
  return {s.position(s.vertex(c)), s.position(s.vertex(mesh::next_corner(c))),
          s.position(s.vertex(mesh::previous_corner(c)))};
}

inline double quality(const mesh::Facet& f) { return mesh::triangle_quality(f.a, f.b, f.c); }
inline Vec3 doubled_area(const mesh::Facet& f) { return (f.b - f.a).cross(f.c - f.a); }
inline Vec3 area_vector(const mesh::Facet& f) { return mesh::area_vector(f.a, f.b, f.c); }

/// Worst quality of the triangles at v.
double worst_quality(const mesh::Surface& s, int v);

/// Refuses a normal that turns farther than the limit and a triangle that would overhang. Rock
/// moved straight down is a height field, and this keeps it one, except for upright walls: a
/// triangle within `steepest_overhang` of upright may lean over by that much, as the facets of a
/// round core's wall do by their shape.
std::optional<Refusal> judge_turn(const Vec3& before, const Vec3& after,
                                  const MaintenanceLimits& limits);

/// Whether the triangles beside the edge that faces c meet at a sharp ridge or valley.
bool is_sharp(const mesh::Surface& s, int c, const MaintenanceLimits& limits);

/// Whether a sharp edge ends at v.
bool is_on_ridge(const mesh::Surface& s, int v, const MaintenanceLimits& limits);

/// Whether triangle t overhangs and is turned by more than 90 degrees against one at its corners:
/// layers of rock may pass through each other there.
bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t);

}  // namespace tdbd::rock
