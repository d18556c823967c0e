#include "rock/maintain/fine_ring.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "rock/maintain/maintain.hpp"
#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/ring_spokes.hpp"
#include "rock/maintain/star.hpp"
#include "rock/maintain/touched_region.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/cut/cutting_scene.hpp"

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
  c.limits = limits_for(side * *battery::number(0.5, 1.5));
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

/// A ring that is passed over has nothing that maintenance would do; nor has a fold across an outer
/// edge been missed where nobody else asks.
RC_GTEST_PROP(FineRing, has_no_triangle_that_an_operation_wants, ()) {
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
RC_GTEST_PROP(FineRing, passed_over_changes_no_repair, ()) {
  Cut c = any_cut();
  Rock other = c.rock;
  MaintenanceWorkspace work, without;
  without.touched.fine_rings = FineRings::classified;
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
  MaintenanceLimits limits = limits_for(0.35);
  limits.flip_quality = 0.3;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    EXPECT_EQ(is_fine(rock, v, limits), !rock.surface.is_boundary(v)) << v;
}

/// The triangle across an outer edge is folded under the ring: only v, or the edge's ends, can say.
TEST(FineRing, asks_for_folds_across_its_outer_edges_unless_their_ends_do) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.0, 3));
  constexpr int v = 5 * 11 + 5;
  const mesh::VertexStar star = rock.surface.star(v);
  const MaintenanceLimits limits = limits_for(0.35);
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

}  // namespace tdbd::rock::fine_ring_test
