#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/search/triangle_tree.hpp"

namespace tdbd::rock {

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

}  // namespace tdbd::rock
