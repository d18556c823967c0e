#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// @file
/// Closed pieces inside each other. A piece that faces outward adds one to the winding number of
/// the points inside it, and one that faces inward subtracts one. The points with a positive number
/// are solid. Therefore an inward piece in an outward one is a cavity, and an outward piece in an
/// outward one bounds nothing: its volume would count twice.

/// What a piece bounds, by the pieces that surround it.
enum class Bounds {
  solid_or_cavity,  ///< one side is solid, the other is not
  nothing,          ///< both sides are solid, or neither
  unknown,          ///< the piece is not closed
};

/// A piece and its place among the others.
struct NestedPiece {
  TriangleMesh mesh;
  std::vector<int> around;  ///< numbers of the closed pieces that surround it
  int outermost = 0;        ///< number of the largest one of these; its own if there are none
  bool outward = true;      ///< whether its enclosed volume is positive
  Bounds bounds = Bounds::unknown;
};

/// Finds which pieces surround each other. Pieces that intersect do not surround each other. Points
/// at equal positions count as one. Exact predicates decide on intersections. The run time is the
/// square of the number of closed pieces for boxes in boxes, otherwise that of searches in trees.
std::vector<NestedPiece> nested_pieces(std::vector<TriangleMesh> pieces);

/// The facets of each body of a mesh: a piece (divide) that is not inside others, with the pieces
/// inside it, which may be its cavities. Facets keep their order.
std::vector<std::vector<int>> facets_of_bodies(const TriangleMesh& m);

/// The same, except that a piece of one group inside a piece of another one is a body of its own.
std::vector<std::vector<int>> facets_of_bodies(const TriangleMesh& m,
                                               const std::vector<int>& group_of_facet);

}  // namespace tdbd::mesh
