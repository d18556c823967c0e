#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

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

/// The same facets in any order, each beginning with any corner.
TriangleMesh shuffled(TriangleMesh m) {
  for (std::size_t i = m.triangles.size(); i > 1; --i)
    std::swap(m.triangles[i - 1], m.triangles[*rc::gen::inRange<std::size_t>(0, i)]);
  for (Triangle& t : m.triangles)
    std::rotate(t.begin(), t.begin() + *battery::integer(0, 2), t.end());
  return m;
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// `count` wedges around the z axis between 0 and 1, filling half of the space: all their facets
/// meet there.
TriangleMesh wedges(int count) {
  std::vector<Solid> all;
  for (int k = 0; k < count; ++k) {
    const double from = 2.0 * std::numbers::pi * k / count, to = from + std::numbers::pi / count;
    all.push_back(
        {"wedge",
         battery::prism({{0, 0}, {std::cos(from), std::sin(from)}, {std::cos(to), std::sin(to)}}, 0,
                        1)});
  }
  const TriangleMesh m = merged(all);
  TriangleMesh joined{m.positions, merge_equal_vertices(m)};
  drop_unused_points(joined);
  return joined;
}

/// Whichever facet comes first, and though one faces the wrong way.
RC_GTEST_PROP(SplitNonManifold, parts_wedges_that_meet_at_an_edge, ()) {
  const int count = *battery::integer(2, 5);
  TriangleMesh m = shuffled(battery::placed(*battery::pose(1.0), wedges(count)));
  const double volume = enclosed_volume(m);
  if (*rc::gen::arbitrary<bool>())
    turn(m.triangles[*rc::gen::inRange<std::size_t>(0, m.triangles.size())]);
  std::string refusal;
  RC_ASSERT(split_non_manifold(m, refusal) == static_cast<std::size_t>(2 * (count - 1)));
  RC_ASSERT(refusal.empty());
  RC_ASSERT(orient_facets(m, refusal) <= 1u);
  RC_ASSERT(check_closed(m).empty());
  const auto pieces = connected_pieces(m.triangles);
  RC_ASSERT(pieces.size() == static_cast<std::size_t>(count));
  for (const auto& piece : pieces)
    RC_ASSERT(std::abs(enclosed_volume(submesh(m, piece)) - volume / count) < 1e-12);
}

/// Nor does it matter which corner is the origin, in any order of the facets.
RC_GTEST_PROP(SplitNonManifold, parts_wedges_around_any_origin, ()) {
  const TriangleMesh three = wedges(3);
  const Vec3 origin = *rc::gen::elementOf(three.positions);
  TriangleMesh m = shuffled(battery::placed({Mat3::Identity(), -origin}, three));
  std::string refusal;
  RC_ASSERT(split_non_manifold(m, refusal) == 4u);
  RC_ASSERT(check_closed(m).empty());
  for (const auto& piece : connected_pieces(m.triangles))
    RC_ASSERT(std::abs(enclosed_volume(submesh(m, piece)) - enclosed_volume(m) / 3.0) < 1e-15);
}

/// What is refused changed nothing.
TEST(SplitNonManifold, rejects_three_facets_at_an_edge_and_counts_nothing) {
  TriangleMesh m;
  m.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  m.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  std::string refusal;
  EXPECT_EQ(split_non_manifold(m, refusal), 0u);
  EXPECT_EQ(refusal,
            "3 facets meet at an edge of triangle 0 at (0.0000, 0.0000, 500.0000) mm: which of "
            "them bound the solid is unknown");
  EXPECT_EQ(m.positions.size(), 5u);
}

/// Solids that touch at a corner alone.
TEST(SplitNonManifold, gives_fans_that_touch_a_vertex_each) {
  const TriangleMesh two = merged(
      {{"a", battery::box({0, 0, 0}, {1, 1, 1})}, {"b", battery::box({1, 1, 1}, {2, 2, 2})}});
  TriangleMesh m{two.positions, merge_equal_vertices(two)};
  drop_unused_points(m);
  ASSERT_EQ(m.positions.size(), 15u);
  std::string refusal;
  EXPECT_EQ(split_non_manifold(m, refusal), 1u);
  EXPECT_EQ(m.positions.size(), 16u);
  EXPECT_TRUE(check_closed(m).empty());
}

/// Fewer than half of each piece's facets are turned: only those come back.
RC_GTEST_PROP(OrientFacets, follows_the_majority_of_every_piece, ()) {
  const TriangleMesh sound =
      shuffled(merged({{"a", battery::sphere(1.0, 0)},
                       {"b", battery::placed({Mat3::Identity(), Vec3(3, 0, 0)},
                                             battery::box({0, 0, 0}, {1, 1, 1}))}}));
  TriangleMesh m = sound;
  std::size_t turned = 0;
  for (const auto& piece : connected_pieces(m.triangles)) {
    const int most = (static_cast<int>(piece.size()) - 1) / 2;
    const int n = *rc::gen::element(0, 1, most);
    for (int k = 0; k < n; ++k) turn(m.triangles[at(piece[at(2 * k)])]);
    turned += at(n);
  }
  std::string refusal;
  RC_ASSERT(orient_facets(m, refusal) == turned);
  RC_ASSERT(refusal.empty());
  RC_ASSERT(m.triangles == sound.triangles);
}

/// Where as many face one way as the other, the first facet decides.
TEST(OrientFacets, of_a_tie_leaves_the_first_as_it_is) {
  TriangleMesh m = battery::box({0, 0, 0}, {1, 1, 1});
  const TriangleMesh sound = m;
  for (std::size_t i = 6; i < 12; ++i) turn(m.triangles[i]);
  std::string refusal;
  EXPECT_EQ(orient_facets(m, refusal), 6u);
  EXPECT_EQ(m.triangles, sound.triangles);
}

/// Facets of a sphere that share no corner leave a hole each.
RC_GTEST_PROP(FillHoles, closes_and_counts_every_loop, ()) {
  TriangleMesh m = battery::sphere(1.0, 2);
  const double volume = enclosed_volume(m);
  std::vector<char> taken(m.positions.size(), 0);
  std::size_t holes = 0;
  for (int k = *battery::integer(1, 6); k > 0; --k) {
    const std::size_t i = *rc::gen::inRange<std::size_t>(0, m.triangles.size());
    const Triangle t = m.triangles[i];
    if (std::ranges::any_of(t, [&](int v) { return taken[at(v)] != 0; })) continue;
    for (const int v : t) taken[at(v)] = 1;
    m.triangles.erase(m.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    ++holes;
  }
  std::string refusal;
  RC_ASSERT(fill_holes(m, refusal) == holes);
  RC_ASSERT(refusal.empty());
  RC_ASSERT(check_closed(m).empty());
  RC_ASSERT(std::abs(enclosed_volume(m) - volume) < 1e-12);
}

}  // namespace tdbd::mesh::repair_facets_test
