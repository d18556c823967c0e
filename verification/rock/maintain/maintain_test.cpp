#include "rock/maintain/maintain.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "rock/maintain/invariants.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/index/grid_query.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::maintain_test {

using mesh::Surface;

/// Rock that some steps of a random bit worked over, and what maintenance made of it.
struct Worked {
  MaintenanceLimits limits;
  Rock cut, after;
  MaintenanceReport report;
};

Rock cut_in_steps(const Scene& s, int steps) {
  Rock rock = rock_of(s);
  const CuttingBit bit = prepare_cutting_bit(s.bit);
  CutWorkspace work;
  CutReport report;
  const Pose motion = inverse(s.X_WB0) * s.X_WB1;
  Pose X_WB = s.X_WB0;
  for (int k = 0; k < steps; ++k) {
    cut_rock(rock, bit, X_WB, X_WB * motion, work, report);
    X_WB = X_WB * motion;
  }
  return rock;
}

double mean_edge(const Surface& s) {
  const Vec3 size = mesh::bounding_box(mesh::compact(s)).size();
  return std::sqrt(2.0 * size.x() * size.y() / s.triangle_count());
}

long operations(const MaintenanceReport& r) {
  return std::accumulate(r.done.begin(), r.done.end(), 0L);
}

/// Flips and smoothing, or one of them, or none.
MaintenanceLimits with_any_options(MaintenanceLimits l) {
  l.flip_quality = *battery::integer(0, 1) * *battery::number(0.0, 1.0);
  l.smoothing = *battery::integer(0, 1) == 0 ? Smoothing::off : Smoothing::tangential;
  l.smooth_quality = *battery::number(0.0, 1.0);
  return l;
}

Worked worked(const Wildness& wild = {}) {
  Worked w;
  w.cut = cut_in_steps(*scene(wild), *battery::integer(1, 3));
  w.limits = with_any_options(bare_limits_for(mean_edge(w.cut.surface)));
  w.after = w.cut;
  MaintenanceWorkspace work;
  maintain(w.after, w.limits, work, w.report);
  RC_TAG(operations(w.report) > 0 ? "repairs" : "nothing to do");
  return w;
}

/// Scale of volumes: the cube over the rock's square.
constexpr double scale = 27.0;

double gained(const Rock& before, const Rock& after) {
  return mesh::hole_volume(after.surface, Vec3::Zero()) -
         mesh::hole_volume(before.surface, Vec3::Zero());
}

/// What is wrong with the surface as a disc. That cutting has pressed triangles flat is not
/// maintenance's fault.
std::string topological_defects(const Surface& s) {
  std::vector<mesh::Defect> defects = mesh::check_surface(mesh::compact(s));
  std::erase_if(defects,
                [](const auto& d) { return d.kind == mesh::Defect::Kind::degenerate_triangle; });
  return mesh::describe(defects);
}

/// M1.
RC_GTEST_PROP(Maintain, leaves_a_disc, ()) {
  const Worked w = worked();
  RC_ASSERT(topological_defects(w.after.surface) == "");
  RC_ASSERT(mesh::adjacency_is_consistent(w.after.surface));
}

/// M5.
RC_GTEST_PROP(Maintain, reports_the_volume_that_it_changes, ()) {
  const Worked w = worked();
  RC_ASSERT(std::abs(gained(w.cut, w.after) - w.report.volume_change) < tolerance::ledger * scale);
  RC_ASSERT(std::abs(w.report.volume_change) <= w.report.volume_disturbed);
  RC_ASSERT(w.report.volume_disturbed <=
            static_cast<double>(operations(w.report)) * w.limits.volume_per_operation);
}

RC_GTEST_PROP(Maintain, by_bisection_alone_changes_no_volume, ()) {
  Rock rock = cut_in_steps(*scene(), 2);
  const Rock cut = rock;
  MaintenanceLimits limits = bare_limits_for(mean_edge(rock.surface));
  limits.shortest_edge = limits.worst_quality = 0.0;
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(rock, limits, work, report);
  RC_TAG(report.carried_out(Operation::bisection) > 0 ? "bisects" : "nothing to do");
  RC_ASSERT(report.carried_out(Operation::collapse) == 0);
  RC_ASSERT(report.volume_change == 0.0);
  RC_ASSERT(std::abs(gained(cut, rock)) < 1e-15 * scale);
}

/// The vertices within some edges of the touched ones.
std::vector<bool> near_touched(const Rock& rock, int edges) {
  std::vector<bool> near(rock.touched.begin(), rock.touched.end());
  for (int k = 0; k < edges; ++k) {
    std::vector<bool> wider = near;
    for (const mesh::Triangle& t : rock.surface.triangles)
      if (t[0] >= 0 && (near[t[0]] || near[t[1]] || near[t[2]]))
        for (const int v : t) wider[v] = true;
    near = wider;
  }
  return near;
}

/// M7, on rock that needs no repair of its own. Repairs at touched vertices reach their neighbours,
/// and repairs of those reach the next ones.
RC_GTEST_PROP(Maintain, leaves_boundary_and_untouched_rock_alone, ()) {
  const Worked w = worked({.bump = 0.04});
  const Surface &before = w.cut.surface, &after = w.after.surface;
  const std::vector<bool> near = near_touched(w.cut, 3);
  for (int v = 0; v < before.vertex_slots(); ++v) {
    if (near[v] && !before.is_boundary(v)) continue;
    RC_ASSERT(after.is_alive(v));
    RC_ASSERT(after.position(v) == before.position(v));
    RC_ASSERT(after.is_boundary(v) == before.is_boundary(v));
  }
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    const auto [a, b, c] = before.triangles[t];
    if (!near[a] && !near[b] && !near[c]) RC_ASSERT(after.triangles[t] == before.triangles[t]);
  }
}

/// Interior edges once each, with their lengths.
template <class Visit>
void visit_interior_edges(const Surface& s, Visit&& visit) {
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (!s.triangle_is_alive(c / 3) || s.opposite_of(c) < c) continue;
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    visit(a, b, (s.position(b) - s.position(a)).norm());
  }
}

/// M3, the upper bound: what was touched has no long edge.
RC_GTEST_PROP(Maintain, leaves_no_long_edge_where_rock_was_touched, ()) {
  const Worked w = worked();
  const int slots = w.cut.surface.vertex_slots();
  visit_interior_edges(w.after.surface, [&](int a, int b, double length) {
    const bool touched = a >= slots || b >= slots || w.cut.touched[a] || w.cut.touched[b];
    if (touched) RC_ASSERT(length <= w.limits.longest_edge);
  });
}

/// Maintains everything again and again; the last report is of a round without any repair.
MaintenanceReport settle(Rock& rock, const MaintenanceLimits& limits) {
  constexpr int most_rounds = 50;
  MaintenanceWorkspace work;
  for (int round = 0; round < most_rounds; ++round) {
    for (int v = 0; v < rock.surface.vertex_slots(); ++v)
      if (rock.surface.is_alive(v)) touch(rock, v);
    MaintenanceReport report;
    maintain(rock, limits, work, report);
    if (report.carried_out(Operation::bisection) + report.carried_out(Operation::collapse) == 0)
      return report;
  }
  RC_FAIL("repairs do not end");
}

/// Limits that sometimes require much coarser rock: many collapses, and many that must be refused.
MaintenanceLimits any_limits(double edge_length) {
  MaintenanceLimits l = with_any_options(bare_limits_for(edge_length));
  l.shortest_edge *= *battery::number(0.5, 6.0);
  l.longest_edge = std::max(2.0 * l.shortest_edge, 1.6 * edge_length);
  l.worst_quality = *battery::number(0.0, 0.3);
  l.volume_per_operation *= *battery::integer(1, 100);
  return l;
}

/// M1, M2 and M3 with their proviso, on the whole rock: once no repair is left, every short edge
/// that remains was refused, and counted; the boundary is where it was.
RC_GTEST_PROP(Maintain, comes_to_rest_and_counts_every_refusal, ()) {
  Worked w = worked();
  const MaintenanceLimits limits = any_limits(mean_edge(w.cut.surface));
  const MaintenanceReport last = settle(w.after, limits);
  const Surface& s = w.after.surface;
  RC_ASSERT(topological_defects(s) == "");
  for (int v = 0; v < w.cut.surface.vertex_slots(); ++v)
    if (w.cut.surface.is_boundary(v)) {
      RC_ASSERT(s.is_alive(v) && s.is_boundary(v));
      RC_ASSERT(s.position(v) == w.cut.surface.position(v));
    }
  long defects = 0;
  visit_interior_edges(s, [&](int, int, double length) {
    RC_ASSERT(length <= limits.longest_edge);
    defects += length < limits.shortest_edge;
  });
  RC_ASSERT(refusals(last) >= defects);
}

/// Rock that was moved straight down only is a height field, steep walls of craters and all. No
/// repair makes more of an overhang of it than an upright wall may lean.
RC_GTEST_PROP(Maintain, keeps_a_height_field_but_for_upright_walls, ()) {
  Wildness straight_down;
  straight_down.tilt = straight_down.outwards = 0.0;
  Worked w = worked(straight_down);
  const MaintenanceLimits limits = any_limits(mean_edge(w.cut.surface));
  settle(w.after, limits);
  const Surface& s = w.after.surface;
  for (int t = 0; t < s.triangle_slots(); ++t) {
    if (!s.triangle_is_alive(t)) continue;
    const auto x = [&](int i) { return s.position(s.vertex(3 * t + i)); };
    const Vec3 area = mesh::area_vector(x(0), x(1), x(2));
    // wide: a promise of maintenance, mostly kept by far
    RC_ASSERT(area.z() <= limits.steepest_overhang * area.norm() * (1.0 + 1e-9));
  }
}

/// Edges that must shrink to an eighth take several rounds.
TEST(Maintain, that_does_not_end_stops_and_names_the_place) {
  Rock rock = make_rock(mesh::make_surface(battery::bumpy_rock(1.0, 4, 0.1, 1)), 0.5,
                        {Vec3::Constant(-1.0), Vec3::Constant(1.0)});
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) touch(rock, v);
  MaintenanceLimits limits = bare_limits_for(0.06);
  limits.most_rounds = 2;
  MaintenanceWorkspace work;
  MaintenanceReport report;
  try {
    maintain(rock, limits, work, report);
    FAIL() << "expected a RunError";
  } catch (const RunError& e) {
    EXPECT_NE(std::string(e.what()).find("after 2 rounds there is more to do at ("),
              std::string::npos)
        << e.what();
  }
  EXPECT_EQ(describe(check_disc(rock)), "");
}

RC_GTEST_PROP(Maintain, without_touch_does_nothing, ()) {
  Worked w = worked();
  const Rock before = w.after;
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(w.after, w.limits, work, report);
  RC_ASSERT(operations(report) == 0);
  RC_ASSERT(refusals(report) == 0);
  RC_ASSERT(mesh::positions_of(w.after.surface) == mesh::positions_of(before.surface));
  RC_ASSERT(w.after.surface.triangles == before.surface.triangles);
}

/// The arrays and the index know every vertex, the dead ones none.
/// The index forgets layer by layer what has left: one with each maintenance.
TEST(Maintain, refreshes_the_index) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 7));
  const auto nearest_above = [&] { return rock.grid.nearest_to_axis(-9.0, -3.0); };
  rock.grid = VertexGrid({Vec3(-2, -2, -9), Vec3(2, 2, 9)}, 0.5);
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    rock.grid.insert(v, rock.surface.position(v));
  const double nothing = nearest_above();
  const Vec3 there = rock.surface.position(60);
  place_vertex(rock, 60, there - Vec3(0, 0, 5));
  ASSERT_LT(nearest_above(), nothing);
  place_vertex(rock, 60, there);
  ASSERT_LT(nearest_above(), nothing);
  MaintenanceWorkspace work;
  MaintenanceReport report;
  for (int k = 0; k < 40; ++k) maintain(rock, bare_limits_for(0.3), work, report);
  EXPECT_EQ(nearest_above(), nothing);
}

RC_GTEST_PROP(Maintain, keeps_arrays_and_index_in_step, ()) {
  const Worked w = worked();
  const Surface& s = w.after.surface;
  RC_ASSERT(w.after.last_part.size() == s.stars.size());
  RC_ASSERT(w.after.touched == std::vector<std::uint8_t>(s.stars.size(), 0));
  RC_ASSERT(w.after.touched_list.empty());
  std::set<int> indexed;
  visit_vertices(w.after.grid, {mesh::Box{Vec3::Constant(-9), Vec3::Constant(9)}},
                 [&](int v) { indexed.insert(v); });
  for (int v = 0; v < s.vertex_slots(); ++v) {
    RC_ASSERT(indexed.contains(v) == s.is_alive(v));
    bool found = false;
    visit_vertices(w.after.grid, {mesh::Box{s.position(v), s.position(v)}},
                   [&](int x) { found = found || x == v; });
    RC_ASSERT(found == s.is_alive(v));
  }
}

RC_GTEST_PROP(Maintain, twice_gives_the_same_bits, ()) {
  const Worked w = worked();
  Rock again = w.cut;
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(again, w.limits, work, report);
  RC_ASSERT(mesh::positions_of(again.surface) == mesh::positions_of(w.after.surface));
  RC_ASSERT(again.surface.triangles == w.after.surface.triangles);
  RC_ASSERT(report.volume_change == w.report.volume_change);
}

/// The triangle across an edge that no touched vertex has is folded over the touched one. Every collapse is refused, so
/// that those tried can be counted.
TEST(Maintain, tries_of_a_fold_the_edges_of_its_touched_triangle_alone) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 3));
  const int v = 5 * 11 + 5;
  const mesh::VertexStar star = rock.surface.star(v);
  const int a = star.ring[0], b = star.ring[1], corner = mesh::corner_facing(rock.surface, a, b);
  const int beyond = rock.surface.vertex(rock.surface.opposite_of(corner));
  const Vec3 &x_v = rock.surface.position(v), &x_a = rock.surface.position(a),
             &x_b = rock.surface.position(b);
  rock.surface.place(beyond, 0.4 * x_v + 0.3 * (x_a + x_b) + Vec3(0.0, 0.0, 1e-3));
  rock.touched.assign(rock.touched.size(), 0);
  touch(rock, v);
  MaintenanceLimits limits = bare_limits_for(0.35);
  limits.longest_edge = 3.0;
  limits.volume_per_operation = limits.flip_quality = 0.0;
  limits.smoothing = Smoothing::off;
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(rock, limits, work, report);
  EXPECT_EQ(operations(report), 0);
  EXPECT_EQ(refusals(report), 3);
}

}  // namespace tdbd::rock::maintain_test
