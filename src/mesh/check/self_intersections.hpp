#pragma once

#include <array>
#include <utility>
#include <vector>

#include "mesh/check/check.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Splits a mesh into pieces. Facets are taken in order, and a piece ends as soon as it is closed.
/// Solids that touch or share points therefore stay separate if they were written one after the
/// other. Facets that never close are grouped by the edges they share. Two points are equal if
/// their coordinates are. Facets and points keep their order.
std::vector<TriangleMesh> divide(const TriangleMesh& m);

/// The numbers of the facets of each of these pieces.
std::vector<std::vector<int>> divided_facets(const TriangleMesh& m);

/// Returns the triangles of `m` with each vertex replaced by the first vertex at the same position.
std::vector<Triangle> merge_equal_vertices(const TriangleMesh& m);

/// Returns the given triangles and the vertices they use, both in their original order.
TriangleMesh submesh(const TriangleMesh& m, const std::vector<int>& triangles);

/// The same for each piece of a mesh.
std::vector<TriangleMesh> submeshes(const TriangleMesh& m,
                                    const std::vector<std::vector<int>>& pieces);

/// Returns the pairs of triangles (first < second, sorted) that meet outside their common corners
/// and edges. A closed mesh with such pairs does not bound a solid. Uses exact predicates. Corners
/// at the same position are common; two triangles with the same three corners are a pair; triangles
/// with zero area are never in a pair. Indices must be in range and positions finite.
std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh);

/// A triangle with the names of its corners (equal names mean the same corner) and their positions,
/// m.
struct NamedFacet {
  Triangle names{};
  std::array<Vec3, 3> x;
};

/// Tests with exact predicates whether two triangles meet outside the corners and edges that have
/// the same names. False if either triangle has zero area.
bool intersect(const NamedFacet& first, const NamedFacet& second);

/// Returns the defects that check_closed finds, or, if there are none, the pairs of
/// self_intersections, or, if there are none, the pieces that bound nothing (nested_pieces): a body
/// inside a body, or a piece that faces inward and is no cavity.
std::vector<Defect> check_solid(const TriangleMesh& m);

}  // namespace tdbd::mesh
