#pragma once

#include "mesh/surface.hpp"

namespace tdbd::mesh {

/// The two surgeries of section 4.2 as pure connectivity: they ask no questions about shape (the
/// guards are in rock/) but keep every adjacency right. Thesis: 4.2.1, 4.2.2.

/// Bisects the interior edge that faces corner c at the point x. Returns the new vertex.
int split_edge(Surface& s, int c, const Vec3& x);

/// Whether the edge that faces c can go without tearing or pinching the surface: exactly two common
/// neighbours, not a chord between boundary vertices, no neighbour of valence three (fig. 4.18).
bool collapse_keeps_topology(const Surface& s, int c);

/// Collapses the edge that faces corner c onto the vertex that follows c, which is put at x.
/// Requires collapse_keeps_topology and that the vertex that goes is no boundary vertex.
void collapse_edge(Surface& s, int c, const Vec3& x);

}  // namespace tdbd::mesh
