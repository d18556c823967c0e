#pragma once

#include "mesh/surface.hpp"

namespace tdbd::mesh {

/// @file
/// The surgeries of section 4.2 and a flip as pure connectivity: they ask no questions about shape
/// (the guards are in rock/) but keep every adjacency right. Thesis: 4.2.1, 4.2.2.

/// Bisects the interior edge that faces corner c at the point x. Returns the new vertex.
int split_edge(Surface& s, int c, const Vec3& x);

/// Whether the edge that faces c can go without tearing or pinching the surface: exactly two common
/// neighbours, not a chord between boundary vertices, no neighbour of valence three (fig. 4.18).
bool collapse_keeps_topology(const Surface& s, int c);

/// Collapses the edge that faces corner c onto the vertex that follows c, which is put at x.
/// Requires collapse_keeps_topology and that the vertex that goes is no boundary vertex.
void collapse_edge(Surface& s, int c, const Vec3& x);

/// Whether the edge that faces c may be replaced by the other diagonal of its two triangles: it is
/// no boundary, and the two corners that face it are not neighbours already.
bool flip_keeps_topology(const Surface& s, int c);

/// Replaces the edge (a, b) that faces corner c by (p, q), the vertices that face it: triangles
/// (p, a, b) and (q, b, a) become (p, a, q) and (q, b, p). Requires flip_keeps_topology.
void flip_edge(Surface& s, int c);

/// Whether a disc stays a disc without triangle t: it has one boundary edge and faces it with an
/// inner vertex, or two boundary edges, whose common vertex goes too.
bool removal_keeps_disc(const Surface& s, int t);

/// Removes triangle t at the boundary. Requires removal_keeps_disc. Returns the vertex that went
/// with it, or -1.
int remove_triangle(Surface& s, int t);

}  // namespace tdbd::mesh
