#pragma once

#include <optional>
#include <vector>

#include "mesh/search/triangle_tree.hpp"
#include "rock/cut/facet_walk.hpp"
#include "rock/cut/relative_path.hpp"
#include "rock/cut/strip.hpp"

namespace tdbd::rock {

/// Buffers of a query, kept between queries so that none allocates once warm.
struct MeshScratch {
  std::vector<double> ends;
  std::vector<Levels> intervals;
  std::vector<const mesh::Facet*> facets;
  WalkMemory walk;
};

/// Whether the path of the vertex alone enters the solid inside a closed mesh by more than `depth`
/// (m). Between two crossings of the surface the path is wholly inside or outside.
bool is_swept(const mesh::TriangleTree& solid, const RelativePath& path, double depth,
              MeshScratch& scratch);

/// Exit distance of a swept vertex from the solid inside any closed mesh: the end of the connected
/// set of t, from t = 0 on, for which some tau puts q(tau) + t u(tau) inside. Exact for straight q
/// and u: that set is bounded by where the levels of the strip begin and cease to meet facets
/// (Strip), and what lies between two such intervals is wholly inside or outside. Gaps up to
/// `depth` (m) do not separate. Same meaning as for a convex solid (swept_convex.hpp); twin:
/// reference/rock/brute_force_exit. See rock (3); thesis: 4.1.3.3 (reconstructed). Nothing if not
/// swept.
std::optional<double> exit_distance(const mesh::TriangleTree& solid, const RelativePath& path,
                                    double depth, MeshScratch& scratch);

/// The same exit from only the facets near the strip, up to a little beyond a place where the ray
/// of the strip's middle leaves the solid. A walk from the facet on which the last one ended finds
/// that place (facet_walk.hpp), or else the tree does. The first facet on the ray tells whether the
/// vertex is inside, the last whether what lies beyond is outside. Where any of this is in doubt,
/// or the vertex's path crosses the surface, the search above answers. See rock (6); thesis:
/// 4.1.3.4.
std::optional<double> exit_distance_by_walk(const mesh::TriangleTree& solid,
                                            const FacetNeighbours& across, const RelativePath& path,
                                            double depth, MeshScratch& scratch);

}  // namespace tdbd::rock
