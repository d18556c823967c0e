#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Finds for every vertex the first vertex at most `weld` (m) away, in the order of x and then of
/// the numbers. A vertex that is itself the first maps to itself.
std::vector<int> first_within(const TriangleMesh& m, double weld);

/// Merges points at most `weld` (m) apart, and drops the facets that lose a corner and the points
/// that are no longer used. `tags`: a number for every facet, dropped with it. Returns the number of
/// merged points.
std::size_t weld_points(TriangleMesh& m, double weld, std::vector<int>* tags = nullptr);

/// Number of edges with one facet.
std::size_t open_edges(const TriangleMesh& m);

/// A weld distance that closes cracks: edges whose two facets have corners that differ slightly.
struct WeldHint {
  double distance = 0.0;   ///< m; the power of ten in mm with the fewest open edges
  std::size_t before = 0;  ///< open edges
  std::size_t after = 0;   ///< open edges after welding
};

/// Searches for a distance that closes nine tenths of the open edges, and is too short to close
/// holes. Nothing for a mesh without open edges, or if no distance does.
std::optional<WeldHint> weld_hint(const TriangleMesh& m);

/// The value of --weld in a command line: "0.001 mm".
std::string weld_text(const WeldHint& hint);

/// "36 open edges; points that should coincide differ: with --weld '0.001 mm' 0 edges are open".
std::string describe(const WeldHint& hint);

}  // namespace tdbd::mesh
