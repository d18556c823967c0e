#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/limits.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/touched_region.hpp"
#include "rock/start/space_order.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::fine_ring_test {

/// Rock after a random cut, with limits around its edges.
struct Cut {
  Rock rock;
  MaintenanceLimits limits;
};

Cut any_cut() {
  const Scene s = *scene();
  Cut c{rock_of(s), {}};
  CutWorkspace work;
  CutReport report;
  cut_rock(c.rock, prepare_cutting_bit(s.bit), s.X_WB0, s.X_WB1, work, report);
  const double side = 3.0 / std::sqrt(0.5 * c.rock.surface.triangle_count());
  c.limits = bare_limits_for(side * *battery::number(0.5, 1.5));
  c.limits.flip_quality = *battery::number(0.0, 0.6);
  c.limits.smoothing = Smoothing::tangential;
  c.limits.smooth_quality = *battery::number(0.0, 0.6);
  return c;
}

/// What classify_touched_triangles finds wanted of triangle t, or a fold over one of its edges.
bool is_wanted(const mesh::Surface& s, const MaintenanceLimits& l, int t) {
  const Shape shape = shape_of(s, t);
  const auto [least2, greatest2] = std::ranges::minmax(shape.edge2);
  if (least2 < l.shortest_edge * l.shortest_edge) return true;
  if (greatest2 > l.longest_edge * l.longest_edge) return true;
  if (is_below(shape, std::max({l.worst_quality, l.flip_quality, l.smooth_quality}))) return true;
  if (-shape.doubled_area.z() < l.shortest_edge * l.shortest_edge) return true;
  for (int c = 3 * t; c < 3 * t + 3; ++c)
    if (const int o = s.opposite_of(c);
        o >= 0 && are_folded(shape.doubled_area, doubled_area(facet_at(s, o))))
      return true;
  return false;
}

bool is_any_wanted(const Cut& c, int v) {
  bool wanted = false;
  mesh::visit_corners(c.rock.surface, v, [&](int k) {
    wanted = wanted || is_wanted(c.rock.surface, c.limits, k / 3);
  });
  return wanted;
}

/// As the rock is now, whatever was noted before.
bool is_fine(Rock& rock, int v, const MaintenanceLimits& limits) {
  if (!has_spokes(rock.surface.star(v))) return false;
  std::vector<int> unknown;
  begin_notes(rock, limits, OldNotes::discarded, unknown);
  return ring_is_fine(rock, v, marks_around(rock, v));
}

/// In a ring that is skipped, maintenance would do nothing; nor is a fold across an outer edge
/// missed that no other ring tests.
RC_GTEST_PROP(FineRing, has_no_triangle_that_an_operation_changes, ()) {
  Cut c = any_cut();
  c.rock.touched.assign(c.rock.touched.size(), 0);
  int passed = 0;
  for (int v = 0; v < c.rock.surface.vertex_slots(); ++v) {
    if (!is_fine(c.rock, v, c.limits)) continue;
    ++passed;
    RC_ASSERT(!is_any_wanted(c, v));
  }
  RC_TAG(passed > 0 ? "some are fine" : "none is fine");
}

/// With the filter and without it maintenance does the same, and counts the same.
RC_GTEST_PROP(FineRing, that_is_skipped_changes_no_repair, ()) {
  Cut c = any_cut();
  Rock other = c.rock;
  MaintenanceWorkspace work, without;
  without.touched.fine_rings = RingSkipping::classified;
  for (int k = 0; k < 2; ++k) {
    MaintenanceReport report, slow;
    maintain(c.rock, c.limits, work, report);
    maintain(other, c.limits, without, slow);
    RC_ASSERT(mesh::positions_of(c.rock.surface) == mesh::positions_of(other.surface));
    RC_ASSERT(c.rock.surface.triangles == other.surface.triangles);
    RC_ASSERT(counts(report) == counts(slow));
    RC_ASSERT(report.touched_triangles == slow.touched_triangles);
    RC_ASSERT(k > 0 ||
              report.touched_triangles == static_cast<long>(without.touched.triangles.size()));
    for (int v = 0; v < c.rock.surface.vertex_slots(); v += 3)
      if (c.rock.surface.is_alive(v)) {
        touch(c.rock, v);
        touch(other, v);
      }
  }
}

/// Counted by marks of neighbours, every touched triangle is counted once.
RC_GTEST_PROP(FineRing, counts_touched_triangles_by_marks_as_one_by_one, ()) {
  const Cut c = any_cut();
  const mesh::Surface& s = c.rock.surface;
  for (int v = 0; v < s.vertex_slots(); ++v) {
    if (!has_spokes(s.star(v))) continue;
    const RingMarks marks = marks_around(c.rock, v);
    RC_ASSERT(triangles_first_at(s.star(v), marks) == triangles_first_at(c.rock, v));
  }
}

/// The filter is of use: on an even sheet it passes every inner vertex of up to eight neighbours.
TEST(FineRing, is_found_on_an_even_sheet) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 3));
  MaintenanceLimits limits = bare_limits_for(0.35);
  limits.flip_quality = 0.3;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    EXPECT_EQ(is_fine(rock, v, limits), !rock.surface.is_boundary(v)) << v;
}

/// The triangle across an outer edge is folded under the ring: only v, or the edge's ends, can say.
TEST(FineRing, tests_folds_across_its_outer_edges_unless_their_ends_do) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.0, 3));
  constexpr int v = 5 * 11 + 5;
  const mesh::VertexStar star = rock.surface.star(v);
  const MaintenanceLimits limits = bare_limits_for(0.35);
  ASSERT_TRUE(is_fine(rock, v, limits));
  const int corner = mesh::corner_facing(rock.surface, star.ring[0], star.ring[1]);
  const int beyond = rock.surface.vertex(rock.surface.opposite_of(corner));
  const Vec3 fold = rock.surface.position(v) + Vec3(0.0, 0.0, 0.1);
  rock.surface.place(beyond, fold);
  EXPECT_FALSE(is_fine(rock, v, limits));
  rock.touched[star.ring[0]] = touched_mark;
  rock.touched[star.ring[1]] = touched_mark;
  EXPECT_TRUE(is_fine(rock, v, limits));
}

MaintenanceLimits any_limits(const mesh::Surface& s) {
  const double side = 3.0 / std::sqrt(0.5 * s.triangle_count());
  MaintenanceLimits l = bare_limits_for(side * *battery::number(0.5, 1.5));
  l.flip_quality = *battery::number(0.0, 1.0);
  l.smoothing = *battery::integer(0, 1) == 0 ? Smoothing::off : Smoothing::tangential;
  l.smooth_quality = *battery::number(0.0, 1.0);
  l.steepest_overhang = *battery::number(0.0, 0.3);
  l.rest = static_cast<int>(*battery::integer(0, 6));
  l.longest_wait = static_cast<int>(*battery::integer(1, 10));
  return l;
}

enum class Kind { cut, stand, move, maintain, change_limits, trim, renumber, count };

/// A random bit that drills in equal steps, and what happens to its rock between them.
struct Drilling {
  Scene scene = *rock::scene();
  CuttingBit bit;
  Pose motion, X_WB = scene.X_WB0;
  MaintenanceLimits limits;

  Drilling() {
    if (*battery::integer(0, 2) == 0)
      for (bit::Part& p : scene.bit.parts) p.share = 0.6;
    bit = prepare_cutting_bit(scene.bit);
    motion = inverse(scene.X_WB0) * scene.X_WB1;
    limits = any_limits(mesh::make_surface(scene.rock_W));
  }
};

/// One rock under maintenance, and what that counted.
struct Maintained {
  Rock rock;
  CutWorkspace cut_work = {};
  CutReport cut_report = {};
  MaintenanceWorkspace work = {};
  MaintenanceReport report = {};
  RenumberWork renumber_work = {};
  TrimWorkspace trim_work = {};
  TrimReport trimmed = {};
};

/// The same to all rocks. Scenes that leave the rock are refused by cut_rock.
void cut(Drilling& d, const Pose& to, const std::vector<Maintained*>& all) {
  for (Maintained* m : all) try {
      cut_rock(m->rock, d.bit, d.X_WB, to, m->cut_work, m->cut_report);
    } catch (const RunError&) {
      RC_DISCARD("leaves the rock");
    }
  d.X_WB = to;
}

/// A vertex goes past its neighbours, in a cut or not; only itself is touched.
void move_one(const std::vector<Maintained*>& all) {
  const int pick = *battery::integer(0, 1 << 20);
  const bool by_cut = *battery::integer(0, 1) == 0;
  const Vec3 way = *battery::point(0.3);
  for (Maintained* m : all) {
    const int v = pick % m->rock.surface.vertex_slots();
    if (!m->rock.surface.is_alive(v) || m->rock.surface.is_boundary(v)) return;
    if (by_cut) record_cut(m->rock, v);
    place_vertex(m->rock, v, m->rock.surface.position(v) + way);
  }
}

/// Maintains all rocks. Repairs of a scene that was torn at random may not end, with notes or without:
/// then all rocks must stop the same way.
void maintain_all(const MaintenanceLimits& limits, const std::vector<Maintained*>& all) {
  std::vector<std::string> stops;
  for (Maintained* m : all) try {
      maintain(m->rock, limits, m->work, m->report);
      stops.emplace_back();
    } catch (const RunError& e) {
      stops.emplace_back(e.what());
    }
  for (const std::string& stop : stops) RC_ASSERT(stop == stops.front());
  if (!stops.front().empty()) RC_DISCARD("repairs do not end");
}

/// Carries out one command on all rocks: a maintenance after any number of others.
Kind carry_out_any(Drilling& d, const std::vector<Maintained*>& all) {
  const int last = static_cast<int>(Kind::count) - 1, pick = *battery::integer(0, 2 * last);
  const Kind kind = pick > last ? Kind::maintain : static_cast<Kind>(pick);
  if (kind == Kind::cut) cut(d, d.X_WB * d.motion, all);
  if (kind == Kind::stand) cut(d, d.X_WB, all);
  if (kind == Kind::move) move_one(all);
  if (kind == Kind::change_limits) d.limits = any_limits(all.front()->rock.surface);
  if (kind == Kind::maintain) maintain_all(d.limits, all);
  for (Maintained* m : all) {
    if (kind == Kind::trim) trim_wall(m->rock, -10.0, -0.02, m->trim_work, m->trimmed);
    if (kind == Kind::renumber) renumber(m->rock, 0.5, m->renumber_work);
  }
  return kind;
}

/// Every note that is used is that of a new look.
void require_right_notes(const Rock& rock) {
  const std::vector<std::uint16_t>& of = rock.notes.of;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (rock.surface.is_alive(v) && (of[at(v)] & ring_note_valid) != 0)
      RC_ASSERT(of[at(v)] == compute_ring_note(rock.surface, v, rock.notes.limits));
}

void require_same(const Maintained& a, const Maintained& b) {
  RC_ASSERT(mesh::positions_of(a.rock.surface) == mesh::positions_of(b.rock.surface));
  RC_ASSERT(a.rock.surface.triangles == b.rock.surface.triangles);
  RC_ASSERT(a.rock.touched_list == b.rock.touched_list);
  RC_ASSERT(a.rock.touched == b.rock.touched);
  RC_ASSERT(counts(a.report) == counts(b.report));
  RC_ASSERT(a.report.touched_triangles == b.report.touched_triangles);
  RC_ASSERT(a.report.volume_change == b.report.volume_change);
}

/// After whatever happened to the rock, a maintenance begins and ends with notes that are right.
RC_GTEST_PROP(RingNotes, are_right_as_long_as_they_are_kept, ()) {
  Drilling d;
  Maintained m{rock_of(d.scene)};
  std::vector<int> unknown;
  int kept = 0;
  for (int k = 0; k < 12; ++k) {
    const Kind kind = carry_out_any(d, {&m});
    if (kind == Kind::maintain) require_right_notes(m.rock);
    if (kind != Kind::maintain) continue;
    begin_notes(m.rock, d.limits, OldNotes::used, unknown);
    kept += unknown.size() < m.rock.touched_list.size() ? 1 : 0;
    require_right_notes(m.rock);
  }
  RC_TAG(kept > 0 ? "some are kept" : "none is kept");
}

/// With notes, without, and with notes that are lost now and then, as by a restart.
RC_GTEST_PROP(RingNotes, change_no_result_and_no_count, ()) {
  Drilling d;
  Maintained with{rock_of(d.scene)}, without = with, sometimes = with;
  without.work.old_notes = OldNotes::discarded;
  without.work.touched.fine_rings = RingSkipping::classified;
  for (int k = 0; k < 12; ++k) {
    if (*battery::integer(0, 3) == 0) sometimes.rock.notes = {};
    if (carry_out_any(d, {&with, &without, &sometimes}) != Kind::maintain) continue;
    require_same(with, without);
    require_same(with, sometimes);
  }
}

/// Looks in parallel are those of one thread.
RC_GTEST_PROP(RingNotes, do_not_depend_on_threads, ()) {
  Drilling d;
  Maintained one{rock_of(d.scene)};
  for (int k = 0; k < 3; ++k) cut(d, d.X_WB * d.motion, {&one});
  for (int v = 0; v < one.rock.surface.vertex_slots(); ++v) touch(one.rock, v);
  Maintained four = one;
  {
    const ThreadLimit limit(1);
    maintain(one.rock, d.limits, one.work, one.report);
  }
  const ThreadLimit limit(4);
  maintain(four.rock, d.limits, four.work, four.report);
  require_same(one, four);
  RC_ASSERT(one.rock.notes.of == four.rock.notes.of);
}

/// The notes save looks: in rock that waits unchanged no ring is looked at twice.
TEST(RingNotes, are_kept_where_nothing_changed) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 3));
  constexpr int middle = 5 * 11 + 5, neighbour = middle + 1;
  for (const int v : {middle, neighbour}) touch(rock, v);
  std::vector<int> unknown;
  begin_notes(rock, bare_limits_for(0.3), OldNotes::used, unknown);
  EXPECT_EQ(unknown, (std::vector{middle, neighbour}));
  begin_notes(rock, bare_limits_for(0.3), OldNotes::used, unknown);
  EXPECT_TRUE(unknown.empty());
  touch(rock, 7 * 11 + 7);
  begin_notes(rock, bare_limits_for(0.3), OldNotes::used, unknown);
  EXPECT_EQ(unknown, std::vector{7 * 11 + 7});
  touch(rock, neighbour);
  begin_notes(rock, bare_limits_for(0.3), OldNotes::used, unknown);
  EXPECT_EQ(unknown, (std::vector{middle, neighbour}));
  begin_notes(rock, bare_limits_for(0.2), OldNotes::used, unknown);
  EXPECT_EQ(unknown.size(), rock.touched_list.size());
}

}  // namespace tdbd::rock::fine_ring_test
