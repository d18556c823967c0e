#include "rock/maintain/ring_notes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/maintain/renumber.hpp"
#include "rock/maintain/trim.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/cut/cutting_scene.hpp"

namespace tdbd::rock::ring_notes_test {

MaintenanceLimits any_limits(const mesh::Surface& s) {
  const double side = 3.0 / std::sqrt(0.5 * s.triangle_count());
  MaintenanceLimits l = limits_for(side * *battery::number(0.5, 1.5));
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
    if (by_cut) note_cut(m->rock, v);
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
    if (rock.surface.is_alive(v) && (of[at(v)] & ring_known) != 0)
      RC_ASSERT(of[at(v)] == look_at_ring(rock.surface, v, rock.notes.limits));
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
RC_GTEST_PROP(RingNotes, change_no_bit_and_no_count, ()) {
  Drilling d;
  Maintained with{rock_of(d.scene)}, without = with, sometimes = with;
  without.work.old_notes = OldNotes::discarded;
  without.work.touched.fine_rings = FineRings::classified;
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
  begin_notes(rock, limits_for(0.3), OldNotes::used, unknown);
  EXPECT_EQ(unknown, (std::vector{middle, neighbour}));
  begin_notes(rock, limits_for(0.3), OldNotes::used, unknown);
  EXPECT_TRUE(unknown.empty());
  touch(rock, 7 * 11 + 7);
  begin_notes(rock, limits_for(0.3), OldNotes::used, unknown);
  EXPECT_EQ(unknown, std::vector{7 * 11 + 7});
  touch(rock, neighbour);
  begin_notes(rock, limits_for(0.3), OldNotes::used, unknown);
  EXPECT_EQ(unknown, (std::vector{middle, neighbour}));
  begin_notes(rock, limits_for(0.2), OldNotes::used, unknown);
  EXPECT_EQ(unknown.size(), rock.touched_list.size());
}

}  // namespace tdbd::rock::ring_notes_test
