#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// One thing that is wrong with a mesh, and where: vertex or triangle number and position in mm.
struct Defect {
  enum class Kind {
    index_out_of_range,    ///< a corner names a vertex that does not exist
    not_finite,            ///< a coordinate is NaN or infinite
    degenerate_triangle,   ///< corners coincide or lie on one line
    hole,                  ///< an edge with a triangle on one side only
    flipped_triangle,      ///< two triangles run along their edge in the same direction
    non_manifold_edge,     ///< an edge with more than two triangles
    non_manifold_vertex,   ///< a vertex where separate fans of triangles touch
    isolated_vertex,       ///< a vertex of no triangle
    several_pieces,        ///< not one connected surface
    boundary_loops,        ///< the number of boundary loops is not one
    euler_characteristic,  ///< V - E + F is not that of a disk: handles or inner holes
    inside_out,            ///< a closed mesh whose enclosed volume is not positive
    empty,                 ///< no triangles
    self_intersection,     ///< two triangles meet in more than what they share
  };
  Kind kind;
  std::string where;
};

/// Triangles of lower quality count as degenerate: their area is zero up to rounding.
inline constexpr double degenerate_quality = 1e-14;

/// Why `m` is not the boundary of a solid (closed, consistently oriented outwards, manifold, finite, without degenerate
/// triangles); empty if it is. Unused vertices are harmless here and are not reported.
std::vector<Defect> check_closed(const TriangleMesh& m);

/// Why `m` is not a sheet like the rock's surface (an oriented 2-manifold in one piece with one boundary loop, Euler
/// characteristic 1 and no isolated vertex); empty if it is.
std::vector<Defect> check_surface(const TriangleMesh& m);

/// The kind in words: "hole", "flipped triangle", ...
std::string name(Defect::Kind kind);

/// The first `max` defects, one per line, and how many more there are. Empty without defects.
std::string describe(const std::vector<Defect>& defects, std::size_t max = 10);

/// One line per kind: how many, and the first of them. "hole: 4 times, first edge 0-1 of ...".
std::string summarize(const std::vector<Defect>& defects);

/// "(1.0000, 2.0000, 3.0000) mm" for a position in m.
std::string in_mm(const Vec3& x);

/// "triangle 3 at (1.0000, 2.0000, 3.0000) mm": its centroid.
std::string place_of_triangle(const TriangleMesh& m, int i);

}  // namespace tdbd::mesh
