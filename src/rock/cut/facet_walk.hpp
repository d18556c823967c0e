#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/search/triangle_tree.hpp"

namespace tdbd::rock {

/// For every facet of a tree, in its order, the facets across its edges a-b, b-c and c-a; -1 where
/// not exactly two facets share the edge. Corners at the same place are shared.
using FacetNeighbours = std::vector<std::array<int, 3>>;

FacetNeighbours neighbours_of(const mesh::TriangleTree& tree);

/// Kept between walks over one tree: the facet on which the last one ended, how many walks were
/// tried, how many found a way out, how many of those were enough for an answer, and how many facets
/// all walks, and those that found a way out, tested.
struct WalkMemory {
  const mesh::TriangleTree* of = nullptr;
  int facet = -1;
  long tried = 0, found = 0, answered = 0;
  long facets_tested = 0, facets_tested_by_found = 0;
};

/// Walks from facet `start`, always across the edge beyond which the line x + t u passes farthest,
/// to a facet that the line crosses outwards at t > 0. Returns its t, and its number in `start`;
/// nothing after too many steps, at an edge without a neighbour, or where the line only enters. The
/// line leaves the solid there, but perhaps not for the first time. Adds the number of facets that
/// it tested to `tested`. See rock (6); thesis: 4.1.3.4 (reconstructed).
std::optional<double> walk_to_exit(const mesh::TriangleTree& tree, const FacetNeighbours& across,
                                   const Vec3& x, const Vec3& u, int& start, long& tested);

/// The first facet that the line x + t u meets at t > 0.
struct FacetHit {
  int facet;
  double t;
};
std::optional<FacetHit> first_facet(const mesh::TriangleTree& tree, const Vec3& x, const Vec3& u);

}  // namespace tdbd::rock
