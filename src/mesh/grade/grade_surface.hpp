#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "mesh/grade/grade.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/surface.hpp"

namespace tdbd::mesh {

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
