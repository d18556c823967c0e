#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// How fine a graded mesh is. Target edge length at a distance d from the nearest feature:
///   h(d) = min(face, edge + growth d)
struct GradeOptions {
  double edge = 0.5e-3;     ///< m, along features
  double face = 3e-3;       ///< m, far from them; at least edge
  double growth = 0.5;      ///< of the target, per length of distance
  double angle = 0.44;      ///< rad: edges whose facets meet at a sharper angle are features
  double deviation = 5e-6;  ///< m, most that the surface may move; 0: nothing but flat facets
};

/// What grading did.
struct Graded {
  TriangleMesh mesh;
  std::size_t feature_edges = 0;  ///< of the input
  double deviation = 0.0;         ///< m, largest distance found between the two surfaces
  double volume_change = 0.0;     ///< m3, signed; at most options.deviation times the area
};

/// Refines a closed mesh along its features and coarsens its flat and smooth faces (3.3, figs. 3.9
/// and 3.10). Edges longer than 4/3 of the target are halved, so new vertices lie on the facets
/// that were given; shorter ones than 4/5 of it collapse onto a vertex of the mesh where the
/// surface moves by less than the deviation; facets in one plane turn their diagonals and move
/// their inner vertices for shape. Flat faces stay flat and features stay where they are to
/// rounding, corners to the bit; the outline of a feature is as coarse as it was given. The result
/// is closed, oriented and manifold, and the same for the same input.
/// Throws InputError if the mesh bounds no solid, RunError if the result should break a bound.
Graded grade(const TriangleMesh& m, const GradeOptions& options);

}  // namespace tdbd::mesh
