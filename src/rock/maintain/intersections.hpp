#pragma once

#include <utility>
#include <vector>

#include "mesh/check/self_intersections.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Triangles that replace, or would replace, some of the surface's. Frame W.
struct Patch {
  std::vector<mesh::NamedFacet> facets;  ///< corners named by vertex
  std::vector<int> replaced;             ///< triangles of the surface, sorted
};

/// Buffers of queries, kept between them.
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

/// The triangles that a collapse of the edge (keep, gone) would leave at both, with keep at x_W.
void take_collapsed(const mesh::Surface& s, int keep, int gone, const Vec3& x_W, Patch& patch);

/// Fills work.met with pairs that meet in more than what they share: of the patch's triangles with
/// each other and with those of the surface that the patch leaves; at most `most`. `longest_edge`
/// (m) bounds how far a triangle of the surface reaches from its nearest vertex: triangles with
/// longer edges may be missed. Cost is proportional to the patch's neighbourhood. M4.
void find_intersections(const Rock& rock, const Patch& patch, double longest_edge, std::size_t most,
                        IntersectionWork& work);

}  // namespace tdbd::rock
