#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "mesh/edit.hpp"
#include "mesh/measures.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/limits.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::check_operation_test {

constexpr int inner = 60;  // the middle of 11 x 11 vertices

/// Edges of 0.3 m, or as many times that.
Rock sheet(double size = 1.0) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.1, 7);
  for (Vec3& x_W : m.positions) x_W *= size;
  return make_rock(mesh::make_surface(m), 0.5 * size, mesh::bounding_box(m));
}

void expect_nothing_wrong_with_a_bisection(Rock rock) {
  const int c = rock.surface.corner_of[inner];
  const int a = rock.surface.vertex(mesh::next_corner(c)),
            b = rock.surface.vertex(mesh::previous_corner(c));
  const LocalState before = local_state(rock.surface, {a, b, inner});
  const int m = mesh::split_edge(rock.surface, c,
                                 0.5 * (rock.surface.position(a) + rock.surface.position(b)));
  register_vertex(rock, m, -1);
  EXPECT_EQ(describe(check_around(rock, before, 0.0)), "");
  EXPECT_NO_THROW(require_promises_around(rock, before, 0.0, "bisections"));
}

TEST(CheckOperation, finds_nothing_wrong_with_a_bisection) {
  for (const double size : {1.0, 1e-3, 1e3}) expect_nothing_wrong_with_a_bisection(sheet(size));
}

/// One of the vertices that were there before is no more.
TEST(CheckOperation, finds_nothing_wrong_with_a_collapse_but_its_volume) {
  Rock rock = sheet();
  const mesh::Surface& s = rock.surface;
  const int c = s.corner_of[inner];
  const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
  std::vector<int> around{a, b};
  for (const int v : {a, b})
    around.insert(around.end(), s.ring(s.star(v)), s.ring(s.star(v)) + s.star(v).size);
  const LocalState before = local_state(s, around);
  MaintenanceLimits limits = bare_limits_for(1.0);
  limits.volume_per_operation = limits.farthest = limits.ridge_cut = 1.0;
  SurfaceDrift drift;
  MaintenanceReport report;
  ASSERT_TRUE(try_collapse(rock, a, b, limits, around, drift, report));
  EXPECT_NE(s.is_alive(a), s.is_alive(b));
  EXPECT_EQ(describe(check_around(rock, before, report.volume_change)), "");
  EXPECT_NE(describe(check_around(rock, before, report.volume_change + 1e-6)).find("M5"),
            std::string::npos);
}

/// However small or large the triangles are.
TEST(CheckOperation, notices_volume_that_was_not_reported) {
  for (const double size : {1.0, 1e-6, 1e3}) {
    Rock rock = sheet(size);
    const LocalState before = local_state(rock.surface, {inner});
    Vec3& x_W = rock.surface.stars[inner].x;
    x_W.z() += 1e-6 * size;
    rock.grid.move(inner, x_W);
    EXPECT_NE(describe(check_around(rock, before, 0.0)).find("M5"), std::string::npos) << size;
    EXPECT_THROW(require_promises_around(rock, before, 0.0, "smoothings"), RunError);
  }
}

/// What is small is measured by the triangles around, not by how far from the origin they are.
TEST(CheckOperation, notices_a_small_volume_far_from_the_origin) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.1, 7);
  for (Vec3& x_W : m.positions) x_W += Vec3(100.0, -200.0, 300.0);
  Rock rock = make_rock(mesh::make_surface(m), 0.5, mesh::bounding_box(m));
  const LocalState before = local_state(rock.surface, {inner});
  EXPECT_LT(before.size, 0.5);
  Vec3& x_W = rock.surface.stars[inner].x;
  x_W.z() += 1e-8;
  rock.grid.move(inner, x_W);
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("M5"), std::string::npos);
}

TEST(CheckOperation, notices_wrong_adjacency_and_an_index_out_of_step) {
  Rock rock = sheet();
  const LocalState before = local_state(rock.surface, {inner});
  const int c = rock.surface.corner_of[inner];
  std::swap(rock.surface.opposite[static_cast<std::size_t>(c)],
            rock.surface.opposite[static_cast<std::size_t>(mesh::next_corner(c))]);
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("M1"), std::string::npos);
  rock = sheet();
  rock.surface.stars[inner].x.z() += 1e-6;
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("index"), std::string::npos);
}

/// Also behind a vertex that is no more.
TEST(CheckOperation, notices_an_index_out_of_step_whatever_died_before) {
  Rock rock = sheet();
  const mesh::Surface& s = rock.surface;
  const int c = s.corner_of[inner];
  const int keep = s.vertex(mesh::next_corner(c)), gone = s.vertex(mesh::previous_corner(c));
  const LocalState before = local_state(s, {gone, keep});
  const Vec3 x_W = s.position(keep);
  mesh::collapse_edge(rock.surface, c, x_W);
  rock.grid.remove(gone);
  rock.grid.move(keep, x_W + Vec3(0.0, 0.0, 1e-3));
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("index"), std::string::npos);
}

/// Corner 0 is a corner like others: the triangle beyond its edge notices that it points elsewhere.
TEST(CheckOperation, notices_a_wrong_neighbour_of_the_first_corner) {
  Rock rock = sheet();
  const int c = rock.surface.opposite_of(0);
  ASSERT_GE(c, 0);
  const LocalState before = local_state(rock.surface, {rock.surface.vertex(c)});
  ASSERT_EQ(describe(check_around(rock, before, 0.0)), "");
  rock.surface.opposite[0] = -1;
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("M1"), std::string::npos);
}

/// The corners around v of triangles without `beside`, from v on.
std::vector<mesh::Facet> triangles_around(const mesh::Surface& s, int v, int beside) {
  std::vector<mesh::Facet> found;
  mesh::visit_corners(s, v, [&](int c) {
    const int p = s.vertex(mesh::next_corner(c)), q = s.vertex(mesh::previous_corner(c));
    if (p != beside && q != beside) found.push_back({s.position(v), s.position(p), s.position(q)});
  });
  return found;
}

double distance_of(const std::vector<mesh::Facet>& facets, const Vec3& x_W, double least = 1e300) {
  for (const mesh::Facet& f : facets) least = std::min(least, mesh::squared_distance(f, x_W));
  return std::sqrt(least);
}

/// The guards on distance with every triangle measured from every place.
std::optional<Refusal> judge_all_distances(const mesh::Surface& s, int a, int b, const Vec3& x_W,
                                           const MaintenanceLimits& l, double& drifted) {
  std::vector<mesh::Facet> old, kept, replacing;
  for (const auto& [v, other] : {std::pair{a, b}, std::pair{b, a}}) {
    const auto all = triangles_around(s, v, -1), some = triangles_around(s, v, other);
    old.insert(old.end(), all.begin(), all.end());
    kept.insert(kept.end(), some.begin(), some.end());
  }
  for (const mesh::Facet& f : kept) replacing.push_back({x_W, f.b, f.c});
  const auto to_new = [&](const Vec3& from_W) {
    return distance_of(replacing, from_W, (x_W - from_W).squaredNorm());
  };
  drifted = 0.0;
  for (const mesh::Facet& f : kept)
    drifted = std::max(drifted, distance_of(old, 0.5 * (x_W + f.b)));
  for (const mesh::Facet& f : old) drifted = std::max(drifted, to_new(0.5 * (f.a + f.b)));
  for (const int v : {a, b}) {
    const double d = to_new(s.position(v));
    if (d > l.ridge_cut && is_on_ridge(s, v, l)) return Refusal::ridge;
    drifted = std::max(drifted, d);
  }
  return drifted > l.farthest ? std::optional(Refusal::distance) : std::nullopt;
}

/// Distances that cannot be the greatest are not computed: the verdict and the bits are the same. Of
/// crumpled sheets too, and of some whose vertices coincide.
RC_GTEST_PROP(CollapseDistance, is_that_from_every_triangle, ()) {
  Rock rock = rock_of(any_sheet(*battery::number(0.1, 1.2)));
  const mesh::Surface& s = rock.surface;
  MaintenanceLimits l = bare_limits_for(0.9);
  l.farthest = *battery::number(0.0, 0.3);
  l.ridge_cut = *battery::number(0.0, 0.1);
  for (int c = *battery::integer(0, 12); c < 3 * s.triangle_slots(); c += 13) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    if (s.is_boundary(a) || s.is_boundary(b)) continue;
    if (c % 5 == 0) rock.surface.place(a, s.position(b));
    if (c % 7 == 0) rock.surface.place(s.vertex(c), s.position(b));
    const Vec3 &x_a = s.position(a), &x_b = s.position(b);
    for (const Vec3& x_W : {x_a, x_b, Vec3(0.5 * (x_a + x_b))}) {
      double quick = 0.0, slow = 0.0;
      const auto verdict = judge_distance(s, a, b, x_W, l, {}, quick);
      RC_ASSERT(verdict == judge_all_distances(s, a, b, x_W, l, slow));
      if (!verdict) RC_ASSERT(quick == slow);
    }
  }
}

/// rock (15) to (18), in edge lengths.
TEST(Limits, follow_the_edge_length) {
  constexpr double h = 0.002, just_below = 1.0 - 1e-9;
  const MaintenanceLimits l = limits_for(h);
  EXPECT_DOUBLE_EQ(l.shortest_edge, 0.4 * h);
  EXPECT_DOUBLE_EQ(l.longest_edge, 1.6 * h);
  EXPECT_DOUBLE_EQ(l.volume_per_operation, 0.01 * h * h * h);
  EXPECT_DOUBLE_EQ(l.untangle_volume, 0.2 * h * h * h);
  EXPECT_DOUBLE_EQ(l.ridge_cut, 0.05 * h);
  EXPECT_DOUBLE_EQ(l.farthest, just_below * 0.2 * h);
  EXPECT_DOUBLE_EQ(l.untangle_farthest, just_below * 0.8 * h);
}

TEST(Limits, of_another_shortest_edge_take_its_distances_along) {
  MaintenanceLimits l = limits_for(0.002);
  const MaintenanceLimits before = l;
  set_shortest_edge(l, 0.0001);
  EXPECT_EQ(l.shortest_edge, 0.0001);
  EXPECT_LT(l.farthest, 0.00005);
  EXPECT_NEAR(l.farthest, 0.00005, 1e-13);
  EXPECT_LT(l.untangle_farthest, 0.0002);
  EXPECT_NEAR(l.untangle_farthest, 0.0002, 4e-13);
  EXPECT_EQ(l.longest_edge, before.longest_edge);
  EXPECT_EQ(l.volume_per_operation, before.volume_per_operation);
}

MaintenanceReport report_of(int times) {
  MaintenanceReport r;
  for (int k = 0; k < times; ++k) {
    count_done(r, Operation::flip, -2e-9);
    count_done(r, Operation::bisection, 0.0);
    count_done(r, Operation::untangling, 3e-9);
    count_refused(r, Operation::flip, Refusal::normal);
    count_refused(r, Operation::flip, Refusal::normal);
    count_refused(r, Operation::bisection, Refusal::boundary);
    count_refused(r, Operation::untangling, Refusal::intersection);
  }
  r.touched_triangles = 7L * times;
  return r;
}

/// Volumes gained and lost cancel in the change, not in what was disturbed.
void expect_report(const MaintenanceReport& r, int times) {
  std::map<std::string, long> expected{{"flips", times},
                                       {"bisections", times},
                                       {"untanglings", times},
                                       {"refused_flips_normal", 2 * times},
                                       {"refused_bisections_boundary", times},
                                       {"refused_untanglings_intersection", times}};
  for (const auto& [name, count] : counts(r)) {
    EXPECT_EQ(count, expected[name]) << name;
    expected.erase(name);
  }
  EXPECT_TRUE(expected.empty());
  EXPECT_EQ(counts(r).size(), 6u + 6u * 11u);
  EXPECT_EQ(refusals(r), 4 * times);
  EXPECT_EQ(r.touched_triangles, 7 * times);
  EXPECT_DOUBLE_EQ(r.volume_change, 1e-9 * times);
  EXPECT_DOUBLE_EQ(r.volume_disturbed, 5e-9 * times);
}

TEST(MaintenanceReport, counts_operations_and_refusals_by_name_and_adds_up) {
  MaintenanceReport sum = report_of(1);
  expect_report(sum, 1);
  add(report_of(2), sum);
  expect_report(sum, 3);
}

}  // namespace tdbd::rock::check_operation_test
