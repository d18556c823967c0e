#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// @file
/// The steps of repair(). Unless stated otherwise, each returns the number of changed items; 0
/// means that the mesh is unchanged.

/// Merges points within `weld` (for 0: equal points) into the first of them. No facet is dropped;
/// some may then have two equal corners.
std::size_t merge_points(TriangleMesh& m, double weld);

/// Keeps one of several facets with the same corners, or none if equally many face either way.
std::size_t drop_duplicates(TriangleMesh& m);

/// Removes facets with zero area: those with two equal corners, and those whose middle corner lies
/// on the longest side. In the second case the neighbour across that side is split at the corner.
std::size_t remove_degenerate(TriangleMesh& m);

/// Drops sheets. A sheet is a set of connected facets with an open edge and an edge that three or
/// more facets share.
std::size_t drop_sheets(TriangleMesh& m);

/// Separates the surface at edges of four, six, ... facets and at vertices shared by several fans,
/// by duplicating vertices. Two facets of such an edge remain connected if, by a majority of the
/// facets, the wedge between them is inside. Returns the number of vertices added; `refusal` names
/// an edge with an odd number of facets.
std::size_t split_non_manifold(TriangleMesh& m, std::string& refusal);

/// Flips facets until neighbours agree; each piece takes the orientation of the majority of its
/// facets. `refusal` names a one-sided surface.
std::size_t orient_facets(TriangleMesh& m, std::string& refusal);

/// Turns each piece that faces inward and is not inside another piece, together with the pieces
/// inside it (nested_pieces). Pieces that intersect are not inside each other.
std::size_t orient_pieces(TriangleMesh& m);

/// Drops the pieces inside others that bound nothing (nested_pieces): bodies inside a body, of
/// which the union is the outer one. Returns the number of facets.
std::size_t drop_inner_shells(TriangleMesh& m);

/// Splits facets at open edges on which corners of other open edges lie (T-junctions), so that the
/// facets on both sides have the same corners. A corner lies on an edge if its distance is at most
/// `weld`, or the rounding of six digits. Returns the number of corners inserted.
std::size_t split_t_junctions(TriangleMesh& m, double weld);

/// The boundary loops as lists of vertices, in the direction of the facets that would fill them,
/// which is opposite to that of the open edges. Vertices must be manifold.
std::vector<std::vector<int>> boundary_loops(const TriangleMesh& m);

/// The largest share of the area of a mesh that the patch of a hole may add, unless its loop is flat.
inline constexpr double most_filled = 0.25;

/// Fills these boundary loops, all or none. Returns their number; `refusal` names a loop that has no
/// triangulation, or whose patch is too large (most_filled).
std::size_t fill_loops(TriangleMesh& m, const std::vector<std::vector<int>>& loops,
                       std::string& refusal);

/// Fills every boundary loop. Returns the number of loops; `refusal` names a loop that has no
/// triangulation.
std::size_t fill_holes(TriangleMesh& m, std::string& refusal);

/// Triangulates one hole, given in the direction of the facets to be added. The triangles refer to
/// the indices of the points. Empty if there is no triangulation.
std::vector<Triangle> triangulate_loop(const std::vector<Vec3>& loop);

/// Unites the pieces of a closed and oriented mesh, with the cavities inside them. Returns whether
/// the union is sound; otherwise the mesh is unchanged.
bool unite_pieces(TriangleMesh& m);

/// Cuts out facets around intersections and fills the holes, repeatedly. The mesh must be closed and
/// oriented. Returns whether the result is sound; otherwise the mesh is unchanged.
bool remesh_intersections(TriangleMesh& m);

/// Drops unused vertices.
std::size_t drop_unused_points(TriangleMesh& m);

}  // namespace tdbd::mesh
