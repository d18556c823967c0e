#include "mesh/surface.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "mesh/example_meshes.hpp"
#include "reference/mesh/exact_volume.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"

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

TEST(Surface, refuses_an_edge_of_three_triangles_and_names_it) {
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

TEST(Surface, refuses_a_flipped_triangle_and_names_its_edge) {
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

/// Two triangles that run the same way along their common edge, every table as they ask: only the surface is wrong.
TEST(AdjacencyIsConsistent, notices_what_is_no_manifold) {
  Surface s = make_surface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}});
  ASSERT_TRUE(adjacency_is_consistent(s));
  std::swap(s.triangles[1][0], s.triangles[1][1]);
  s.corner_of = {0, 1, 2, 5};
  refresh_stars(s);
  EXPECT_FALSE(adjacency_is_consistent(s));
}

}  // namespace tdbd::mesh::surface_test
