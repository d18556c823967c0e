#pragma once

#include <utility>
#include <vector>

#include "mesh/check/self_intersections.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Triangles that stand, or would stand, in place of some of the surface's. Frame W.
struct Patch {
  std::vector<mesh::NamedFacet> facets;  ///< corners named by vertex
  std::vector<int> replaced;             ///< triangles of the surface, sorted
};

/// Room for queries, kept between them.
struct IntersectionWork {
  std::vector<std::pair<mesh::Triangle, mesh::Triangle>> met;  ///< of the last query
  std::vector<int> chains, triangles;
  std::vector<int> seen;  ///< per triangle: the last query's stamp
  int stamp = 0;
};

/// A triangle of the surface as it is.
mesh::NamedFacet named_facet(const mesh::Surface& s, int t);

/// One triangle as it is.
void take_triangle(const mesh::Surface& s, int t, Patch& patch);

/// The triangles at these vertices as they are, each once.
void take_stars(const mesh::Surface& s, const std::vector<int>& vertices, Patch& patch);

/// What a collapse of the edge (keep, gone) would make of the triangles at both, keep at x_W.
void take_collapsed(const mesh::Surface& s, int keep, int gone, const Vec3& x_W, Patch& patch);

/// Fills work.met with the pairs of the patch's triangles among each other and with what the patch
/// leaves of the surface that meet in more than what they share; no more than `most`.
/// `longest_edge` (m) bounds how far a triangle of the surface reaches from its nearest vertex:
/// longer ones may be missed. Cost follows the patch's neighbourhood. Formulation 3, M4.
void find_intersections(const Rock& rock, const Patch& patch, double longest_edge, std::size_t most,
                        IntersectionWork& work);

}  // namespace tdbd::rock
