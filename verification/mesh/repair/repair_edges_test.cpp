#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "mesh/check/check.hpp"
#include "mesh/check/divide.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/check/topology.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::repair_edges_test {

/// The same facets in any order, each beginning with any corner.
TriangleMesh shuffled(TriangleMesh m) {
  for (std::size_t i = m.triangles.size(); i > 1; --i)
    std::swap(m.triangles[i - 1], m.triangles[*rc::gen::inRange<std::size_t>(0, i)]);
  for (Triangle& t : m.triangles)
    std::rotate(t.begin(), t.begin() + *battery::integer(0, 2), t.end());
  return m;
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// Wedges of half the room around the z axis between 0 and 1, as many as told: their facets all meet there.
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
  TriangleMesh joined{m.positions, by_first_of_equals(m)};
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
TEST(SplitNonManifold, refuses_three_facets_at_an_edge_and_counts_nothing) {
  TriangleMesh m;
  m.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  m.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  std::string refusal;
  EXPECT_EQ(split_non_manifold(m, refusal), 0u);
  EXPECT_EQ(refusal,
            "3 facets meet at an edge of triangle 0 at (0.0000, 0.0000, 500.0000) mm: which of "
            "them bound the solid?");
  EXPECT_EQ(m.positions.size(), 5u);
}

/// Solids that touch at a corner alone.
TEST(SplitNonManifold, gives_fans_that_touch_a_vertex_each) {
  const TriangleMesh two = merged(
      {{"a", battery::box({0, 0, 0}, {1, 1, 1})}, {"b", battery::box({1, 1, 1}, {2, 2, 2})}});
  TriangleMesh m{two.positions, by_first_of_equals(two)};
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

/// Boxes in boxes, each either way round, in any order, and one beside them.
RC_GTEST_PROP(OrientPieces, turns_every_other_of_nested_pieces_inwards, ()) {
  const int depth = *battery::integer(1, 4);
  std::vector<TriangleMesh> pieces{battery::box({20, 0, 0}, {21, 1, 1})};
  double expected = 1.0;
  for (int k = 0; k < depth; ++k) {
    const double half = depth - k + 0.1 * k;
    pieces.push_back(battery::box(Vec3::Constant(-half), Vec3::Constant(half)));
    expected += (k % 2 == 0 ? 8.0 : -8.0) * half * half * half;
  }
  std::vector<Solid> all;
  std::size_t inside_out = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const bool is_turned = *rc::gen::arbitrary<bool>(), is_cavity = k > 0 && k % 2 == 0;
    if (is_turned)
      for (Triangle& t : pieces[k].triangles) turn(t);
    inside_out += is_turned != is_cavity ? 12u : 0u;
    all.insert(
        all.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(k) + 1),
        {"piece", pieces[k]});
  }
  TriangleMesh m = shuffled(merged(all));
  RC_ASSERT(orient_pieces(m) == inside_out);
  RC_ASSERT(std::abs(enclosed_volume(m) - expected) < 1e-12 * expected);
  RC_ASSERT(orient_pieces(m) == 0u);
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

}  // namespace tdbd::mesh::repair_edges_test
