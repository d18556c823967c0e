#include "reference/rock/facet_walk.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "rock/cut/swept_mesh.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::facet_walk_test {

using mesh::TriangleMesh;
using rock::RelativePath;

constexpr double depth = 1e-12;

using mesh::Facet;
using mesh::TriangleTree;

bool has(const Facet& f, const Vec3& x) { return f.a == x || f.b == x || f.c == x; }

/// By comparing every facet with every other one.
int across_by_hand(const std::vector<Facet>& facets, std::size_t i, const Vec3& p, const Vec3& q) {
  int found = -1, count = 0;
  for (std::size_t k = 0; k < facets.size(); ++k)
    if (k != i && has(facets[k], p) && has(facets[k], q)) {
      found = static_cast<int>(k);
      ++count;
    }
  return count == 1 ? found : -1;
}

/// Some facets are missing, and one is there twice: beyond its edges there is no one neighbour.
RC_GTEST_PROP(FacetNeighbours, are_the_only_others_with_the_same_edge, ()) {
  mesh::TriangleMesh m = *battery::star_shape();
  for (int k = *battery::integer(0, 20); k > 0; --k)
    m.triangles.erase(
        m.triangles.begin() +
        *rc::gen::inRange<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(m.triangles.size())));
  if (*rc::gen::arbitrary<bool>()) m.triangles.push_back(m.triangles.front());
  const TriangleTree tree(m);
  const std::vector<Facet>& facets = tree.facets();
  const FacetNeighbours across = neighbours_of(tree);
  RC_ASSERT(across.size() == facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const Facet& f = facets[i];
    RC_ASSERT(across[i][0] == across_by_hand(facets, i, f.a, f.b));
    RC_ASSERT(across[i][1] == across_by_hand(facets, i, f.b, f.c));
    RC_ASSERT(across[i][2] == across_by_hand(facets, i, f.c, f.a));
  }
}

/// A line through a place in the unit cube; some run along axes, where a division by 0 lurks.
struct Line {
  Vec3 x, u;
};

Line any_line() {
  const Vec3 x = *battery::point(1.2);
  Vec3 u = *battery::direction();
  if (*rc::gen::arbitrary<bool>()) u[*battery::integer(0, 2)] = 0.0;
  if (u.norm() == 0.0) u = Vec3::UnitY();
  return {x, u};
}

/// Of all facets, one after the other, those that the line meets at t > 0.
std::vector<FacetHit> hits_by_hand(const TriangleTree& tree, const Line& l) {
  std::vector<FacetHit> hits;
  for (std::size_t i = 0; i < tree.facets().size(); ++i) {
    const auto hit = mesh::meet(tree.facets()[i], l.x, l.u);
    if (hit && std::abs(hit->margin) < 1e-9) RC_DISCARD("through a rim");
    if (hit && hit->margin > 0.0 && hit->s > 0.0) hits.push_back({static_cast<int>(i), hit->s});
  }
  std::ranges::sort(hits, {}, &FacetHit::t);
  return hits;
}

RC_GTEST_PROP(FirstFacet, is_the_nearest_of_all_facets_on_the_line, ()) {
  const TriangleTree tree(*rc::gen::oneOf(battery::star_shape(), battery::nonconvex_prism()));
  const Line l = any_line();
  const auto hits = hits_by_hand(tree, l);
  const auto first = first_facet(tree, l.x, l.u);
  RC_TAG(hits.empty() ? "missed" : "met");
  RC_ASSERT(first.has_value() == !hits.empty());
  if (!first) return;
  RC_ASSERT(first->facet == hits.front().facet);
  RC_ASSERT(first->t == hits.front().t);
}

/// From a place inside a convex part there is one way out, wherever the walk begins.
RC_GTEST_PROP(WalkToExit, finds_the_way_out_of_a_convex_part_from_any_facet, ()) {
  const TriangleTree tree(*battery::convex_polyhedron());
  Line l = any_line();
  while (!mesh::inside(tree, l.x)) l.x *= 0.5;  // the origin is inside
  const auto hits = hits_by_hand(tree, l);
  RC_ASSERT(hits.size() == 1u);
  const FacetNeighbours across = neighbours_of(tree);
  int found = 0;
  for (std::size_t i = 0; i < tree.facets().size(); ++i) {
    int facet = static_cast<int>(i);
    long tested = 0;
    const auto t = walk_to_exit(tree, across, l.x, l.u, facet, tested);
    RC_ASSERT(tested >= 1);
    RC_ASSERT(!t || (tested == 1) == (facet == static_cast<int>(i)));
    if (!t) {  // it came to the side where the line would enter
      RC_ASSERT(facet == static_cast<int>(i));
      continue;
    }
    ++found;
    RC_ASSERT(facet == hits.front().facet);
    RC_ASSERT(*t == hits.front().t);
  }
  RC_ASSERT(found >= 1);  // from the facet itself, at least
}

/// Whatever the part: where a walk ends well, the line goes outwards there, and ahead.
RC_GTEST_PROP(WalkToExit, ends_where_the_line_leaves, ()) {
  const TriangleTree tree(*rc::gen::oneOf(battery::star_shape(), battery::nonconvex_prism()));
  const Line l = any_line();
  const auto hits = hits_by_hand(tree, l);
  const FacetNeighbours across = neighbours_of(tree);
  int facet = *rc::gen::inRange(0, static_cast<int>(tree.facets().size()));
  long tested = 0;
  const auto t = walk_to_exit(tree, across, l.x, l.u, facet, tested);
  RC_TAG(t ? "found" : "not found");
  if (!t) return;
  RC_ASSERT(
      std::ranges::any_of(hits, [&](const FacetHit& h) { return h.facet == facet && h.t == *t; }));
  const Facet& f = tree.facets()[at(facet)];
  RC_ASSERT((f.b - f.a).cross(f.c - f.a).dot(l.u) > 0.0);
}

TEST(WalkToExit, ends_at_an_edge_without_a_neighbour) {
  mesh::TriangleMesh m = battery::box({-1, -1, -1}, {1, 1, 1});
  std::erase_if(m.triangles, [&](const mesh::Triangle& t) {
    return std::ranges::all_of(t, [&](int v) { return m.positions[at(v)].z() > 0.0; });
  });
  const TriangleTree tree(m);
  int facet = 0;
  long tested = 0;
  EXPECT_FALSE(
      walk_to_exit(tree, neighbours_of(tree), {0.1, 0.2, 0}, {0.01, 0.02, 1}, facet, tested));
  EXPECT_EQ(facet, 0);
}

/// A way within a cube of half edge `way`, and a direction that turns by about `turn` on it.
RelativePath any_path(double way, double turn) {
  RelativePath p;
  p.q0_P = *battery::point(0.7);
  p.q1_P = p.q0_P + *battery::point(way);
  p.u0_P = *battery::direction();
  p.u1_P = (p.u0_P + turn * *battery::point(1.0)).normalized();
  return p;
}

/// Bitwise identical from the facet that the last query used, for any part and any depth of a
/// vertex.
void expect_walk_finds_the_same(const TriangleMesh& part, double way, double turn) {
  const double deep = *rc::gen::element(depth, 0.02, 0.1);
  const TriangleTree tree(part);
  const FacetNeighbours across = neighbours_of(tree);
  WalkScratch walking;
  rock::MeshScratch searching;
  for (int k = 0; k < 10; ++k) {
    const RelativePath p = any_path(way, turn);
    const auto t = exit_distance_by_walk(tree, across, p, deep, walking);
    RC_ASSERT(t == exit_distance(tree, p, deep, searching));
    RC_TAG(t ? "swept" : "missed");
  }
}

RC_GTEST_PROP(ExitByWalk, is_the_exit_from_any_prism, ()) {
  expect_walk_finds_the_same(*battery::nonconvex_prism(), 0.1, 0.05);
}

RC_GTEST_PROP(ExitByWalk, is_the_exit_from_any_star, ()) {
  expect_walk_finds_the_same(*battery::star_shape(), 0.1, 0.05);
}

/// Neighbouring vertices on a torus, as rock meets it: small steps, a direction that rests.
TEST(ExitByWalk, mostly_needs_no_tree_around_a_torus) {
  const TriangleMesh part = battery::torus(1.0, 0.3, 64, 32);
  const TriangleTree tree(part);
  const FacetNeighbours across = neighbours_of(tree);
  for (const auto& facets : across)
    for (const int f : facets) ASSERT_GE(f, 0);
  WalkScratch walking;
  rock::MeshScratch searching;
  long swept = 0, found = 0;
  for (int k = 0; k < 2000; ++k) {
    const double a = 1e-3 * k, r = 1.0 + 0.2 * std::sin(37.0 * a);
    const Vec3 x(r * std::cos(a), r * std::sin(a), 0.27 - 0.05 * std::cos(11.0 * a));
    const RelativePath p{x, x + Vec3(0, 1e-3, -1e-3), Vec3(0, 0, 1), Vec3(0, 0, 1)};
    const long before = walking.walk.found;
    const auto t = exit_distance_by_walk(tree, across, p, depth, walking);
    ASSERT_EQ(t, exit_distance(tree, p, depth, searching)) << k;
    if (!t) continue;
    ++swept;
    found += walking.walk.found - before;
  }
  std::printf("walks found the way out of %ld of %ld swept vertices\n", found, swept);
  EXPECT_GT(swept, 500);
  EXPECT_GT(found, 9 * swept / 10);
  EXPECT_GT(walking.walk.answered,
            9 * swept / 10);  // by the facets near it, without the whole search
}

}  // namespace tdbd::reference::facet_walk_test
