#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface.hpp"

namespace tdbd::mesh {

/// @file
/// Edits of the connectivity: edge splits and collapses (thesis 4.2.1 and 4.2.2), edge flips and
/// removal of boundary triangles. They update all adjacency data and do not check the shape;
/// rock/maintain does.

/// Splits the interior edge that faces corner c at the point x. Returns the new vertex.
int split_edge(Surface& s, int c, const Vec3& x);

/// Whether collapsing the edge that faces c preserves the topology (link condition; fig. 4.18): the
/// removed vertex is interior, the ends of the edge have exactly two common neighbours, and neither
/// of these has valence three.
bool collapse_keeps_topology(const Surface& s, int c);

/// Collapses the edge that faces corner c into the vertex that follows c, which moves to x.
/// Requires collapse_keeps_topology.
void collapse_edge(Surface& s, int c, const Vec3& x);

/// Whether the edge that faces c may be flipped to the other diagonal of its two triangles: it is
/// not on the boundary, and the two vertices that face it are not yet neighbours.
bool flip_keeps_topology(const Surface& s, int c);

/// Replaces the edge (a, b) that faces corner c by (p, q), the vertices that face it: triangles
/// (p, a, b) and (q, b, a) become (p, a, q) and (q, b, p). Requires flip_keeps_topology.
void flip_edge(Surface& s, int c);

/// Whether a disc remains a disc without triangle t: t has one boundary edge, which faces an
/// interior vertex, or two boundary edges, whose common vertex is removed too.
bool removal_keeps_disc(const Surface& s, int t);

/// Removes triangle t at the boundary. Requires removal_keeps_disc. Returns the vertex removed with
/// it, or -1.
int remove_triangle(Surface& s, int t);

/// Buffers for renumber, reused between calls so that later calls allocate nothing.
struct RenumberScratch {
  std::vector<int> number;         ///< per old vertex: its new number, -1 if it is dead
  std::vector<int> first_corners;  ///< per new triangle: the old corner that becomes its first
  std::vector<int> ends;  ///< per new vertex: end of the triangles of which it is the smallest
  std::vector<int> corner_number;  ///< per old corner: its new number, if its triangle is alive
  std::vector<int> corners;
  std::vector<VertexStar> stars;
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> bytes;
};

/// Renumbers the vertices of a surface: vertex order[i] becomes i. `order` contains every living
/// vertex once. Triangles are numbered by their smallest vertex, then by the vertex that follows
/// it, and start with the smallest; corner_of is the first corner at each vertex. The result is
/// what make_surface builds from the same triangles; it does not depend on the previous numbers or
/// on the order of edits. No dead entry is left. `scratch.number` receives the new numbers.
void renumber(Surface& s, const std::vector<int>& order, RenumberScratch& scratch);

/// Permutes `values`: entry order[i] becomes entry i, and entries not listed are removed. `scratch`
/// swaps its memory with `values`.
template <class T>
void take_in_order(const std::vector<int>& order, std::vector<T>& values, std::vector<T>& scratch) {
  scratch.reserve(values.capacity());
  scratch.resize(order.size());
  constexpr std::size_t farther = 16;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i + farther < order.size()) __builtin_prefetch(&values[at(order[i + farther])]);
    scratch[i] = values[at(order[i])];
  }
  values.swap(scratch);
}

}  // namespace tdbd::mesh
