#pragma once

#include <cstddef>

#include "mesh/measures.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Statistics of a mesh, which may have defects. Its indices must be in range and its positions
/// finite.
struct Inspection {
  std::size_t vertices = 0;
  std::size_t facets = 0;
  std::size_t pieces = 0;                 ///< pieces connected by edges
  std::size_t equal_points = 0;           ///< vertices at the position of an earlier one
  std::size_t degenerate = 0;             ///< facets with zero area
  std::size_t duplicates = 0;             ///< facets with the corners of an earlier one
  std::size_t open_edges = 0;             ///< edges of one facet
  std::size_t flipped_edges = 0;          ///< edges that both facets traverse in the same direction
  std::size_t non_manifold_edges = 0;     ///< edges of more than two facets
  std::size_t non_manifold_vertices = 0;  ///< vertices shared by several fans of facets
  std::size_t intersecting_pairs = 0;     ///< see self_intersections
  double volume = 0.0;                    ///< m3, enclosed; meaningless for an open mesh
  double area = 0.0;                      ///< m2
  Box box;
  double shortest_edge = 0.0, mean_edge = 0.0, longest_edge = 0.0;  ///< m
  double worst_quality = 0.0;                                       ///< see triangle_quality

  bool is_closed() const { return open_edges == 0; }
  bool is_oriented() const { return flipped_edges == 0 && volume > 0.0; }
  bool is_manifold() const { return non_manifold_edges == 0 && non_manifold_vertices == 0; }
};

Inspection inspect(const TriangleMesh& m);

}  // namespace tdbd::mesh
