#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// @file
/// The operations of repair(). Each returns how many things it changed; 0 leaves the mesh as it is.

/// Makes points closer than `weld` (equal ones for 0) one, the first of them. Facets keep their
/// number; some may have two corners the same now.
std::size_t merge_points(TriangleMesh& m, double weld);

/// Of facets with the same corners keeps one, or none if as many face one way as the other.
std::size_t drop_duplicates(TriangleMesh& m);

/// Removes facets without area: those with two corners the same, and flat ones whose middle corner
/// lies on the longest side, which is given to the neighbour there.
std::size_t remove_degenerate(TriangleMesh& m);

/// Drops facets that hang together, have an open edge and stand on an edge of three or more.
std::size_t drop_sheets(TriangleMesh& m);

/// Parts the surface at edges of four, six, ... facets and at vertices where fans touch, by
/// doubling vertices. Facets of such an edge go together if the wedge between them is inside by
/// most votes. Returns the vertices added; `refusal` tells edges of an odd number.
std::size_t part_non_manifold(TriangleMesh& m, std::string& refusal);

/// Turns facets so that neighbours agree, each piece as most of its facets. `refusal` tells a
/// surface of one side.
std::size_t turn_facets(TriangleMesh& m, std::string& refusal);

/// Turns pieces outwards, or inwards where an odd number of others surrounds them.
std::size_t turn_pieces(TriangleMesh& m);

/// Fills every boundary loop. Returns the loops; `refusal` tells one that has no triangulation.
std::size_t fill_holes(TriangleMesh& m, std::string& refusal);

/// One hole, given in the order of its facets to be: triangles over the numbers of the points.
/// Empty when there is none.
std::vector<Triangle> triangulate_loop(const std::vector<Vec3>& loop);

/// Unites closed pieces, and remeshes about the intersections that stay. The mesh is closed and
/// oriented. Returns whether it could: then nothing intersects.
bool remove_intersections(TriangleMesh& m);

/// Drops vertices of no facet.
std::size_t drop_unused_points(TriangleMesh& m);

}  // namespace tdbd::mesh
