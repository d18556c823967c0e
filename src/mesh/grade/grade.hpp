#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "mesh/search/triangle_tree.hpp"
#include "mesh/surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Sizes and tolerances of a graded mesh. The target edge length follows mesh (6).
struct GradeOptions {
  double edge = 0.5e-3;     ///< m, target along features
  double face = 3e-3;       ///< m, target far from features; at least `edge`
  double growth = 0.5;      ///< growth of the target per distance
  double angle = 0.44;      ///< rad: an edge is a feature if its facets meet at a sharper angle
  double deviation = 5e-6;  ///< m, largest movement of the surface; 0: coarsens flat faces only
};

/// The result of grading.
struct Graded {
  TriangleMesh mesh;
  std::size_t feature_edges = 0;  ///< number in the input mesh
  double deviation = 0.0;         ///< m, largest distance found between the two surfaces
  double volume_change = 0.0;     ///< m3, signed; at most options.deviation times the area
};

/// Refines a closed mesh along its features and coarsens its flat and smooth faces (thesis 3.3,
/// figs. 3.9 and 3.10). Edges longer than 4/3 of the target are halved, so new vertices lie on the
/// given facets. Edges shorter than 4/5 of the target are collapsed into one of their vertices if
/// that moves the surface by less than the deviation. In flat faces edges are flipped and inner
/// vertices moved to improve the shape.
///
/// Flat faces remain flat and features remain in place up to rounding, corners exactly. The outline
/// of a feature remains as coarse as given. The result is closed, oriented and manifold, and
/// deterministic. Throws InputError if the mesh does not bound a solid, RunError if the result
/// exceeds a bound.
Graded grade(const TriangleMesh& m, const GradeOptions& options);

/// Where a vertex is: on no feature (face), along one (crease), or where features end, branch or
/// bend (corner).
enum class Place : std::uint8_t { face, crease, corner };

/// A surface during grading.
struct GradeSurface {
  Surface s;
  std::set<std::pair<int, int>> features;  ///< feature edges, smaller vertex first
  std::vector<Place> place;                ///< per vertex slot
  std::vector<double> moved;               ///< m, bound on the movement of the surface
  TriangleTree original;                   ///< the given mesh
  TriangleTree feature_tree;               ///< its features, as facets with zero area
  GradeOptions options;
  double rounding = 0.0;  ///< m, bound on displacement by rounding
};

GradeSurface make_grade_surface(const TriangleMesh& m, const GradeOptions& options);

/// Target edge length at x, m.
double target(const GradeSurface& g, const Vec3& x);

bool is_feature(const GradeSurface& g, int a, int b);

/// Halves edges longer than 4/3 of the target, longest first, until none is left. Returns the
/// number of halved edges.
std::size_t refine(GradeSurface& g);

/// Collapses edges shorter than 4/5 of the target, shortest first, where permitted. Returns the
/// number of collapsed edges.
std::size_t coarsen(GradeSurface& g);

/// Flips edges between coplanar facets if that improves the worse facet. Returns the number of
/// flipped edges.
std::size_t flip(GradeSurface& g);

/// Moves vertices inside flat faces towards the mean of their neighbours if that improves the worst
/// facet. Returns the number of moved vertices.
std::size_t relax(GradeSurface& g);

}  // namespace tdbd::mesh
