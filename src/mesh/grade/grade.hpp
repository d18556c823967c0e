#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// How fine a graded mesh is. The target edge length follows mesh (6).
struct GradeOptions {
  double edge = 0.5e-3;     ///< m, along features
  double face = 3e-3;       ///< m, far from them; at least edge
  double growth = 0.5;      ///< growth of the target per distance
  double angle = 0.44;      ///< rad: edges whose facets meet at a sharper angle are features
  double deviation = 5e-6;  ///< m, the most the surface may move; 0: coarsens flat faces only
};

/// The result of grading.
struct Graded {
  TriangleMesh mesh;
  std::size_t feature_edges = 0;  ///< of the input
  double deviation = 0.0;         ///< m, largest distance found between the two surfaces
  double volume_change = 0.0;     ///< m3, signed; at most options.deviation times the area
};

/// Refines a closed mesh along its features and coarsens its flat and smooth faces (3.3, figs. 3.9
/// and 3.10). Edges longer than 4/3 of the target are halved, so new vertices lie on the given facets;
/// edges shorter than 4/5 of it collapse onto one of their vertices where that moves the surface by less than the
/// deviation; in flat faces edges are flipped and inner vertices moved to improve the shape. Flat faces stay flat and
/// features in place to rounding, corners exactly; the outline of a feature stays as coarse as given. The result is
/// closed, oriented and manifold, and deterministic.
/// Throws InputError if the mesh does not bound a solid, RunError if the result exceeds a bound.
Graded grade(const TriangleMesh& m, const GradeOptions& options);

}  // namespace tdbd::mesh
