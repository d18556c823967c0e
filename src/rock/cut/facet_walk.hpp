#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/search/triangle_tree.hpp"

namespace tdbd::rock {

/// For every facet of a tree, in its order, the facets across its edges a-b, b-c and c-a; -1 where
/// not exactly two facets share the edge. Corners are shared by place.
using FacetNeighbours = std::vector<std::array<int, 3>>;

FacetNeighbours neighbours_of(const mesh::TriangleTree& tree);

/// What walks remember from query to query: the facet that the last one ended on, how often they
/// found a way out, and how often that was enough for an answer. Of one tree.
struct WalkMemory {
  const mesh::TriangleTree* of = nullptr;
  int facet = -1;
  long tried = 0, found = 0, answered = 0;
};

/// From facet `start`, across the edge that the line x + t u misses its inside by most, until a
/// facet is met that the line crosses with its outer normal along u, at t > 0. Returns its t, and
/// its number in `start`; nothing after too many steps, at an edge without a neighbour, or where
/// the line only enters. Formulation 2.4; thesis: 4.1.3.4 (reconstructed).
/// What it finds is a place where the line leaves the solid, not the first one.
std::optional<double> walk_to_exit(const mesh::TriangleTree& tree, const FacetNeighbours& across,
                                   const Vec3& x, const Vec3& u, int& start);

/// The first facet that the line x + t u meets at t > 0.
struct FacetHit {
  int facet;
  double t;
};
std::optional<FacetHit> first_facet(const mesh::TriangleTree& tree, const Vec3& x, const Vec3& u);

}  // namespace tdbd::rock
