#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// One side of a triangle; lo < hi are the ends of its edge.
struct Side {
  int lo = 0;
  int hi = 0;
  int triangle = 0;
  bool forward = false;  ///< whether the triangle traverses the edge from lo to hi
  int corner = 0;        ///< 3 triangle + i, the corner that faces this side
};

/// Returns all sides, sorted so that the sides of one edge are adjacent, in the order of their
/// triangles. Dead triangles (first corner negative) have no sides.
std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles);
inline std::vector<Side> sorted_sides(const TriangleMesh& m) { return sorted_sides(m.triangles); }

/// Calls visit(first, last) with the range of sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    while (j < sides.size() && sides[j].lo == sides[i].lo && sides[j].hi == sides[i].hi) ++j;
    visit(&sides[i], sides.data() + j);
  }
}

/// The corner 3 t + i of triangle t at vertex v.
inline int corner_at(const std::vector<Triangle>& triangles, int t, int v) {
  const Triangle& c = triangles[at(t)];
  return 3 * t + (c[0] == v ? 0 : c[1] == v ? 1 : 2);
}

/// A vertex and its neighbours in one cache line: the data of the surface that a step reads. The
/// neighbours are in counter-clockwise order. The triangles at vertex v are (v, ring[i], ring[i +
/// 1]), and the last neighbour with the first unless the ring is open. A closed ring starts with
/// its smallest index, an open one at the boundary, so a star depends on the connectivity only, not
/// on the edits that led to it. Rings of more than `held` neighbours are stored by the surface
/// (Surface::ring).
struct alignas(64) VertexStar {
  static constexpr int held = 8;
  Vec3 x = Vec3::Zero();         ///< m
  std::array<int, held> ring{};  ///< neighbours, if there are at most `held`
  std::uint32_t size : 31 = 0;   ///< number of neighbours; 0: the vertex is dead
  std::uint32_t open : 1 = 0;    ///< 1 on the boundary
  std::int32_t long_ring = -1;   ///< index into Surface::long_rings, or -1

  /// For checkpoints: the neighbours follow from the triangles (refresh_stars).
  template <class Archive>
  void serialize(Archive& a) {
    a(x);
  }
};

static_assert(sizeof(VertexStar) == 64);

struct Surface;

/// Recomputes the star of a vertex from the corner table. Every edit must call it for the vertices
/// whose triangles it changed.
void refresh_star(Surface& s, int v);

/// Recomputes the stars of all vertices.
void refresh_stars(Surface& s);

/// Whether every star equals the result of refresh_star. Slow; for tests and debug builds.
bool stars_are_consistent(const Surface& s);

/// A triangulated surface that can be edited, stored as a corner table, mesh (1): triangles and,
/// for every corner c = 3 t + i, the corner across the edge that faces c (-1 on the boundary). The
/// connectivity is stored a second time in the stars of the vertices, for code that loops around
/// vertices. Dead entries (triangle {-1,-1,-1}, corner_of -1, a star without neighbours) are kept
/// in free lists for reuse. Thesis: 4.2; B.6 has its surface classes.
struct Surface {
  std::vector<VertexStar> stars;  ///< positions and neighbours
  std::vector<Triangle> triangles;
  std::vector<int> opposite;           ///< 3 per triangle
  std::vector<int> corner_of;          ///< one corner at each vertex, -1 if the vertex is dead
  std::vector<std::uint8_t> boundary;  ///< 1 on the boundary loop
  std::vector<int> free_vertices;
  std::vector<int> free_triangles;
  std::vector<std::vector<int>> long_rings;  ///< rings of more than VertexStar::held neighbours
  std::vector<int> free_long_rings;

  /// The vertex of corner c. Triangles are contiguous in memory, so no division is needed.
  int vertex(int c) const {
    int v;
    std::memcpy(&v, triangles.data()->data() + c, sizeof(v));
    return v;
  }
  const VertexStar& star(int v) const { return stars[at(v)]; }
  /// The neighbours of a star; their number is star.size.
  const int* ring(const VertexStar& star) const {
    return star.long_ring < 0 ? star.ring.data() : long_rings[at(star.long_ring)].data();
  }
  const Vec3& position(int v) const { return stars[at(v)].x; }
  void place(int v, const Vec3& x) { stars[at(v)].x = x; }
  bool is_boundary(int v) const { return boundary[at(v)] != 0; }
  bool is_alive(int v) const { return corner_of[at(v)] >= 0; }
  bool triangle_is_alive(int t) const { return triangles[at(t)][0] >= 0; }
  int opposite_of(int c) const { return opposite[at(c)]; }
  int triangle_slots() const { return static_cast<int>(triangles.size()); }
  int vertex_slots() const { return static_cast<int>(stars.size()); }
  int triangle_count() const { return triangle_slots() - static_cast<int>(free_triangles.size()); }
  int vertex_count() const { return vertex_slots() - static_cast<int>(free_vertices.size()); }

  /// For checkpoints: with all its slots, dead ones too: vertices and triangles keep their numbers.
  template <class Archive>
  void serialize(Archive& a) {
    a(stars, triangles, opposite, corner_of, boundary, free_vertices, free_triangles);
  }
};

inline int next_corner(int c) { return c % 3 == 2 ? c - 2 : c + 1; }
inline int previous_corner(int c) { return c % 3 == 0 ? c + 2 : c - 1; }

static_assert(sizeof(Triangle) == 3 * sizeof(int));

/// The next corner at the same vertex, counter-clockwise; -1 at the boundary.
inline int turn_left(const Surface& s, int c) {
  const int o = s.opposite_of(next_corner(c));
  return o < 0 ? -1 : next_corner(o);
}

/// The next corner at the same vertex, clockwise; -1 at the boundary.
inline int turn_right(const Surface& s, int c) {
  const int o = s.opposite_of(previous_corner(c));
  return o < 0 ? -1 : previous_corner(o);
}

/// Calls visit(corner) for every corner at vertex v, counter-clockwise from corner_of[v]. At a
/// boundary vertex, the corners clockwise of corner_of[v] follow.
template <class Visit>
void visit_corners(const Surface& s, int v, Visit&& visit) {
  const int start = s.corner_of[at(v)];
  int c = start;
  do {
    visit(c);
    c = turn_left(s, c);
  } while (c >= 0 && c != start);
  if (c == start) return;
  for (c = turn_right(s, start); c >= 0; c = turn_right(s, c)) visit(c);
}

/// The corner that faces the edge (a, b) in the triangle where b follows a; -1 if there is none.
int corner_facing(const Surface& s, int a, int b);

/// Builds the adjacency. Throws InputError if an edge has more than two triangles, or if its two
/// triangles are oriented differently; the message names the vertices and their positions.
Surface make_surface(const TriangleMesh& m);

/// Returns the surface without its dead entries, in slot order. If given, slot_of_vertex receives
/// the slot in `s` of every vertex of the result.
TriangleMesh compact(const Surface& s, std::vector<int>* slot_of_vertex = nullptr);

/// The positions of all vertex slots, m.
std::vector<Vec3> positions_of(const Surface& s);

/// Recomputes the adjacency and compares. True if all entries of `opposite`, `corner_of` and
/// `boundary` and all stars are correct. Slow; for tests and debug builds.
bool adjacency_is_consistent(const Surface& s);

/// Volume between the surface and a cap over its boundary loop, m3, up to a constant that depends
/// on the boundary only; mesh (4) about `origin_W`. The normal of the rock points into the hole.
/// While the boundary is fixed, differences of this value are volumes removed.
double hole_volume(const Surface& s, const Vec3& origin_W);

}  // namespace tdbd::mesh
