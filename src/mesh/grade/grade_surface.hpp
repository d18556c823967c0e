#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "mesh/grade/grade.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/surface.hpp"

namespace tdbd::mesh {

/// A vertex and the features: on none, along one, or where one ends, forks or bends.
enum class Place : std::uint8_t { face, crease, corner };

/// A surface during grading.
struct GradeSurface {
  Surface s;
  std::set<std::pair<int, int>> features;  ///< edges, smaller vertex first
  std::vector<Place> place;                ///< per vertex slot
  std::vector<double> moved;               ///< m, bound on how far the surface has moved there
  TriangleTree original;                   ///< the mesh as given
  TriangleTree feature_tree;               ///< its features, as facets without area
  GradeOptions options;
  double rounding = 0.0;  ///< m, bound on displacement by rounding
};

GradeSurface make_grade_surface(const TriangleMesh& m, const GradeOptions& options);

/// Target edge length at x, m.
double target(const GradeSurface& g, const Vec3& x);

bool is_feature(const GradeSurface& g, int a, int b);

/// Halves edges longer than 4/3 of the target, longest first, until none is left. Returns how many.
std::size_t refine(GradeSurface& g);

/// Collapses edges shorter than 4/5 of the target, shortest first, where allowed. Returns how many.
std::size_t coarsen(GradeSurface& g);

/// Flips edges between coplanar facets where that improves the worse facet. Returns how many.
std::size_t flip(GradeSurface& g);

/// Moves vertices inside flat faces towards the mean of their neighbours where that improves the worst facet. Returns
/// how many.
std::size_t relax(GradeSurface& g);

}  // namespace tdbd::mesh
