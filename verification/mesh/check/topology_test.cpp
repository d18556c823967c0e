#include "mesh/check/topology.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/example_meshes.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::mesh::topology_test {

/// Triangles over a few points: they share corners and edges, two or more of them.
std::vector<Triangle> any_triangles(int points) {
  std::vector<Triangle> triangles;
  for (int k = *battery::integer(1, 16); k > 0; --k) {
    const int a = *battery::integer(0, points - 1), c = *battery::integer(0, points - 1);
    const int b = (a + *battery::integer(1, points - 1)) % points;
    if (c != a && c != b) triangles.push_back({a, b, c});
  }
  return triangles;
}

using Groups = std::vector<std::vector<int>>;

/// Groups of 0 .. n-1 that `joined` links, by spreading over and over.
Groups groups_by_hand(int n, const std::function<bool(int, int)>& joined) {
  Groups groups;
  std::vector<char> seen(at(n), 0);
  for (int first = 0; first < n; ++first) {
    if (seen[at(first)] != 0) continue;
    std::vector<int> group{first};
    seen[at(first)] = 1;
    for (std::size_t k = 0; k < group.size(); ++k)
      for (int i = 0; i < n; ++i)
        if (seen[at(i)] == 0 && joined(group[k], i)) {
          group.push_back(i);
          seen[at(i)] = 1;
        }
    std::ranges::sort(group);
    groups.push_back(group);
  }
  return groups;
}

int shared(const Triangle& s, const Triangle& t) {
  return static_cast<int>(
      std::ranges::count_if(s, [&](int v) { return std::ranges::count(t, v) > 0; }));
}

RC_GTEST_PROP(ConnectedPieces, are_the_triangles_that_edges_link, ()) {
  const std::vector<Triangle> t = any_triangles(12);
  RC_ASSERT(connected_pieces(t) == groups_by_hand(static_cast<int>(t.size()), [&](int i, int k) {
              return shared(t[at(i)], t[at(k)]) >= 2;
            }));
}

/// Triangles at a vertex are of one fan if they share an edge that ends there.
RC_GTEST_PROP(FanCounts, are_the_groups_of_triangles_around_a_vertex, ()) {
  constexpr int points = 9;
  TriangleMesh m{std::vector<Vec3>(points, Vec3::Zero()), any_triangles(points)};
  const std::vector<int> counts = fan_counts(m, sorted_sides(m));
  RC_ASSERT(counts.size() == static_cast<std::size_t>(points));
  for (int v = 0; v < points; ++v) {
    std::vector<Triangle> at_v;
    for (const Triangle& t : m.triangles)
      if (std::ranges::count(t, v) > 0) at_v.push_back(t);
    const Groups fans = groups_by_hand(static_cast<int>(at_v.size()), [&](int i, int k) {
      return shared(at_v[at(i)], at_v[at(k)]) >= 2;
    });
    RC_ASSERT(counts[at(v)] == static_cast<int>(fans.size()));
  }
}

/// Pieces by edges, loops by open edges, V - E + F.
RC_GTEST_PROP(Topology, counts_pieces_loops_and_the_euler_characteristic, ()) {
  constexpr int points = 12;
  const TriangleMesh m{std::vector<Vec3>(points, Vec3::Zero()), any_triangles(points)};
  std::map<std::set<int>, int> facets;
  for (const Triangle& t : m.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++facets[{t[k], t[(k + 1) % 3]}];
  const auto is_edge = [&](int i, int k) { return facets.contains({i, k}); };
  const auto is_open = [&](int i, int k) { return is_edge(i, k) && facets.at({i, k}) == 1; };
  Groups loops = groups_by_hand(points, is_open);
  std::erase_if(loops, [](const auto& loop) { return loop.size() == 1; });
  const Topology found = topology(m, sorted_sides(m));
  RC_ASSERT(found.pieces == static_cast<int>(groups_by_hand(points, is_edge).size()));
  RC_ASSERT(found.loops == static_cast<int>(loops.size()));
  RC_ASSERT(found.euler ==
            points - static_cast<int>(facets.size()) + static_cast<int>(m.triangles.size()));
}

/// The smallest member stands for its set, in whatever order they were joined.
RC_GTEST_PROP(DisjointSets, are_named_by_their_least_members, ()) {
  constexpr int n = 20;
  DisjointSets sets(n);
  std::set<std::pair<int, int>> joined;
  for (int k = *battery::integer(0, 25); k > 0; --k) {
    const int i = *battery::integer(0, n - 1), j = *battery::integer(0, n - 1);
    sets.join(i, j);
    joined.insert({i, j});
    joined.insert({j, i});
  }
  for (const auto& group : groups_by_hand(n, [&](int i, int k) { return joined.contains({i, k}); }))
    for (const int i : group) RC_ASSERT(sets.find(i) == group.front());
}

TEST(Topology, of_known_surfaces) {
  const TriangleMesh sheet = square_sheet(3), closed = tetrahedron(), two = two_sheets();
  const Topology a = topology(sheet, sorted_sides(sheet)),
                 b = topology(closed, sorted_sides(closed)), c = topology(two, sorted_sides(two));
  EXPECT_EQ(std::tuple(a.pieces, a.loops, a.euler), std::tuple(1, 1, 1));
  EXPECT_EQ(std::tuple(b.pieces, b.loops, b.euler), std::tuple(1, 0, 2));
  EXPECT_EQ(std::tuple(c.pieces, c.loops, c.euler), std::tuple(2, 2, 2));
}

}  // namespace tdbd::mesh::topology_test
