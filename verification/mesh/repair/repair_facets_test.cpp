#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "mesh/measures.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::mesh::repair_facets_test {

/// Triangles over a few points: many share corners, edges or all.
TriangleMesh any_soup(int points, int most_triangles) {
  TriangleMesh m;
  for (int v = 0; v < points; ++v) m.positions.push_back(*battery::point(1.0));
  const int n = *battery::integer(1, most_triangles);
  while (static_cast<int>(m.triangles.size()) < n) {
    const int a = *battery::integer(0, points - 1),
              b = (a + *battery::integer(1, points - 1)) % points;
    const int c = *battery::integer(0, points - 1);
    if (c != a && c != b) m.triangles.push_back({a, b, c});
  }
  return m;
}

/// Every triangle with points of its own, on a grid whose steps are a little longer or shorter than the weld.
RC_GTEST_PROP(MergePoints, leaves_no_two_points_within_the_weld_and_moves_none_farther, ()) {
  const double weld = *rc::gen::element(0.0, 0.09, 0.11, 0.15);
  TriangleMesh m;
  const int corners = 3 * *battery::integer(1, 12);
  for (int v = 0; v < corners; ++v) {
    m.positions.push_back(
        0.1 * Vec3(*battery::integer(-2, 2), *battery::integer(-2, 2), *battery::integer(0, 1)));
    if (v % 3 == 2) m.triangles.push_back({v - 2, v - 1, v});
  }
  const TriangleMesh before = m;
  const std::size_t merged = merge_points(m, weld);
  RC_ASSERT(merged == before.positions.size() - m.positions.size());
  for (std::size_t i = 0; i < m.positions.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) RC_ASSERT((m.positions[i] - m.positions[k]).norm() > weld);
  RC_ASSERT(m.triangles.size() == before.triangles.size());
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      RC_ASSERT(
          (position(m, m.triangles[t][k]) - position(before, before.triangles[t][k])).norm() <=
          weld);
}

/// +1 or -1: which way round the corners go.
int facing(const Triangle& t) {
  return (t[0] < t[1]) == (t[1] < t[2]) ? (t[0] < t[2] ? 1 : -1) : (t[0] < t[2] ? -1 : 1);
}

std::set<int> corners_of(const Triangle& t) { return {t.begin(), t.end()}; }

/// Of the facets with the same corners the first stays, unless as many face one way as the other.
RC_GTEST_PROP(DropDuplicates, keeps_the_first_of_equals_that_do_not_cancel, ()) {
  TriangleMesh m = any_soup(4, 12);
  const std::vector<Triangle> before = m.triangles;
  std::vector<Triangle> expected;
  for (std::size_t i = 0; i < before.size(); ++i) {
    int sum = 0, equals_before = 0;
    for (std::size_t k = 0; k < before.size(); ++k)
      if (corners_of(before[k]) == corners_of(before[i])) {
        sum += facing(before[k]);
        equals_before += k < i;
      }
    if (equals_before == 0 && sum != 0) expected.push_back(before[i]);
  }
  RC_ASSERT(drop_duplicates(m) == before.size() - expected.size());
  RC_ASSERT(m.triangles == expected);
}

/// How many triangles have each edge.
std::map<std::set<int>, int> facets_at_edges(const std::vector<Triangle>& triangles) {
  std::map<std::set<int>, int> facets;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++facets[{t[k], t[(k + 1) % 3]}];
  return facets;
}

/// Numbers of sheets, spread again and again over edges of two triangles until none changes.
std::vector<std::size_t> sheets_of(const std::vector<Triangle>& triangles) {
  const auto facets = facets_at_edges(triangles);
  std::vector<std::size_t> sheet;
  for (std::size_t i = 0; i < triangles.size(); ++i) sheet.push_back(i);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < triangles.size(); ++k)
        for (std::size_t e = 0; e < 3; ++e) {
          const std::set<int> edge{triangles[i][e], triangles[i][(e + 1) % 3]};
          const auto has = [&](int v) { return corners_of(triangles[k]).contains(v); };
          if (facets.at(edge) != 2 || !std::ranges::all_of(edge, has) || sheet[k] <= sheet[i])
            continue;
          sheet[k] = sheet[i];
          changed = true;
        }
  }
  return sheet;
}

RC_GTEST_PROP(DropSheets, takes_those_with_an_open_edge_and_one_of_three_facets, ()) {
  TriangleMesh m = any_soup(7, 20);
  drop_duplicates(m);
  const std::vector<Triangle> before = m.triangles;
  const auto facets = facets_at_edges(before);
  const std::vector<std::size_t> sheet = sheets_of(before);
  std::set<std::size_t> open, standing;
  for (std::size_t i = 0; i < before.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const int n = facets.at({before[i][k], before[i][(k + 1) % 3]});
      if (n == 1) open.insert(sheet[i]);
      if (n > 2) standing.insert(sheet[i]);
    }
  std::vector<Triangle> expected;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (!open.contains(sheet[i]) || !standing.contains(sheet[i])) expected.push_back(before[i]);
  RC_TAG(expected.size() < before.size() ? "drops" : "keeps");
  RC_ASSERT(drop_sheets(m) == before.size() - expected.size());
  RC_ASSERT(m.triangles == expected);
}

/// Four points on a line, two facets without area: each pass gives the edge back that the one before took.
TEST(RemoveDegenerate, ends_where_splits_only_take_turns) {
  TriangleMesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  m.triangles = {{0, 2, 1}, {2, 0, 3}};
  EXPECT_EQ(remove_degenerate(m), 2u);
  EXPECT_EQ(m.triangles.size(), 2u);
}

TEST(RemoveDegenerate, drops_facets_with_a_corner_twice) {
  TriangleMesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  m.triangles = {{0, 0, 1}, {0, 1, 2}, {1, 2, 2}, {2, 0, 2}};
  EXPECT_EQ(remove_degenerate(m), 3u);
  EXPECT_EQ(m.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

/// A square in two triangles, on whose sides lie points with their flat facets: each splits its neighbour.
RC_GTEST_PROP(RemoveDegenerate, splits_the_neighbour_of_every_flat_facet, ()) {
  TriangleMesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  const int sides = *battery::integer(1, 4);
  for (int k = 0; k < sides; ++k) {
    const double along = 0.125 * *battery::integer(1, 7);
    const int a = k, b = (k + 1) % 4, middle = static_cast<int>(m.positions.size());
    m.positions.push_back((1.0 - along) * position(m, a) + along * position(m, b));
    Triangle flat{b, a, middle};
    std::rotate(flat.begin(), flat.begin() + *battery::integer(0, 2), flat.end());
    m.triangles.insert(m.triangles.begin() + *battery::integer(0, k + 2), flat);
  }
  RC_ASSERT(remove_degenerate(m) == static_cast<std::size_t>(sides));
  RC_ASSERT(m.triangles.size() == static_cast<std::size_t>(2 + sides));
  double sum = 0.0;
  for (const auto& [a, b, c] : m.triangles) {
    const Vec3 n = area_vector(position(m, a), position(m, b), position(m, c));
    RC_ASSERT(n.z() > 0.0);
    sum += n.z();
  }
  RC_ASSERT(std::abs(sum - 1.0) < 1e-15);
  for (const auto& [edge, facets] : facets_at_edges(m.triangles)) RC_ASSERT(facets <= 2);
}

TEST(DropUnusedPoints, keeps_the_others_in_their_order) {
  TriangleMesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  m.triangles = {{4, 1, 2}};
  EXPECT_EQ(drop_unused_points(m), 2u);
  EXPECT_EQ(m.positions, (std::vector<Vec3>{{1, 0, 0}, {2, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(m.triangles, (std::vector<Triangle>{{2, 0, 1}}));
}

}  // namespace tdbd::mesh::repair_facets_test
