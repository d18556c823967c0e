#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/vertex_star.hpp"

namespace tdbd::mesh {

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
