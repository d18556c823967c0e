#include "rock/maintain/collapse.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/measures.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::collapse_test {

constexpr double h = 0.9;  // limits for rock three times as coarse as the roof's edges

/// Two slopes of 40 to 50 degrees that meet in a ridge along x, in uneven edges of 0.3, every vertex
/// touched.
Rock roof() {
  mesh::TriangleMesh m = any_sheet(0.1);
  const double rise = *battery::number(0.84, 1.19), along = *battery::number(-0.1, 0.1);
  for (Vec3& x : m.positions) {
    if (std::abs(x.y()) < 0.15) x.y() = 0.0;  // the ridge's vertices
    x.z() = rise * std::abs(x.y()) + along * x.x();
  }
  Rock rock = rock_of(m);
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) touch(rock, v);
  return rock;
}

MaintenanceLimits limits() {
  MaintenanceLimits l = limits_for(h);
  l.volume_per_operation = 1.0;
  return l;
}

struct Thinned {
  double strayed = 0.0;  ///< m, the old surface from the new one
  MaintenanceReport report;
};

Thinned thinned(const Rock& before, const MaintenanceLimits& l) {
  Rock after = before;
  MaintenanceWorkspace work;
  Thinned t;
  maintain(after, l, work, t.report);
  t.strayed = deviation(before.surface, after.surface, 1.0).distance;
  return t;
}

/// Slopes thin out, and the ridge along itself; but it stays where it is.
RC_GTEST_PROP(Collapse, keeps_a_sharp_ridge, ()) {
  const Rock before = roof();
  const Thinned t = thinned(before, limits());
  RC_ASSERT(t.report.carried_out(Operation::collapse) > 10);
  RC_ASSERT(t.strayed <= limits().ridge_cut);
}

/// The verdicts on all places name the same edge as the verdict on the best of them, which is the first that is accepted.
RC_GTEST_PROP(Collapse, is_judged_alike_at_one_place_and_at_three, ()) {
  const Rock rock = roof();
  const mesh::Surface& s = rock.surface;
  for (int c = 0; c < 3 * s.triangle_slots(); c += 7) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    const CollapseVerdict one = judge_collapse(s, a, b, limits());
    const auto three = judge_collapses(s, a, b, limits(), {});
    for (const CollapseVerdict& v : three) RC_ASSERT(v.corner == one.corner);
    const auto best = std::ranges::find_if(three, is_accepted);
    RC_ASSERT((best != three.end()) == is_accepted(one));
    if (best != three.end()) RC_ASSERT(best->x_W == one.x_W && best->volume == one.volume);
  }
}

/// Ridges and valleys side by side: whichever end of an edge between them stays, one is cut.
TEST(Collapse, between_a_sharp_ridge_and_a_sharp_valley_is_refused_by_name) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.0, 7);
  for (Vec3& x : m.positions) x.z() = std::lround(x.y() / 0.3) % 2 == 0 ? 0.0 : 0.16;
  const mesh::Surface s = mesh::make_surface(m);
  MaintenanceLimits bound = limits(), free = limits();
  bound.longest_edge = free.longest_edge = 10.0;
  free.ridge_cut = free.farthest = 1.0;
  int refused = 0, accepted = 0;
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    if (std::abs(s.position(a).z() - s.position(b).z()) < 0.1) continue;
    EXPECT_FALSE(is_accepted(judge_collapse(s, a, b, bound)));
    refused += judge_collapse(s, a, b, bound).refused == Refusal::ridge;
    accepted += is_accepted(judge_collapse(s, a, b, free));
  }
  EXPECT_GT(refused, 10);
  EXPECT_GT(accepted, 10);
}

/// The distance of a collapse adds to that of those before it (M6): some that are accepted alone
/// are refused after others.
TEST(Collapse, after_others_may_be_too_far_from_the_first_surface) {
  constexpr double smallest = 1e-6;  // m: most of the sheet's collapses move it by 1e-2
  MaintenanceLimits l = limits();
  l.farthest = 0.05;
  int noted = 0, too_far = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.15, seed));
    const mesh::Surface& s = rock.surface;
    SurfaceDrift drift;
    MaintenanceReport report;
    std::vector<int> ring;
    for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
      if (!s.triangle_is_alive(c / 3)) continue;
      const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
      const CollapseVerdict alone = judge_collapse(s, a, b, l, {}),
                            v = judge_collapse(s, a, b, l, drift);
      too_far += is_accepted(alone) && v.refused == Refusal::distance;
      const int keep = v.corner < 0 ? a : s.vertex(mesh::next_corner(v.corner));
      if (!try_collapse(rock, a, b, l, ring, drift, report) || v.drift < smallest) continue;
      EXPECT_GE(drift.of(keep), v.drift);
      ++noted;
    }
  }
  EXPECT_GT(noted, 20);
  EXPECT_GT(too_far, 5);
}

}  // namespace tdbd::rock::collapse_test
