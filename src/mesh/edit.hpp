#pragma once

#include "mesh/surface.hpp"

namespace tdbd::mesh {

/// @file
/// Edits of the connectivity alone (splits and collapses, thesis 4.2.1 and 4.2.2, and flips): they keep every adjacency
/// right and ignore the shape, which rock/maintain guards.

/// Bisects the interior edge that faces corner c at the point x. Returns the new vertex.
int split_edge(Surface& s, int c, const Vec3& x);

/// Whether collapsing the edge that faces c neither tears nor pinches the surface (link condition; fig. 4.18): the
/// vertex that goes is interior, its ends have exactly two common neighbours, and neither of these has valence three.
bool collapse_keeps_topology(const Surface& s, int c);

/// Collapses the edge that faces corner c onto the vertex that follows c, which moves to x. Requires
/// collapse_keeps_topology.
void collapse_edge(Surface& s, int c, const Vec3& x);

/// Whether the edge that faces c may be replaced by the other diagonal of its two triangles: it is
/// not on the boundary, and the two vertices that face it are not neighbours yet.
bool flip_keeps_topology(const Surface& s, int c);

/// Replaces the edge (a, b) that faces corner c by (p, q), the vertices that face it: triangles
/// (p, a, b) and (q, b, a) become (p, a, q) and (q, b, p). Requires flip_keeps_topology.
void flip_edge(Surface& s, int c);

/// Whether a disc stays a disc without triangle t: t has one boundary edge, which faces an interior vertex, or two
/// boundary edges, whose common vertex is removed too.
bool removal_keeps_disc(const Surface& s, int t);

/// Removes triangle t at the boundary. Requires removal_keeps_disc. Returns the vertex removed with it, or -1.
int remove_triangle(Surface& s, int t);

}  // namespace tdbd::mesh
