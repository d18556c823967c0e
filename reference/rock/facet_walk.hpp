#pragma once

/// @file
/// A walk over the facets of a part to the exit of a vertex, thesis 4.1.3.4 (reconstructed). It is
/// slower than the search with a tree of boxes (reports/studies/exit-walk), so no case uses it. It
/// is measured beside that search, and uses its strips; it is not a twin of it.

#include <array>
#include <optional>
#include <vector>

#include "mesh/search/triangle_tree.hpp"
#include "rock/cut/swept_mesh.hpp"

namespace tdbd::reference {

/// For every facet of a tree, in the tree's order: the facets across its edges a-b, b-c and c-a, or
/// -1 where the edge does not belong to exactly two facets. Corners at equal positions are the same
/// corner.
using FacetNeighbours = std::vector<std::array<int, 3>>;

FacetNeighbours neighbours_of(const mesh::TriangleTree& tree);

/// State kept between walks over one tree, and counters: walks tried, walks that found a way out,
/// walks that were sufficient for an answer, facets tested by all walks, and facets tested by walks
/// that found a way out.
struct WalkMemory {
  const mesh::TriangleTree* of = nullptr;
  int facet = -1;
  long tried = 0, found = 0, answered = 0;
  long facets_tested = 0, facets_tested_by_found = 0;
};

/// Walks from facet `start`, always across the edge that the line x + t u misses by the largest
/// distance, to a facet that the line crosses outwards at t > 0. Returns that t and stores the
/// facet in `start`. Returns nothing after too many steps, at an edge without a neighbour, or if
/// the line only enters. The line leaves the solid at t, but not necessarily for the first time.
/// Adds the number of tested facets to `tested`. See rock (6); thesis: 4.1.3.4 (reconstructed).
std::optional<double> walk_to_exit(const mesh::TriangleTree& tree, const FacetNeighbours& across,
                                   const Vec3& x, const Vec3& u, int& start, long& tested);

/// The first facet that the line x + t u meets at t > 0.
struct FacetHit {
  int facet;
  double t;
};
std::optional<FacetHit> first_facet(const mesh::TriangleTree& tree, const Vec3& x, const Vec3& u);

/// Buffers of a query, and the state of its walks.
struct WalkScratch {
  rock::MeshScratch mesh;
  std::vector<const mesh::Facet*> facets;
  WalkMemory walk;
};

/// Returns the exit of rock::exit_distance, using only the facets near the strip, up to slightly beyond a place at
/// which the ray of the strip's middle leaves the solid. A walk from the facet of the last exit
/// finds that place; if the walk fails, the tree finds it. The first facet on the
/// ray shows whether the vertex is inside, the last one whether the region beyond is outside. If
/// any of this is uncertain, or if the vertex's path crosses the surface, exit_distance is used.
/// See rock (6); thesis: 4.1.3.4.
std::optional<double> exit_distance_by_walk(const mesh::TriangleTree& solid,
                                            const FacetNeighbours& across,
                                            const rock::RelativePath& path, double depth,
                                            WalkScratch& scratch);

}  // namespace tdbd::reference
