#include "mesh/check/check.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/example_meshes.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::mesh::check_test {

using Kind = Defect::Kind;

bool has(const std::vector<Defect>& defects, Kind kind) {
  return std::any_of(defects.begin(), defects.end(),
                     [&](const Defect& d) { return d.kind == kind; });
}

TEST(Check, sound_meshes_have_no_defect) {
  EXPECT_TRUE(check_closed(tetrahedron()).empty()) << describe(check_closed(tetrahedron()));
  EXPECT_TRUE(check_surface(square_sheet(5)).empty()) << describe(check_surface(square_sheet(5)));
}

TEST(Check, a_missing_triangle_is_three_holes_with_their_positions) {
  TriangleMesh m = tetrahedron();
  m.triangles.pop_back();
  const auto defects = check_closed(m);
  ASSERT_EQ(defects.size(), 3u);
  for (const Defect& d : defects) EXPECT_EQ(d.kind, Kind::hole);
  EXPECT_EQ(defects[0].where,
            "edge 1-2 of triangle 0, from (1000.0000, 0.0000, 0.0000) mm to (0.0000, 1000.0000, "
            "0.0000) mm");
}

TEST(Check, a_flipped_triangle_is_found_at_each_of_its_edges) {
  TriangleMesh m = tetrahedron();
  std::swap(m.triangles[2][1], m.triangles[2][2]);
  const auto defects = check_closed(m);
  ASSERT_EQ(defects.size(), 3u);
  for (const Defect& d : defects) EXPECT_EQ(d.kind, Kind::flipped_triangle);
}

TEST(Check, a_mesh_with_all_triangles_flipped_is_inside_out) {
  TriangleMesh m = tetrahedron();
  for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
  const auto defects = check_closed(m);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Kind::inside_out);
}

TEST(Check, solids_that_touch_in_a_vertex_or_an_edge_are_not_manifold) {
  EXPECT_TRUE(has(check_closed(two_tetrahedra_sharing(1)), Kind::non_manifold_vertex));
  EXPECT_FALSE(has(check_closed(two_tetrahedra_sharing(1)), Kind::non_manifold_edge));
  EXPECT_TRUE(has(check_closed(two_tetrahedra_sharing(2)), Kind::non_manifold_edge));
}

TEST(Check, bad_indices_and_numbers_and_slivers_are_found) {
  TriangleMesh bad_index = tetrahedron(), bad_number = tetrahedron(), flat = tetrahedron();
  bad_index.triangles[1][2] = 4;
  bad_number.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  flat.positions[3] = 0.5 * (flat.positions[0] + flat.positions[1]);
  EXPECT_EQ(check_closed(bad_index)[0].where, "triangle 1 names vertex 4 of 4");
  EXPECT_TRUE(has(check_closed(bad_number), Kind::not_finite));
  EXPECT_TRUE(has(check_closed(flat), Kind::degenerate_triangle));
  bad_index.triangles[1][2] = -1;
  EXPECT_TRUE(has(check_surface(bad_index), Kind::index_out_of_range));
  EXPECT_TRUE(has(check_closed({}), Kind::empty));
}

TEST(Check, a_repeated_corner_is_degenerate) {
  TriangleMesh m = square_sheet(3);
  m.triangles.push_back({0, 0, 1});
  EXPECT_TRUE(has(check_surface(m), Kind::degenerate_triangle));
}

TEST(Check, a_sheet_with_a_hole_has_two_loops_and_is_not_a_disk) {
  TriangleMesh m = square_sheet(5);
  m.triangles.erase(m.triangles.begin() + 24);
  const auto defects = check_surface(m);
  EXPECT_TRUE(has(defects, Kind::boundary_loops));
  EXPECT_TRUE(has(defects, Kind::euler_characteristic));
}

TEST(Check, a_closed_mesh_two_sheets_or_a_stray_vertex_are_not_a_sheet) {
  EXPECT_TRUE(has(check_surface(tetrahedron()), Kind::boundary_loops));
  EXPECT_TRUE(has(check_surface(two_sheets()), Kind::several_pieces));
  TriangleMesh stray = square_sheet(3);
  stray.positions.push_back(Vec3(9, 9, 9));
  const auto defects = check_surface(stray);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].where, "vertex 16 at (9000.0000, 9000.0000, 9000.0000) mm");
}

/// Whatever its number.
TEST(Check, a_stray_vertex_is_found_before_the_others_too) {
  TriangleMesh m = square_sheet(3);
  m.positions.insert(m.positions.begin(), Vec3(9, 9, 9));
  for (Triangle& t : m.triangles)
    for (int& v : t) ++v;
  const auto defects = check_surface(m);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].where, "vertex 0 at (9000.0000, 9000.0000, 9000.0000) mm");
}

TEST(Check, a_description_lists_the_first_and_counts_the_rest) {
  const std::vector<Defect> three(3, {Kind::hole, "here"});
  EXPECT_EQ(describe(three, 2), "hole: here\nhole: here\nand 1 more\n");
  EXPECT_EQ(describe({}, 2), "");
}

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
Groups groups_by_pairs(int n, const std::function<bool(int, int)>& joined) {
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
  RC_ASSERT(connected_pieces(t) == groups_by_pairs(static_cast<int>(t.size()), [&](int i, int k) {
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
    const Groups fans = groups_by_pairs(static_cast<int>(at_v.size()), [&](int i, int k) {
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
  Groups loops = groups_by_pairs(points, is_open);
  std::erase_if(loops, [](const auto& loop) { return loop.size() == 1; });
  const Topology found = topology(m, sorted_sides(m));
  RC_ASSERT(found.pieces == static_cast<int>(groups_by_pairs(points, is_edge).size()));
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
  for (const auto& group : groups_by_pairs(n, [&](int i, int k) {
         return joined.contains({i, k});
       }))
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

}  // namespace tdbd::mesh::check_test
