#pragma once

#include <optional>
#include <vector>

#include "mesh/search/triangle_tree.hpp"
#include "rock/cut/facet_walk.hpp"
#include "rock/cut/relative_path.hpp"
#include "rock/cut/strip.hpp"

namespace tdbd::rock {

/// Buffers of a query, kept between queries to avoid allocations.
struct MeshScratch {
  std::vector<double> ends;
  std::vector<Levels> intervals;
  std::vector<const mesh::Facet*> facets;
  WalkMemory walk;
};

/// Whether the path of the vertex alone enters the solid inside a closed mesh by more than `depth`
/// (m). Between two crossings of the surface the path is wholly inside or wholly outside.
bool is_swept(const mesh::TriangleTree& solid, const RelativePath& path, double depth,
              MeshScratch& scratch);

/// Returns the exit distance, m, of a swept vertex from the solid inside any closed mesh: the end
/// of the connected set of t, from t = 0 on, for which some tau puts q(tau) + t u(tau) inside.
/// Returns nothing if the vertex is not swept. Exact for linear q and u: the levels at which the
/// strip begins and ceases to meet facets bound that set (Strip), and what lies between two such
/// intervals is wholly inside or outside. Gaps up to `depth` (m) do not separate. Same meaning as
/// for a convex solid (swept_convex.hpp). See rock (3); thesis: 4.1.3.3 (reconstructed). Twin:
/// reference/rock/brute_force_exit.
std::optional<double> exit_distance(const mesh::TriangleTree& solid, const RelativePath& path,
                                    double depth, MeshScratch& scratch);

/// Returns the same exit, using only the facets near the strip, up to slightly beyond a place at
/// which the ray of the strip's middle leaves the solid. A walk from the facet of the last exit
/// finds that place (facet_walk.hpp); if the walk fails, the tree finds it. The first facet on the
/// ray shows whether the vertex is inside, the last one whether the region beyond is outside. If
/// any of this is uncertain, or if the vertex's path crosses the surface, exit_distance is used.
/// See rock (6); thesis: 4.1.3.4.
std::optional<double> exit_distance_by_walk(const mesh::TriangleTree& solid,
                                            const FacetNeighbours& across, const RelativePath& path,
                                            double depth, MeshScratch& scratch);

}  // namespace tdbd::rock
