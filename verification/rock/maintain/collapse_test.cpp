#include "rock/maintain/collapse.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mesh/edit.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/hausdorff.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/limits.hpp"
#include "rock/maintain/maintain.hpp"
#include "verification/mesh/random_edit.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

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
  MaintenanceLimits l = bare_limits_for(h);
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
RC_GTEST_PROP(Collapse, has_the_same_result_at_one_place_and_at_three, ()) {
  const Rock rock = roof();
  const mesh::Surface& s = rock.surface;
  for (int c = 0; c < 3 * s.triangle_slots(); c += 7) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    const CollapseVerdict one = judge_collapse(s, a, b, limits());
    const auto three = judge_collapses(s, a, b, limits(), {});
    for (const CollapseVerdict& v : three) RC_ASSERT(v.corner == one.corner);
    const auto best = std::ranges::find_if(three, is_accepted);
    RC_ASSERT((best != three.end()) == is_accepted(one));
    if (best != three.end())
      RC_ASSERT(best->x_W == one.x_W && best->volume == one.volume);
    else
      RC_ASSERT(one.refused == three[0].refused);  // the first reason is reported
  }
}

/// The triangles that a collapse of (a, b) to x leaves around it.
std::vector<mesh::Facet> remaining_rock_of(const mesh::Surface& s, int a, int b, const Vec3& x_W) {
  std::vector<mesh::Facet> left;
  for (const mesh::Triangle& t : s.triangles) {
    const auto has = [&](int v) { return t[0] == v || t[1] == v || t[2] == v; };
    if (has(a) == has(b)) continue;
    const auto place = [&](int v) -> Vec3 { return v == a || v == b ? x_W : s.position(v); };
    left.push_back({place(t[0]), place(t[1]), place(t[2])});
  }
  return left;
}

double worst_of(const std::vector<mesh::Facet>& facets) {
  double worst = 1.0;
  for (const mesh::Facet& f : facets)
    worst = std::min(worst, mesh::triangle_quality(f.a, f.b, f.c));
  return worst;
}

/// The quality below which no triangle may come: 0.3, or that of the worst one at either end.
double floor_of(const mesh::Surface& s, int a, int b) {
  double worst = 0.3;
  for (const mesh::Triangle& t : s.triangles)
    if (std::ranges::count(t, a) + std::ranges::count(t, b) > 0)
      worst = std::min(
          worst, mesh::triangle_quality(s.position(t[0]), s.position(t[1]), s.position(t[2])));
  return worst;
}

double longest_at(const std::vector<mesh::Facet>& facets, const Vec3& x_W) {
  double longest = 0.0;
  for (const mesh::Facet& f : facets)
    for (const Vec3& y_W : {f.a, f.b, f.c}) longest = std::max(longest, (y_W - x_W).norm());
  return longest;
}

/// Everything is allowed but what a test takes back.
MaintenanceLimits lax() {
  MaintenanceLimits l = bare_limits_for(h);
  l.longest_edge = l.volume_per_operation = l.farthest = l.ridge_cut = 1e3;
  l.least_normal_cosine = -1.0;
  l.steepest_overhang = 2.0;
  return l;
}

/// Calls visit(a, b, verdict) for the three places of inner edges that may collapse, of one in `every`.
template <class Visit>
void visit_places(const mesh::Surface& s, const MaintenanceLimits& l, Visit&& visit,
                  int every = 7) {
  for (int c = *battery::integer(0, every - 1); c < 3 * s.triangle_slots(); c += every) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    for (const CollapseVerdict& v : judge_collapses(s, a, b, l, {}))
      if (v.corner >= 0 && v.refused != Refusal::topology) visit(a, b, v);
  }
}

/// Of uneven sheets: no triangle below both 0.3 and the worst of before.
RC_GTEST_PROP(Collapse, is_rejected_for_the_quality_that_it_would_leave, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.35)));
  const mesh::Surface& s = rock.surface;
  visit_places(s, lax(), [&](int a, int b, const CollapseVerdict& v) {
    const double worst = worst_of(remaining_rock_of(s, a, b, v.x_W)), floor = floor_of(s, a, b);
    if (std::abs(worst - floor) < 1e-12) return;
    RC_ASSERT(v.refused == (worst < floor ? std::optional(Refusal::quality) : std::nullopt));
  });
}

/// Where quality does not count: no new edge longer than the limit.
RC_GTEST_PROP(Collapse, is_rejected_for_the_longest_edge_that_it_would_make, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.35)));
  const mesh::Surface& s = rock.surface;
  MaintenanceLimits l = lax();
  l.longest_edge = *battery::number(0.4, 0.8);
  visit_places(s, l, [&](int a, int b, const CollapseVerdict& v) {
    const std::vector<mesh::Facet> left = remaining_rock_of(s, a, b, v.x_W);
    if (worst_of(left) < floor_of(s, a, b)) return;
    RC_ASSERT(v.refused == (longest_at(left, v.x_W) > l.longest_edge
                                ? std::optional(Refusal::too_long)
                                : std::nullopt));
  });
}

double distance_from(const std::vector<mesh::Facet>& facets, const Vec3& x_W) {
  double least = 1e300;
  for (const mesh::Facet& f : facets)
    least = std::min(least, reference::distance_to_triangle(x_W, f.a, f.b, f.c));
  return least;
}

/// How far a collapse moves the surface: of the ends and the middles of the old edges from the new triangles, and of the
/// middles of the new edges from the old ones.
double strayed_by_hand(const mesh::Surface& s, int a, int b, const Vec3& x_W) {
  const std::vector<mesh::Facet> left = remaining_rock_of(s, a, b, x_W);
  std::vector<mesh::Facet> old;
  double farthest =
      std::max(distance_from(left, s.position(a)), distance_from(left, s.position(b)));
  for (const mesh::Triangle& t : s.triangles) {
    if (std::ranges::count(t, a) + std::ranges::count(t, b) == 0) continue;
    old.push_back({s.position(t[0]), s.position(t[1]), s.position(t[2])});
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = t[k], w = t[(k + 1) % 3];
      if (v != a && v != b && w != a && w != b) continue;
      farthest = std::max(farthest, distance_from(left, 0.5 * (s.position(v) + s.position(w))));
    }
  }
  for (const mesh::Facet& f : left)
    for (const Vec3& y_W : {f.a, f.b, f.c})
      farthest = std::max(farthest, distance_from(old, 0.5 * (x_W + y_W)));
  return farthest;
}

/// Of every place that is allowed, and refused from there on.
RC_GTEST_PROP(Collapse, computes_how_far_it_moves_the_surface, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.35)));
  const mesh::Surface& s = rock.surface;
  visit_places(
      s, lax(),
      [&](int a, int b, const CollapseVerdict& v) {
        if (v.refused) return;
        const double strayed = strayed_by_hand(s, a, b, v.x_W);
        RC_ASSERT(std::abs(v.drift - strayed) < 1e-12);
        for (const double part : {0.999, 1.001}) {
          MaintenanceLimits l = lax();
          l.farthest = part * strayed;
          for (const CollapseVerdict& again : judge_collapses(s, a, b, l, {}))
            if (again.x_W == v.x_W)
              RC_ASSERT(again.refused ==
                        (part < 1.0 ? std::optional(Refusal::distance) : std::nullopt));
        }
      },
      71);
}

/// The reported volume is that of the hole; the three places are ordered by their change of volume,
/// and a place that changes more than allowed is rejected for that reason.
RC_GTEST_PROP(Collapse, computes_the_volume_of_each_place, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.3)));
  const mesh::Surface& s = rock.surface;
  MaintenanceLimits l = lax();
  l.volume_per_operation = *battery::number(0.0, 0.003);
  const double before = mesh::hole_volume(s, Vec3::Zero());
  double last = 0.0;
  int last_corner = -1;
  visit_places(s, l, [&](int a, int b, const CollapseVerdict& v) {
    mesh::Surface after = s;
    mesh::collapse_edge(after, v.corner, v.x_W);
    RC_ASSERT(std::abs(mesh::hole_volume(after, Vec3::Zero()) - before - v.volume) < 1e-14);
    RC_ASSERT((v.refused == Refusal::volume) == (std::abs(v.volume) > l.volume_per_operation));
    if (v.corner == last_corner) RC_ASSERT(std::abs(v.volume) >= last);
    last = std::abs(v.volume);
    last_corner = v.corner;
    const Vec3 &x_a = s.position(a), &x_b = s.position(b);
    RC_ASSERT(v.x_W == x_a || v.x_W == x_b || v.x_W == Vec3(0.5 * (x_a + x_b)));
  });
}

TEST(Collapse, of_a_boundary_vertex_is_rejected_by_name) {
  const mesh::Surface s = mesh::make_surface(battery::bumpy_rock(1.5, 10, 0.0, 7));
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    const bool is_at_boundary = s.is_boundary(a) || s.is_boundary(b);
    EXPECT_EQ(judge_collapse(s, a, b, lax()).refused == Refusal::boundary, is_at_boundary);
    EXPECT_EQ(judge_collapse(s, a, b, lax()).corner >= 0, !is_at_boundary);
  }
}

/// After random edits, which leave vertices of few neighbours.
RC_GTEST_PROP(Collapse, is_rejected_at_all_places_where_it_would_pinch, ()) {
  mesh::Surface s = mesh::make_surface(battery::bumpy_rock(1.0, 4, 0.1, 7));
  for (int k = 0; k < 60; ++k) mesh::random_edit(s, *battery::integer(0, 1 << 20));
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (!s.triangle_is_alive(c / 3)) continue;
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    if (s.is_boundary(a) || s.is_boundary(b)) continue;
    const bool pinches = !mesh::collapse_keeps_topology(s, mesh::corner_facing(s, a, b));
    RC_ASSERT((judge_collapse(s, a, b, lax()).refused == Refusal::topology) == pinches);
    for (const CollapseVerdict& v : judge_collapses(s, a, b, lax(), {}))
      RC_ASSERT((v.refused == Refusal::topology) == pinches);
  }
}

/// A neighbour of one vertex that is none of the other, nor the other itself.
int neighbour_of_one(const mesh::Surface& s, int one, int other) {
  const auto ring = [&](int v) {
    return std::vector<int>(s.ring(s.star(v)), s.ring(s.star(v)) + s.star(v).size);
  };
  const std::vector<int> of_other = ring(other);
  for (const int w : ring(one))
    if (w != other && std::ranges::count(of_other, w) == 0) return w;
  return -1;
}

/// What was moved before beside either end counts (M6).
TEST(Collapse, adds_to_the_largest_drift_around_its_ends) {
  const mesh::Surface s = mesh::make_surface(battery::bumpy_rock(1.5, 10, 0.2, 5));
  int asked = 0;
  for (int c = 0; c < 3 * s.triangle_slots(); c += 5) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    const CollapseVerdict alone = judge_collapse(s, a, b, lax());
    if (!is_accepted(alone)) continue;
    for (const int w : {neighbour_of_one(s, a, b), neighbour_of_one(s, b, a)}) {
      if (w < 0) continue;
      ++asked;
      SurfaceDrift drift;
      drift.note(w, 0.25);
      EXPECT_DOUBLE_EQ(judge_collapse(s, a, b, lax(), drift).drift, alone.drift + 0.25);
    }
  }
  EXPECT_GT(asked, 50);
}

/// Ridges and valleys side by side: whichever end of an edge between them stays, one is cut.
TEST(Collapse, between_a_sharp_ridge_and_a_sharp_valley_is_rejected_by_name) {
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
