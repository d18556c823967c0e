#include "rock/maintain/turned_over.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/star.hpp"
#include "rock/rock.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/cut/cutting_scene.hpp"

namespace tdbd::rock::turned_over_test {

Rock any_cut() {
  const Scene s = *scene();
  Rock rock = rock_of(s);
  CutWorkspace work;
  CutReport report;
  cut_rock(rock, prepare_cutting_bit(s.bit), s.X_WB0, s.X_WB1, work, report);
  return rock;
}

/// Carries some vertices past their neighbours, so that triangles are turned over.
void disturb(Rock& rock) {
  const double side = 3.0 / std::sqrt(0.5 * rock.surface.triangle_count());
  const int carried = *battery::integer(0, 20);
  for (int k = 0; k < carried; ++k) {
    const int v = *battery::integer(0, rock.surface.vertex_slots() - 1);
    const Vec3 way(*battery::number(-1.5, 1.5), *battery::number(-1.5, 1.5),
                   *battery::number(-1.5, 1.5));
    place_vertex(rock, v, rock.surface.position(v) + side * way);
  }
}

/// Compares every answer with the slow question. Returns how many triangles are turned over.
int compare_answers(Rock& rock, const MaintenanceLimits& limits) {
  const mesh::Surface& s = rock.surface;
  int turned = 0;
  for (int v = 0; v < s.vertex_slots(); ++v) {
    std::vector<int> slow, quick;
    mesh::visit_corners(s, v, [&](int c) {
      if (is_turned_over(s, limits, c / 3)) slow.push_back(c / 3);
    });
    add_turned_over(s, limits, v, rock.notes, quick);
    RC_ASSERT(quick == slow);
    RC_ASSERT(is_turned_over_at(s, limits, v, rock.notes) == !slow.empty());
  }
  for (int t = 0; t < s.triangle_slots(); ++t) {
    const bool is_turned = is_turned_over(s, limits, t);
    RC_ASSERT(is_turned_over(s, limits, t, rock.notes) == is_turned);
    turned += is_turned ? 1 : 0;
  }
  return turned;
}

/// By rings or by triangles, at any angle that upright triangles may lean by; also once more, with
/// the notes of rings that have not changed since.
RC_GTEST_PROP(TurnedOver, is_answered_by_rings_as_by_triangles, ()) {
  Rock rock = any_cut();
  MaintenanceLimits limits;
  limits.steepest_overhang = *battery::number(0.0, 0.5);
  std::vector<int> unknown;
  begin_notes(rock, limits, OldNotes::used, unknown);
  int turned = compare_answers(rock, limits);
  for (const int v : rock.touched_list) rock.touched[v] = 0;
  rock.touched_list.clear();
  disturb(rock);
  begin_notes(rock, limits, OldNotes::used, unknown);
  turned += compare_answers(rock, limits);
  RC_TAG(turned > 0 ? "some are turned over" : "none is");
}

/// The sieve is of use: a sheet that faces up is cleared, and so is a wall that leans over by less
/// than its neighbours would need to be turned against it.
TEST(TurnedOver, is_ruled_out_for_even_rock) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 3));
  MaintenanceLimits limits;
  std::vector<int> unknown;
  for (int pass = 0; pass < 2; ++pass) {
    begin_notes(rock, limits, OldNotes::discarded, unknown);
    for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
      if (rock.surface.is_boundary(v)) continue;
      std::vector<int> turned;
      add_turned_over(rock.surface, limits, v, rock.notes, turned);
      EXPECT_TRUE(turned.empty());
      EXPECT_EQ(rock.notes.of[v] & ring_may_fold, 0) << v;
      EXPECT_EQ(rock.notes.of[v] >> first_leaning_bit != 0, pass == 1) << v;
    }
    for (int v = 0; v < rock.surface.vertex_slots(); ++v) {  // upright, and a little over
      const Vec3 x = rock.surface.position(v);
      rock.surface.place(v, Vec3(x.z() + 0.05 * x.x(), x.y(), -x.x()));
    }
  }
}

}  // namespace tdbd::rock::turned_over_test
