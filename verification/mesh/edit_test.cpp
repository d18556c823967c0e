#include "mesh/edit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mesh/check/check.hpp"
#include "reference/mesh/exact_rational.hpp"
#include "verification/battery/rock_surfaces.hpp"

namespace tdbd::mesh::edit_test {

Surface random_sheet() {
  const int n = *rc::gen::inRange(2, 6);
  return make_surface(battery::bumpy_rock(1.0, n, 0.3, *rc::gen::arbitrary<std::uint64_t>()));
}

/// Corners of living triangles that face an interior edge.
std::vector<int> interior_corners(const Surface& s) {
  std::vector<int> corners;
  for (int c = 0; c < 3 * s.triangle_slots(); ++c)
    if (s.triangle_is_alive(c / 3) && s.opposite_of(c) >= 0) corners.push_back(c);
  return corners;
}

/// What is wrong with the sheet as a topological disc. Edits ignore shape.
std::string topological_defects(const TriangleMesh& m) {
  std::vector<Defect> defects = check_surface(m);
  std::erase_if(defects,
                [](const Defect& d) { return d.kind == Defect::Kind::degenerate_triangle; });
  return describe(defects);
}

/// The boundary loop: from each vertex to the next, with positions.
std::map<int, std::pair<int, std::vector<double>>> boundary_loop(const Surface& s) {
  std::map<int, std::pair<int, std::vector<double>>> loop;
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (!s.triangle_is_alive(c / 3) || s.opposite_of(c) >= 0) continue;
    const int v = s.vertex(next_corner(c));
    const Vec3& x = s.position(v);
    loop[v] = {s.vertex(previous_corner(c)), {x.x(), x.y(), x.z()}};
  }
  return loop;
}

/// One random edit; returns the number of vertices that it added. Collapses that would break the
/// topology or take a boundary vertex are not made.
int random_edit(Surface& s, int choice) {
  const std::vector<int> corners = interior_corners(s);
  const int c = corners[(choice / 6) % corners.size()];
  const Vec3 &a = s.position(s.vertex(next_corner(c))),
             &b = s.position(s.vertex(previous_corner(c)));
  const double fraction = 0.25 * (1 + choice % 3);
  if (choice % 2 == 0) {
    split_edge(s, c, (1.0 - fraction) * a + fraction * b);
    return 1;
  }
  if (!collapse_keeps_topology(s, c)) return 0;
  const bool stays = s.is_boundary(s.vertex(next_corner(c)));
  collapse_edge(s, c, stays ? a : Vec3((1.0 - fraction) * a + fraction * b));
  return -1;
}

RC_GTEST_PROP(Edit, any_sequence_leaves_a_disc_with_the_same_boundary, ()) {
  Surface s = random_sheet();
  const auto loop = boundary_loop(s);
  const auto choices = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20));
  for (const int choice : choices) {
    const int vertices = s.vertex_count(), triangles = s.triangle_count();
    const int added = random_edit(s, choice);
    RC_ASSERT(s.vertex_count() == vertices + added);
    RC_ASSERT(s.triangle_count() ==
              triangles + 2 * added);  // so the Euler characteristic is unchanged
    RC_ASSERT(adjacency_is_consistent(s));
    RC_ASSERT(topological_defects(compact(s)) == "");
  }
  RC_ASSERT(boundary_loop(s) == loop);
}

RC_GTEST_PROP(Edit, dead_slots_are_reused, ()) {
  Surface s = random_sheet();
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20))) {
    const int dead_vertices = static_cast<int>(s.free_vertices.size());
    const int slots = s.vertex_slots();
    const int added = random_edit(s, choice);
    RC_ASSERT(s.vertex_slots() == slots + (added == 1 && dead_vertices == 0 ? 1 : 0));
  }
  for (const int v : s.free_vertices) RC_ASSERT(!s.is_alive(v));
  for (const int t : s.free_triangles) RC_ASSERT(!s.triangle_is_alive(t));
}

RC_GTEST_PROP(Edit, a_surface_survives_compaction_after_edits, ()) {
  Surface s = random_sheet();
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20)))
    random_edit(s, choice);
  std::vector<int> slot_of_vertex;
  const TriangleMesh m = compact(s, &slot_of_vertex);
  RC_ASSERT(static_cast<int>(m.positions.size()) == s.vertex_count());
  RC_ASSERT(static_cast<int>(m.triangles.size()) == s.triangle_count());
  RC_ASSERT(compact(make_surface(m)).triangles == m.triangles);
  for (std::size_t i = 0; i < slot_of_vertex.size(); ++i)
    RC_ASSERT(m.positions[i] == s.position(slot_of_vertex[i]));
}

/// Coordinates are multiples of 2^-20: their midpoints are exact, and so is the comparison.
RC_GTEST_PROP(SplitEdge, at_a_point_of_the_edge_changes_no_volume_at_all, ()) {
  Surface s = random_sheet();
  for (VertexStar& star : s.stars) star.x = (star.x * 0x1p20).array().round().matrix() * 0x1p-20;
  const reference::Rational before = reference::signed_volume_rational(compact(s));
  for (const int choice : *rc::gen::container<std::vector<int>>(8, rc::gen::inRange(0, 1 << 20))) {
    const std::vector<int> corners = interior_corners(s);
    const int c = corners[choice % corners.size()];
    const Vec3 a = s.position(s.vertex(next_corner(c))),
               b = s.position(s.vertex(previous_corner(c)));
    const int m = split_edge(s, c, 0.5 * (a + b));
    RC_ASSERT(s.position(m) == Vec3(0.5 * (a + b)));
  }
  RC_ASSERT(reference::signed_volume_rational(compact(s)) == before);
}

/// The collapse on plain triangles: b becomes a, triangles that lost a corner are dropped.
TriangleMesh collapsed_by_renaming(const TriangleMesh& m, int a, int b) {
  TriangleMesh result;
  std::vector<int> renumbered;
  for (int v = 0; v < static_cast<int>(m.positions.size()); ++v) {
    renumbered.push_back(static_cast<int>(result.positions.size()));
    if (v != b) result.positions.push_back(m.positions[v]);
  }
  for (Triangle t : m.triangles) {
    for (int& v : t) v = renumbered[v == b ? a : v];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) result.triangles.push_back(t);
  }
  return result;
}

RC_GTEST_PROP(CollapseKeepsTopology, is_right_about_every_edge, ()) {
  Surface s = random_sheet();
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20)))
    random_edit(s, choice);
  const TriangleMesh m = compact(s);
  s = make_surface(m);
  int allowed = 0;
  for (const int c : interior_corners(s)) {
    const int a = s.vertex(next_corner(c)), b = s.vertex(previous_corner(c));
    const bool a_disc =
        !s.is_boundary(b) && topological_defects(collapsed_by_renaming(m, a, b)).empty();
    RC_ASSERT(collapse_keeps_topology(s, c) == a_disc);
    allowed += a_disc;
  }
  RC_TAG(allowed > 0 ? "some allowed" : "none allowed");
}

TEST(CollapseKeepsTopology, rejects_a_boundary_edge_and_a_boundary_vertex_that_would_go) {
  const Surface s = make_surface(battery::bumpy_rock(1.0, 2, 0.0, 3));
  for (int c = 0; c < 3 * s.triangle_slots(); ++c)
    if (s.opposite_of(c) < 0 || s.is_boundary(s.vertex(previous_corner(c)))) {
      EXPECT_FALSE(collapse_keeps_topology(s, c));
    }
}

/// The flip on plain triangles.
TriangleMesh flipped_by_renaming(const TriangleMesh& m, int c, int o) {
  TriangleMesh result = m;
  const Triangle t = m.triangles[c / 3], u = m.triangles[o / 3];
  const int p = t[c % 3], a = t[(c + 1) % 3], b = t[(c + 2) % 3], q = u[o % 3];
  result.triangles[c / 3] = {p, a, q};
  result.triangles[o / 3] = {q, b, p};
  return result;
}

/// The same triangles, each rotated to start at its smallest vertex, sorted.
std::set<Triangle> as_set(const TriangleMesh& m) {
  std::set<Triangle> all;
  for (Triangle t : m.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    all.insert(t);
  }
  return all;
}

RC_GTEST_PROP(FlipEdge, is_right_about_every_edge, ()) {
  Surface s = random_sheet();
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20)))
    random_edit(s, choice);
  const TriangleMesh m = compact(s);
  s = make_surface(m);
  for (const int c : interior_corners(s)) {
    const TriangleMesh expected = flipped_by_renaming(m, c, s.opposite_of(c));
    RC_ASSERT(flip_keeps_topology(s, c) == topological_defects(expected).empty());
    if (!flip_keeps_topology(s, c)) continue;
    Surface flipped = s;
    flip_edge(flipped, c);
    RC_ASSERT(adjacency_is_consistent(flipped));
    RC_ASSERT(as_set(compact(flipped)) == as_set(expected));
    RC_ASSERT(flipped.boundary == s.boundary);
  }
}

/// Four flips of one edge, each at the edge that the last one made, turn it once around.
RC_GTEST_PROP(FlipEdge, four_times_gives_the_same_triangles, ()) {
  const Surface s = random_sheet();
  for (const int c : interior_corners(s)) {
    if (!flip_keeps_topology(s, c)) continue;
    Surface flipped = s;
    for (int k = 0, at = c; k < 4; ++k, at = next_corner(at)) flip_edge(flipped, at);
    RC_ASSERT(as_set(compact(flipped)) == as_set(compact(s)));
  }
}

TEST(FlipKeepsTopology, rejects_a_boundary_edge) {
  const Surface s = make_surface(battery::bumpy_rock(1.0, 2, 0.0, 3));
  for (int c = 0; c < 3 * s.triangle_slots(); ++c)
    if (s.opposite_of(c) < 0) {
      EXPECT_FALSE(flip_keeps_topology(s, c));
    }
}

/// The one vertex that an edit took; -1 if it took none, -2 if it took several.
int gone_of(const std::vector<int>& before, const Surface& after) {
  int gone = -1;
  for (const int v : before)
    if (!after.is_alive(v)) gone = gone == -1 ? v : -2;
  return gone;
}

/// Two triangles at an edge: either may go, whichever corner of the other faces it.
TEST(RemovalKeepsDisc, of_an_ear_at_any_corner) {
  for (int first = 0; first < 3; ++first)
    for (int second = 0; second < 3; ++second) {
      TriangleMesh m;
      m.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
      const Triangle a{0, 1, 2}, b{0, 2, 3};
      m.triangles = {{a[at(first)], a[at((first + 1) % 3)], a[at((first + 2) % 3)]},
                     {b[at(second)], b[at((second + 1) % 3)], b[at((second + 2) % 3)]}};
      const Surface s = make_surface(m);
      for (const int t : {0, 1}) EXPECT_TRUE(removal_keeps_disc(s, t)) << first << second << t;
    }
}

/// A sheet loses triangles at its boundary, one after the other, until none may go.
RC_GTEST_PROP(RemoveTriangle, keeps_a_disc_and_names_the_vertex_that_went, ()) {
  Surface s = random_sheet();
  for (int left = s.triangle_slots(); left > 1; --left) {
    std::vector<int> triangles, vertices;
    for (int t = 0; t < s.triangle_slots(); ++t)
      if (s.triangle_is_alive(t) && removal_keeps_disc(s, t)) triangles.push_back(t);
    for (int v = 0; v < s.vertex_slots(); ++v)
      if (s.is_alive(v)) vertices.push_back(v);
    RC_ASSERT(!triangles.empty());
    const int t = triangles[*rc::gen::inRange<std::size_t>(0, triangles.size())];
    const int named = remove_triangle(s, t);
    RC_ASSERT(!s.triangle_is_alive(t));
    RC_ASSERT(named == gone_of(vertices, s));
    RC_ASSERT(adjacency_is_consistent(s));
    RC_ASSERT(topological_defects(compact(s)) == "");
  }
}

}  // namespace tdbd::mesh::edit_test
