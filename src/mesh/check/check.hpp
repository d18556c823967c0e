#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Disjoint sets of 0 .. n-1 with path halving. The smallest member represents its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n);
  int find(int i);
  void join(int i, int j);

 private:
  std::vector<int> parent_;
};

/// Groups triangles that are connected by shared edges. Each piece is in ascending order; the
/// pieces are ordered by their first triangles.
std::vector<std::vector<int>> connected_pieces(const std::vector<Triangle>& triangles);

/// Number of fans of triangles around each vertex: 1 for a manifold, 0 for an isolated vertex.
std::vector<int> fan_counts(const TriangleMesh& m, const std::vector<Side>& sides);

/// Topological invariants of a surface. `loops` requires manifold vertices.
struct Topology {
  int pieces = 0;  ///< connected parts; an isolated vertex counts as one
  int loops = 0;   ///< closed chains of open edges
  int euler = 0;   ///< V - E + F
};
Topology topology(const TriangleMesh& m, const std::vector<Side>& sides);

/// A defect of a mesh and its place: the number and position (mm) of a vertex, edge or triangle.
struct Defect {
  enum class Kind {
    index_out_of_range,    ///< a corner refers to a vertex that does not exist
    not_finite,            ///< a coordinate is NaN or infinite
    degenerate_triangle,   ///< corners coincide or are collinear
    hole,                  ///< an edge with a triangle on one side only
    flipped_triangle,      ///< two triangles traverse their common edge in the same direction
    non_manifold_edge,     ///< an edge with more than two triangles
    non_manifold_vertex,   ///< a vertex shared by several fans of triangles
    isolated_vertex,       ///< a vertex that no triangle uses
    several_pieces,        ///< not one connected surface
    boundary_loops,        ///< the number of boundary loops is not one
    euler_characteristic,  ///< V - E + F is not that of a disk: handles or inner holes
    inside_out,            ///< a closed mesh whose enclosed volume is not positive
    empty,                 ///< no triangles
    self_intersection,     ///< two triangles meet outside their common corners and edges
    bad_nesting,           ///< a piece that bounds neither a body nor a cavity (nested_pieces)
  };
  Kind kind;
  std::string where;
};

/// A triangle of lower quality counts as degenerate: its area is zero up to rounding.
inline constexpr double degenerate_quality = 1e-14;

/// Checks that `m` bounds a solid: closed, manifold, oriented outwards, finite, and without
/// degenerate triangles. Returns the defects, or an empty list if there are none. Unused vertices
/// are harmless here and are not reported.
std::vector<Defect> check_closed(const TriangleMesh& m);

/// Checks that `m` is a sheet like the rock's surface: an oriented 2-manifold in one piece with one
/// boundary loop, Euler characteristic 1 and no isolated vertex. Returns the defects, or an empty
/// list if there are none.
std::vector<Defect> check_surface(const TriangleMesh& m);

/// The kind as text: "hole", "flipped triangle", ...
std::string name(Defect::Kind kind);

/// Lists the first `max` defects, one per line, and the number of further ones. Empty if there are
/// none.
std::string describe(const std::vector<Defect>& defects, std::size_t max = 10);

/// Returns one line per kind: how often it occurs, and where first. Example: "hole: 4 times, first
/// edge 0-1 of ...".
std::string summarize(const std::vector<Defect>& defects);

/// Formats a position given in m as "(1.0000, 2.0000, 3.0000) mm".
std::string in_mm(const Vec3& x);

/// Names triangle i with its centroid: "triangle 3 at (1.0000, 2.0000, 3.0000) mm".
std::string place_of_triangle(const TriangleMesh& m, int i);

}  // namespace tdbd::mesh
