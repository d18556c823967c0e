#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/tolerance.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/maintain/touched_region.hpp"
#include "rock/start/space_order.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::waiting_test {

/// A random bit that moves in equal steps, with maintenance after some of them.
struct Drilling {
  CuttingBit bit;
  Pose X_WB, motion;
  Rock rock;
  CutWorkspace cut_work;
  CutReport cut_report;

  explicit Drilling(const Scene& s)
      : bit(prepare_cutting_bit(s.bit)),
        X_WB(s.X_WB0),
        motion(inverse(s.X_WB0) * s.X_WB1),
        rock(rock_of(s)) {}

  /// Scenes that leave the rock after some cuts are rejected by cut_rock and skipped.
  void cut() {
    try {
      cut_rock(rock, bit, X_WB, X_WB * motion, cut_work, cut_report);
    } catch (const RunError&) {
      RC_DISCARD("leaves the rock");
    }
    X_WB = X_WB * motion;
  }
  void stand_still() { cut_rock(rock, bit, X_WB, X_WB, cut_work, cut_report); }
};

MaintenanceLimits limits_of(const Rock& rock) {
  const double side = 3.0 / std::sqrt(0.5 * rock.surface.triangle_count());
  MaintenanceLimits l = bare_limits_for(side * *battery::number(0.7, 2.0));
  l.flip_quality = *battery::number(0.0, 1.0);
  l.smoothing = *battery::integer(0, 1) == 0 ? Smoothing::off : Smoothing::tangential;
  l.smooth_quality = *battery::number(0.0, 1.0);
  l.rest = static_cast<int>(*battery::integer(0, 4));
  l.longest_wait = static_cast<int>(*battery::integer(1, 6));
  return l;
}

std::vector<int> sorted(std::vector<int> list) {
  std::ranges::sort(list);
  return list;
}

bool same_surface(const Rock& a, const Rock& b) {
  return mesh::positions_of(a.surface) == mesh::positions_of(b.surface) &&
         a.surface.triangles == b.surface.triangles;
}

/// M1 to M3 and M5 to M7 of every maintenance of a run in which vertices wait: M2 and M3 for what
/// was due, M7 for all that was touched.
RC_GTEST_PROP(Waiting, keeps_the_promises_for_what_is_due, ()) {
  Drilling d(*scene());
  const MaintenanceLimits limits = limits_of(d.rock);
  MaintenanceWorkspace work;
  for (int k = 0; k < 5; ++k) {
    d.cut();
    if (*battery::integer(0, 1) == 0) continue;
    const Rock before = d.rock;
    MaintenanceReport report;
    maintain(d.rock, limits, work, report);
    RC_TAG(d.rock.touched_list.empty() ? "none waits" : "some wait");
    RC_ASSERT(describe(check_maintenance(before, d.rock, limits, report, work.drift)) == "");
  }
}

/// After a maintenance what is listed is what a cut moved in the last `rest` cuts, and nothing is
/// older than `longest_wait`.
RC_GTEST_PROP(Waiting, is_what_moved_of_late_and_never_too_long, ()) {
  Drilling d(*scene());
  MaintenanceLimits limits = limits_of(d.rock);
  MaintenanceWorkspace work;
  MaintenanceReport report;
  for (int k = 0; k < 6; ++k) {
    d.cut();
    const Rock before = d.rock;
    maintain(d.rock, limits, work, report);
    for (const int v : d.rock.touched_list) {
      const MovedIn& moved = d.rock.moved_in[v];
      RC_ASSERT(d.rock.cuts - moved.last < limits.rest);
      RC_ASSERT(d.rock.cuts - moved.first < limits.longest_wait);
      RC_ASSERT(before.touched[v] != 0);
    }
    for (int v = 0; v < before.surface.vertex_slots(); ++v)
      if (before.touched[v] != 0 && !is_due(before, limits, v) && d.rock.surface.is_alive(v))
        RC_ASSERT(d.rock.touched[v] != 0);
  }
}

/// A bit that is held still leaves nothing that waits.
RC_GTEST_PROP(Waiting, ends_when_the_bit_does_not_move, ()) {
  Drilling d(*scene());
  const MaintenanceLimits limits = limits_of(d.rock);
  MaintenanceWorkspace work;
  MaintenanceReport report;
  for (int k = 0; k < 3; ++k) d.cut();
  for (int k = 0; k < limits.rest; ++k) d.stand_still();
  maintain(d.rock, limits, work, report);
  RC_ASSERT(d.rock.touched_list.empty());
}

/// Without a rest maintenance does not know when vertices moved.
RC_GTEST_PROP(Waiting, without_rest_is_no_waiting, ()) {
  Drilling d(*scene());
  MaintenanceLimits limits = limits_of(d.rock);
  for (int k = 0; k < 3; ++k) d.cut();
  Rock forgetful = d.rock;
  forgetful.moved_in.assign(forgetful.moved_in.size(), {});
  MaintenanceWorkspace work;
  MaintenanceReport report, other;
  maintain(forgetful, limits, work, other);
  limits.rest = 0;
  maintain(d.rock, limits, work, report);
  RC_ASSERT(same_surface(d.rock, forgetful));
  RC_ASSERT(counts(report) == counts(other));
  RC_ASSERT(d.rock.touched_list.empty());
}

/// Nothing follows from the order in which vertices were listed.
RC_GTEST_PROP(Waiting, does_not_depend_on_the_order_of_the_list, ()) {
  Drilling d(*scene());
  const MaintenanceLimits limits = limits_of(d.rock);
  MaintenanceWorkspace work;
  MaintenanceReport report;
  for (int k = 0; k < 3; ++k) d.cut();
  Rock reversed = d.rock;
  std::ranges::reverse(reversed.touched_list);
  maintain(d.rock, limits, work, report);
  maintain(reversed, limits, work, report);
  RC_ASSERT(same_surface(d.rock, reversed));
  RC_ASSERT(sorted(d.rock.touched_list) == sorted(reversed.touched_list));
}

/// With cuts counted in thirds, three times the rest is the same rest.
RC_GTEST_PROP(Waiting, is_as_long_when_cuts_are_counted_in_parts, ()) {
  Drilling d(*scene());
  const MaintenanceLimits limits = limits_of(d.rock);
  for (int k = 0; k < 4; ++k) d.cut();
  MaintenanceLimits finer = limits;
  constexpr int parts = 3;
  finer.rest *= parts;
  finer.longest_wait *= parts;
  Rock divided = d.rock;
  scale_cut_counts(divided, parts);
  for (int v = 0; v < d.rock.surface.vertex_slots(); ++v)
    RC_ASSERT(is_due(d.rock, limits, v) == is_due(divided, finer, v));
}

constexpr double edge = 0.3;

MaintenanceLimits patient() {
  MaintenanceLimits l = bare_limits_for(edge);
  l.flip_quality = 0.6;
  l.smoothing = Smoothing::tangential;
  l.smooth_quality = 0.5;
  l.rest = 4;
  return l;
}

/// As a cut does.
void move_by_a_cut(Rock& rock, int v, const Vec3& x_W) {
  ++rock.cuts;
  record_cut(rock, v);
  place_vertex(rock, v, x_W);
}

constexpr int middle = 5 * 11 + 5, beside_the_boundary = 1 * 11 + 5;

/// An edge of twice the length is left until its vertex has rested, and then bisected.
TEST(Waiting, takes_as_many_cuts_as_the_rest) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.0, 1));
  move_by_a_cut(rock, middle, rock.surface.position(middle) + Vec3(0.0, 0.0, 1.8 * edge));
  MaintenanceWorkspace work;
  for (int cuts_since = 0; cuts_since < 4; ++cuts_since, ++rock.cuts) {
    MaintenanceReport report;
    maintain(rock, patient(), work, report);
    EXPECT_EQ(report.carried_out(Operation::bisection), 0) << cuts_since;
    EXPECT_EQ(rock.touched_list, std::vector<int>{middle});
  }
  MaintenanceReport report;
  maintain(rock, patient(), work, report);
  EXPECT_GT(report.carried_out(Operation::bisection), 0);
  EXPECT_TRUE(rock.touched_list.empty());
}

/// A vertex that every cut moves is maintained when its longest wait is over, and not before.
TEST(Waiting, is_bounded_where_nothing_rests) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.0, 1));
  MaintenanceLimits limits = patient();
  limits.longest_wait = 20;
  MaintenanceWorkspace work;
  long bisected_at = -1;
  for (int cut = 0; cut < 25 && bisected_at < 0; ++cut) {
    move_by_a_cut(rock, middle, rock.surface.position(middle) + Vec3(0.0, 0.0, 0.1 * edge));
    MaintenanceReport report;
    maintain(rock, limits, work, report);
    if (report.carried_out(Operation::bisection) > 0) bisected_at = cut;
  }
  EXPECT_EQ(bisected_at, 20);
}

/// The waiting vertex was carried past its neighbours, none of which is touched: its triangles are
/// taken apart although they wait.
TEST(Waiting, rock_is_untangled_all_the_same) {
  int tangled = 0, left = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.2, seed));
    const double turn = 2.399963 * static_cast<double>(seed);  // the golden angle
    const Vec3 far = 1.4 * edge * Vec3(std::cos(turn), std::sin(turn), 0.0);
    move_by_a_cut(rock, middle, rock.surface.position(middle) + far);
    const auto pairs = [&] {
      return reference::self_intersecting_pairs(mesh::compact(rock.surface));
    };
    tangled += pairs() > 0 ? 1 : 0;
    MaintenanceWorkspace work;
    MaintenanceReport report;
    maintain(rock, patient(), work, report);
    left += pairs() > 0 ? 1 : 0;
  }
  fmt::print("of {} tangled scenes {} are left\n", tangled, left);
  EXPECT_GT(tangled, 10);
  EXPECT_EQ(left, 0);
}

/// What was trimmed while it waited leaves the list, and its slot can be used again.
TEST(Waiting, ends_when_the_vertex_is_trimmed) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.0, 1));
  move_by_a_cut(rock, beside_the_boundary,
                rock.surface.position(beside_the_boundary) + Vec3(0.0, 0.0, 0.01 * edge));
  TrimWorkspace trimming;
  TrimReport trimmed;
  trim_wall(rock, -10.0, 0.1 * edge, trimming, trimmed);
  ASSERT_FALSE(rock.surface.is_alive(beside_the_boundary));
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(rock, patient(), work, report);
  EXPECT_TRUE(rock.touched_list.empty());
  EXPECT_EQ(rock.touched[beside_the_boundary], 0);
}

/// A random bit in rock that it has cut and that was maintained, in which some vertices wait.
struct Drilled {
  CuttingBit bit;
  Pose X_WB, motion;
  Rock rock;

  explicit Drilled(const Scene& s)
      : bit(prepare_cutting_bit(s.bit)),
        X_WB(s.X_WB0),
        motion(inverse(s.X_WB0) * s.X_WB1),
        rock(rock_of(s)) {
    const double side = 3.0 / std::sqrt(0.5 * rock.surface.triangle_count());
    MaintenanceLimits limits = bare_limits_for(side * *battery::number(0.7, 2.0));
    limits.flip_quality = 0.6;
    limits.smoothing = Smoothing::tangential;
    limits.smooth_quality = 0.5;
    limits.rest = static_cast<int>(*battery::integer(0, 4));
    MaintenanceWorkspace work;
    MaintenanceReport report;
    for (int k = 0; k < 3; ++k) {
      if (!cut(rock)) RC_DISCARD("leaves the rock");
      X_WB = X_WB * motion;
      if (*battery::integer(0, 2) > 0) maintain(rock, limits, work, report);
    }
  }

  /// The next step; nothing if it leaves the rock.
  std::optional<CutReport> cut(Rock& of) const {
    CutWorkspace work;
    CutReport report;
    try {
      cut_rock(of, bit, X_WB, X_WB * motion, work, report);
    } catch (const RunError&) {
      return {};
    }
    return report;
  }
};

double any_cube() { return *battery::number(0.05, 3.0); }

RC_GTEST_PROP(RenumberedRock, is_the_same_rock, ()) {
  const Drilled d(*scene());
  Rock rock = d.rock;
  RenumberWork work;
  renumber(rock, any_cube(), work);
  RC_TAG(d.rock.touched_list.empty() ? "none waits" : "some wait");
  RC_ASSERT(describe(check_disc(rock)) == "");
  RC_ASSERT(rock.surface.vertex_slots() == d.rock.surface.vertex_count());
  RC_ASSERT(rock.surface.triangle_slots() == d.rock.surface.triangle_count());
  RC_ASSERT(describe(check_ledger(d.rock.surface, rock.surface, 0.0)) == "");
  RC_ASSERT(rock.cuts == d.rock.cuts);
}

RC_GTEST_PROP(RenumberedRock, keeps_the_marks_of_every_vertex_and_the_queue, ()) {
  const Drilled d(*scene());
  Rock rock = d.rock;
  RenumberWork work;
  renumber(rock, any_cube(), work);
  std::vector<int> listed;
  for (int v = 0; v < d.rock.surface.vertex_slots(); ++v) {
    const int n = work.mesh.number[at(v)];
    RC_ASSERT((n >= 0) == d.rock.surface.is_alive(v));
    if (n < 0) continue;
    RC_ASSERT(rock.surface.position(n) == d.rock.surface.position(v));
    RC_ASSERT(rock.last_part[at(n)] == d.rock.last_part[at(v)]);
    RC_ASSERT(rock.touched[at(n)] == d.rock.touched[at(v)]);
    RC_ASSERT(rock.moved_in[at(n)].first == d.rock.moved_in[at(v)].first);
    RC_ASSERT(rock.moved_in[at(n)].last == d.rock.moved_in[at(v)].last);
  }
  for (const int v : d.rock.touched_list)
    if (work.mesh.number[at(v)] >= 0) listed.push_back(work.mesh.number[at(v)]);
  RC_ASSERT(rock.touched_list == listed);
}

/// Numbers decide ties of maintenance, but nothing of a cut: every vertex goes to the same place to
/// the bit, while volumes are summed in another order.
RC_GTEST_PROP(RenumberedRock, is_cut_as_it_was, ()) {
  const Drilled d(*scene());
  Rock rock = d.rock, as_it_was = d.rock;
  RenumberWork work;
  renumber(rock, any_cube(), work);
  const std::optional<CutReport> cut = d.cut(rock), expected = d.cut(as_it_was);
  RC_ASSERT(cut.has_value() == expected.has_value());
  if (!cut) RC_DISCARD("leaves the rock");
  RC_TAG(cut->moved > 0 ? "cuts" : "does not cut");
  RC_ASSERT(cut->moved == expected->moved);
  RC_ASSERT(cut->candidates == expected->candidates);
  for (std::size_t k = 0; k < cut->removed_by_part.size(); ++k)
    RC_ASSERT(std::abs(cut->removed_by_part[k] - expected->removed_by_part[k]) <=
              tolerance::ledger);  // of 1 m3, as large as the rock
  for (int v = 0; v < d.rock.surface.vertex_slots(); ++v)
    if (const int n = work.mesh.number[at(v)]; n >= 0) {
      RC_ASSERT(rock.surface.position(n) == as_it_was.surface.position(v));
      RC_ASSERT(rock.last_part[at(n)] == as_it_was.last_part[at(v)]);
    }
}

/// A copy that was numbered otherwise gets the same numbers.
RC_GTEST_PROP(RenumberedRock, has_numbers_that_follow_from_its_shape, ()) {
  const Drilled d(*scene());
  const double cube = any_cube();
  Rock rock = d.rock, other = d.rock;
  RenumberWork work;
  renumber(other, any_cube(), work);
  renumber(other, cube, work);
  renumber(rock, cube, work);
  RC_ASSERT(mesh::positions_of(rock.surface) == mesh::positions_of(other.surface));
  RC_ASSERT(rock.surface.triangles == other.surface.triangles);
  RC_ASSERT(rock.surface.corner_of == other.surface.corner_of);
  RC_ASSERT(rock.last_part == other.last_part);
}

}  // namespace tdbd::rock::waiting_test
