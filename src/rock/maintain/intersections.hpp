#pragma once

#include <utility>
#include <vector>

#include "mesh/check/self_intersections.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Triangles that replace, or would replace, some triangles of the surface. Frame W.
struct Patch {
  std::vector<mesh::NamedFacet> facets;  ///< corners named by vertex
  std::vector<int> replaced;             ///< triangles of the surface, sorted
};

/// Buffers of find_intersections, kept between calls.
struct IntersectionWork {
  std::vector<std::pair<mesh::Triangle, mesh::Triangle>> met;  ///< result of the last query
  std::vector<int> chains, triangles;
  std::vector<int> seen;  ///< per triangle: stamp of the last query that saw it
  int stamp = 0;
};

/// A triangle of the surface with its present positions.
mesh::NamedFacet named_facet(const mesh::Surface& s, int t);

/// Fills the patch with one triangle in its present state.
void take_triangle(const mesh::Surface& s, int t, Patch& patch);

/// Fills the patch with the triangles at these vertices in their present state, each once.
void take_stars(const mesh::Surface& s, const std::vector<int>& vertices, Patch& patch);

/// Fills the patch with the triangles that a collapse of the edge (keep, gone) would leave at both
/// vertices, with keep at x_W.
void take_collapsed(const mesh::Surface& s, int keep, int gone, const Vec3& x_W, Patch& patch);

/// Finds at most `most` pairs of triangles that intersect in more than their shared vertices or
/// edges, and stores them in work.met: pairs within the patch, and pairs of a patch triangle and a
/// triangle of the surface that the patch does not replace. `longest_edge` (m) bounds the distance
/// of a triangle of the surface from its nearest vertex; triangles with longer edges may be missed.
/// The run time is proportional to the size of the patch's neighbourhood. M4.
void find_intersections(const Rock& rock, const Patch& patch, double longest_edge, std::size_t most,
                        IntersectionWork& work);

}  // namespace tdbd::rock
