#include "mesh/surface.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/error.hpp"
#include "mesh/edit.hpp"
#include "mesh/example_meshes.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/exact_volume.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/mesh/random_edit.hpp"

namespace tdbd::mesh::surface_test {

/// Open or closed, smooth or rough: every kind of surface that adjacency must handle.
rc::Gen<TriangleMesh> any_surface() {
  const auto sheet = rc::gen::apply(
      [](int n, std::uint64_t seed) { return battery::bumpy_rock(1.0, n, 0.3, seed); },
      rc::gen::inRange(1, 7), rc::gen::arbitrary<std::uint64_t>());
  return rc::gen::oneOf(sheet, battery::convex_polyhedron(), battery::star_shape());
}

int vertex_of(const TriangleMesh& m, int c) { return m.triangles[c / 3][c % 3]; }

/// The corner that faces the edge from a to b, among all corners; -1 if there is none.
int facing_by_search(const TriangleMesh& m, int a, int b) {
  for (int c = 0; c < 3 * static_cast<int>(m.triangles.size()); ++c)
    if (vertex_of(m, next_corner(c)) == a && vertex_of(m, previous_corner(c)) == b) return c;
  return -1;
}

RC_GTEST_PROP(Surface, opposite_corners_equal_a_search_of_all, ()) {
  const TriangleMesh m = *any_surface();
  const Surface s = make_surface(m);
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    const int a = s.vertex(next_corner(c)), b = s.vertex(previous_corner(c));
    RC_ASSERT(s.opposite_of(c) == facing_by_search(m, b, a));
    RC_ASSERT(corner_facing(s, a, b) == c);
  }
  RC_ASSERT(adjacency_is_consistent(s));
}

RC_GTEST_PROP(Surface, boundary_vertices_are_those_of_edges_with_one_triangle, ()) {
  const TriangleMesh m = *any_surface();
  const Surface s = make_surface(m);
  std::vector<bool> open(m.positions.size(), false);
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    const int a = vertex_of(m, next_corner(c)), b = vertex_of(m, previous_corner(c));
    if (facing_by_search(m, b, a) < 0) open[a] = open[b] = true;
  }
  for (int v = 0; v < s.vertex_slots(); ++v) RC_ASSERT(s.is_boundary(v) == open[v]);
}

RC_GTEST_PROP(Surface, visit_corners_meets_every_corner_of_a_vertex_once, ()) {
  const TriangleMesh m = *any_surface();
  const Surface s = make_surface(m);
  std::vector<int> visits(3 * m.triangles.size(), 0);
  for (int v = 0; v < s.vertex_slots(); ++v)
    visit_corners(s, v, [&](int c) {
      RC_ASSERT(s.vertex(c) == v);
      ++visits[c];
    });
  for (const int n : visits) RC_ASSERT(n == 1);
}

TEST(Surface, rejects_an_edge_of_three_triangles_and_names_it) {
  const TriangleMesh m{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                       {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  try {
    make_surface(m);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("vertex 0 at (0.000, 0.000, 0.000) mm"), what.npos) << what;
    EXPECT_NE(what.find("vertex 1 at (1000.000, 0.000, 0.000) mm"), what.npos) << what;
    EXPECT_NE(what.find("3 triangles"), what.npos) << what;
  }
}

TEST(Surface, rejects_a_flipped_triangle_and_names_its_edge) {
  TriangleMesh m = square_sheet(2);
  std::swap(m.triangles[3][0], m.triangles[3][1]);
  try {
    make_surface(m);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("orientation"), what.npos) << what;
    EXPECT_NE(what.find("vertex 1 at"), what.npos) << what;
  }
}

RC_GTEST_PROP(Surface, compact_returns_what_make_surface_was_given, ()) {
  TriangleMesh m = *any_surface();
  const int lonely = static_cast<int>(m.positions.size());
  m.positions.push_back(Vec3(7, 7, 7));  // unused: left out
  std::vector<int> slot_of_vertex;
  const TriangleMesh back = compact(make_surface(m), &slot_of_vertex);
  RC_ASSERT(back.triangles == m.triangles);
  RC_ASSERT(static_cast<int>(back.positions.size()) == lonely);
  for (int v = 0; v < lonely; ++v) {
    RC_ASSERT(slot_of_vertex[v] == v);
    RC_ASSERT(back.positions[v] == m.positions[v]);
  }
}

/// Rough sheets whose inner vertices move, as cutting moves rock. Scale: the volume of
/// the cube over the square.
RC_GTEST_PROP(Surface, differences_of_hole_volume_are_the_rock_between, ()) {
  const int n = *rc::gen::inRange(1, 12);
  const auto seeds = *rc::gen::pair(rc::gen::arbitrary<std::uint64_t>(), rc::gen::arbitrary<int>());
  const TriangleMesh before = battery::bumpy_rock(1.0, n, 0.4, seeds.first);
  TriangleMesh after = before;
  after.positions = battery::bumpy_rock(1.0, n, 0.4, seeds.second).positions;
  const double exact = reference::removed_volume_exact(before, after);
  constexpr double cube = 8.0, rounding = 1e-15;
  for (const Vec3& origin_W : {Vec3(0, 0, 0), Vec3(1, -2, 0.5)}) {
    const double gained =
        hole_volume(make_surface(after), origin_W) - hole_volume(make_surface(before), origin_W);
    RC_ASSERT(std::abs(gained - exact) < 10.0 * rounding * cube);
  }
}

/// The middle vertex of a flat square goes down: a pyramid of base 4 (whatever the diagonals, if it
/// is joined to all corners; less if not).
TEST(Surface, hole_volume_grows_when_rock_goes) {
  TriangleMesh m = battery::bumpy_rock(1.0, 2, 0.0, 1);
  const double before = hole_volume(make_surface(m), Vec3::Zero());
  m.positions[4].z() += 0.3;
  const double gained = hole_volume(make_surface(m), Vec3::Zero()) - before;
  EXPECT_GE(gained, 0.3 * 2.0 / 3.0);
  EXPECT_LE(gained, 0.3 * 4.0 / 3.0 + 1e-15);
}

RC_GTEST_PROP(AdjacencyIsConsistent, notices_any_wrong_entry, ()) {
  Surface s = make_surface(*any_surface());
  const int corner = *rc::gen::inRange(0, 3 * s.triangle_slots());
  const int vertex = *rc::gen::inRange(0, s.vertex_slots());
  Surface wrong = s;
  wrong.opposite[corner] = wrong.opposite[corner] < 0 ? 0 : -1;
  RC_ASSERT(!adjacency_is_consistent(wrong));
  wrong = s;
  wrong.boundary[vertex] ^= 1;
  RC_ASSERT(!adjacency_is_consistent(wrong));
  wrong = s;
  wrong.corner_of[vertex] = next_corner(wrong.corner_of[vertex]);
  RC_ASSERT(!adjacency_is_consistent(wrong));
  wrong = s;  // turned over: no manifold with its neighbours
  std::swap(wrong.triangles[corner / 3][0], wrong.triangles[corner / 3][1]);
  RC_ASSERT(!adjacency_is_consistent(wrong));
}

/// Two triangles that run the same way along their common edge, with tables that agree with this:
/// only the surface is wrong.
TEST(AdjacencyIsConsistent, notices_what_is_no_manifold) {
  Surface s = make_surface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}});
  ASSERT_TRUE(adjacency_is_consistent(s));
  std::swap(s.triangles[1][0], s.triangles[1][1]);
  s.corner_of = {0, 1, 2, 5};
  refresh_stars(s);
  EXPECT_FALSE(adjacency_is_consistent(s));
}

TEST(Measures, quality_is_one_for_equilateral_and_zero_for_degenerate) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0.5, std::sqrt(0.75), 0);
  EXPECT_NEAR(triangle_quality(a, b, c), 1.0, 1e-15);
  EXPECT_EQ(triangle_quality(a, b, Vec3(0.3, 0, 0)), 0.0);
  EXPECT_EQ(triangle_quality(a, a, a), 0.0);
}

TEST(Measures, volume_of_a_tetrahedron_far_from_the_origin_is_exact) {
  TriangleMesh m{{{8, 8, 8}, {9, 8, 8}, {8, 9, 8}, {8, 8, 9}},
                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  EXPECT_DOUBLE_EQ(enclosed_volume(m), 1.0 / 6.0);
  EXPECT_NEAR(area(m), 1.5 + std::sqrt(3.0) / 2.0, 1e-15);
}

/// A fan of thinner and thinner triangles about the origin.
TEST(Measures, quality_figures_are_the_worst_and_the_one_that_99_percent_exceed) {
  TriangleMesh m;
  m.positions.push_back(Vec3::Zero());
  double angle = 0.0;
  for (int i = 0; i <= 250; ++i) {
    m.positions.push_back(Vec3(std::cos(angle), std::sin(angle), 0.0));
    angle += 0.02 / (i + 1);
    if (i > 0) m.triangles.push_back({0, i, i + 1});
  }
  std::vector<double> q;
  for (const auto& [a, b, c] : m.triangles)
    q.push_back(triangle_quality(m.positions[at(a)], m.positions[at(b)], m.positions[at(c)]));
  const QualityStatistics found = quality_statistics(m),
                          of_surface = quality_statistics(make_surface(m));
  EXPECT_EQ(found.least, q.back());
  EXPECT_EQ(found.one_percent, q[q.size() - 3]);
  EXPECT_EQ(of_surface.least, found.least);
  EXPECT_EQ(of_surface.one_percent, found.one_percent);
  EXPECT_EQ(quality_statistics(TriangleMesh{}).least, 0.0);
}

auto key(const Side& s) { return std::tuple(s.lo, s.hi, s.corner, s.triangle, s.forward); }

/// Any triangles, dead ones among them: few vertices, so that many sides share an edge.
std::vector<Triangle> some_triangles() {
  std::vector<Triangle> triangles;
  const int n = *rc::gen::inRange(0, 40), vertices = *rc::gen::inRange(3, 30);
  for (int i = 0; i < n; ++i) {
    const auto any = [&] { return *rc::gen::inRange(0, vertices); };
    triangles.push_back(*rc::gen::inRange(0, 5) == 0 ? Triangle{-1, any(), any()}
                                                     : Triangle{any(), any(), any()});
  }
  return triangles;
}

RC_GTEST_PROP(SortedSides, are_all_sides_of_the_living_by_edge_and_corner, ()) {
  const std::vector<Triangle> triangles = some_triangles();
  std::vector<std::tuple<int, int, int, int, bool>> expected;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int i = 0; i < 3 && triangles[at(t)][0] >= 0; ++i) {
      const int from = triangles[at(t)][at((i + 1) % 3)], to = triangles[at(t)][at((i + 2) % 3)];
      expected.emplace_back(std::min(from, to), std::max(from, to), 3 * t + i, t, from < to);
    }
  std::ranges::sort(expected);
  const std::vector<Side> sides = sorted_sides(triangles);
  RC_ASSERT(sides.size() == expected.size());
  for (std::size_t i = 0; i < sides.size(); ++i) RC_ASSERT(key(sides[i]) == expected[i]);
}

}  // namespace tdbd::mesh::surface_test

namespace tdbd::mesh::vertex_star_test {
namespace {

/// The neighbours of v by the corner table, counter-clockwise from any of them; open rings from their beginning.
std::vector<int> ring_by_corners(const Surface& s, int v) {
  std::vector<int> after, before;
  const int start = s.corner_of[at(v)];
  int c = start, last = start;
  do {
    after.push_back(s.vertex(next_corner(c)));
    last = c;
    c = turn_left(s, c);
  } while (c >= 0 && c != start);
  if (c == start) return after;
  after.push_back(s.vertex(previous_corner(last)));
  for (c = turn_right(s, start); c >= 0; c = turn_right(s, c))
    before.push_back(s.vertex(next_corner(c)));
  std::ranges::reverse(before);
  before.insert(before.end(), after.begin(), after.end());
  return before;
}

std::vector<int> ring_of(const Surface& s, int v) {
  const VertexStar& star = s.star(v);
  return {s.ring(star), s.ring(star) + star.size};
}

void require_stars_of_corners(const Surface& s) {
  for (int v = 0; v < s.vertex_slots(); ++v) {
    const std::vector<int> ring = ring_of(s, v);
    RC_ASSERT(ring.empty() == !s.is_alive(v));
    if (ring.empty()) continue;
    std::vector<int> expected = ring_by_corners(s, v);
    RC_ASSERT((s.star(v).open != 0) == s.is_boundary(v));
    if (!s.is_boundary(v))
      std::rotate(expected.begin(), std::ranges::min_element(expected), expected.end());
    RC_ASSERT(ring == expected);
  }
}

}  // namespace

RC_GTEST_PROP(VertexStar, equals_the_corner_table_after_any_sequence_of_edits, ()) {
  Surface s = make_surface(battery::bumpy_rock(1.0, *rc::gen::inRange(2, 6), 0.3, 1));
  require_stars_of_corners(s);
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20))) {
    random_edit(s, choice);
    RC_ASSERT(stars_are_consistent(s));
  }
  require_stars_of_corners(s);
}

/// A fan of 70 000 triangles: more neighbours than a star holds, and than two bytes count.
TEST(VertexStar, holds_rings_of_any_length) {
  constexpr int n = 70'000;
  constexpr double pi = std::numbers::pi;
  TriangleMesh m;
  m.positions.push_back(Vec3::Zero());
  for (int i = 0; i < n; ++i)
    m.positions.push_back(Vec3(std::cos(2.0 * pi * i / n), std::sin(2.0 * pi * i / n), 0.0));
  for (int i = 0; i < n; ++i) m.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  Surface s = make_surface(m);
  std::vector<int> all(n);
  for (int i = 0; i < n; ++i) all[at(i)] = 1 + i;
  EXPECT_EQ(ring_of(s, 0), all);
  const int middle = split_edge(s, corner_facing(s, 0, 1), Vec3(0.5, 0.0, 0.0));
  EXPECT_EQ(ring_of(s, 0).size(), all.size());
  EXPECT_EQ(ring_of(s, middle).size(), 4U);
  EXPECT_TRUE(stars_are_consistent(s));
  EXPECT_EQ(s.long_rings.size(), 1U + s.free_long_rings.size());
}

TEST(VertexStar, notices_a_star_out_of_step) {
  Surface s = make_surface(battery::bumpy_rock(1.0, 4, 0.3, 1));
  EXPECT_TRUE(stars_are_consistent(s));
  std::swap(s.stars[12].ring[0], s.stars[12].ring[1]);
  EXPECT_FALSE(stars_are_consistent(s));
}

}  // namespace tdbd::mesh::vertex_star_test
