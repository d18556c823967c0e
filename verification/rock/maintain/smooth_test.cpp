#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mesh/measures.hpp"
#include "reference/mesh/hausdorff.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/limits.hpp"
#include "rock/maintain/operations.hpp"
#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/untangle.hpp"
#include "rock/rock.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::smooth_test {

MaintenanceLimits limits() { return bare_limits_for(0.35); }

double volume(const Rock& rock) { return mesh::hole_volume(rock.surface, Vec3::Zero()); }

/// Fig. 4.22: a Laplacian step as it is flattens bumps; its part in the plane of the vector area
/// does not change the volume at all, however bumpy the rock.
RC_GTEST_PROP(Smooth, changes_no_volume, ()) {
  Rock rock = rock_of(any_sheet(0.3));
  MaintenanceLimits l = limits();
  l.volume_per_operation = l.farthest = 1.0;
  l.sharp_cosine = -1.0;
  SurfaceDrift drift;
  MaintenanceReport report;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    const double before = volume(rock);
    try_smooth(rock, v, l, drift, report);
    RC_ASSERT(std::abs(volume(rock) - before) < 1e-14);  // of 27 m3, the cube over the sheet
  }
  RC_ASSERT(report.carried_out(Operation::smoothing) > 5);
  RC_ASSERT(std::abs(report.volume_change) < 1e-14);
}

/// On flat rock nothing is refused but what does not raise the quality, or the boundary.
RC_GTEST_PROP(Smooth, keeps_flat_rock_flat_and_makes_it_better, ()) {
  mesh::TriangleMesh m = any_sheet(0.15);  // no triangle is turned over
  for (Vec3& x : m.positions) x.z() = 0.0;
  Rock rock = rock_of(m);
  SurfaceDrift drift;
  MaintenanceReport report;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    const double before = worst_quality(rock.surface, v);
    if (try_smooth(rock, v, limits(), drift, report))
      RC_ASSERT(worst_quality(rock.surface, v) > before);
    RC_ASSERT(rock.surface.position(v).z() == 0.0);
  }
  RC_ASSERT(report.carried_out(Operation::smoothing) > 5);
  RC_ASSERT(report.volume_disturbed == 0.0);
  const auto& why = report.refused[static_cast<std::size_t>(Operation::smoothing)];
  RC_ASSERT(why[static_cast<std::size_t>(Refusal::ridge)] == 0);
  RC_ASSERT(why[static_cast<std::size_t>(Refusal::distance)] == 0);
}

/// M4 and M7 of one smoothing, with the usual limits; and the distance within its bound.
RC_GTEST_PROP(Smooth, keeps_normals_boundary_and_distance, ()) {
  Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.4)));
  const MaintenanceLimits l = limits();
  int smoothed = 0;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    Rock before = rock;
    before.touched.assign(before.touched.size(), 0);
    before.touched[static_cast<std::size_t>(v)] = 1;
    SurfaceDrift drift;
    MaintenanceReport report;
    if (!try_smooth(rock, v, l, drift, report)) continue;
    ++smoothed;
    RC_ASSERT(!rock.surface.is_boundary(v));
    RC_ASSERT(describe(check_normals(before.surface, rock.surface)) == "");
    RC_ASSERT(describe(check_locality(before, rock.surface)) == "");
    RC_ASSERT(describe(check_distance(before.surface, rock.surface, l)) == "");
  }
  RC_PRE(smoothed > 0);  // most of uneven sheets' are refused
}

/// What smoothing at an inner vertex would do, computed independently: the mean of the neighbours,
/// without the part along the sum of the area vectors.
struct ByHand {
  Vec3 x_W;
  double worst_before = 1.0, worst_after = 1.0, shortest = 1e300, longest = 0.0, swept = 0.0;
  std::vector<mesh::Facet> before, after;
};

ByHand by_hand(const mesh::Surface& s, int v) {
  ByHand h;
  Vec3 sum = Vec3::Zero(), area = Vec3::Zero();
  for (mesh::Triangle t : s.triangles) {
    if (std::ranges::count(t, v) == 0) continue;
    std::ranges::rotate(t, std::ranges::find(t, v));
    const mesh::Facet f{s.position(t[0]), s.position(t[1]), s.position(t[2])};
    h.before.push_back(f);
    sum += f.b;
    area += mesh::area_vector(f.a, f.b, f.c);
  }
  const Vec3 way = sum / static_cast<double>(h.before.size()) - s.position(v),
             n = area.normalized();
  h.x_W = s.position(v) + way - n * n.dot(way);
  for (const mesh::Facet& f : h.before) {
    h.after.push_back({h.x_W, f.b, f.c});
    h.worst_before = std::min(h.worst_before, mesh::triangle_quality(f.a, f.b, f.c));
    h.worst_after = std::min(h.worst_after, mesh::triangle_quality(h.x_W, f.b, f.c));
    h.shortest = std::min(h.shortest, (f.b - h.x_W).norm());
    h.longest = std::max(h.longest, (f.b - h.x_W).norm());
    h.swept += std::abs((f.b - f.a).cross(f.c - f.a).dot(h.x_W - f.a)) / 6.0;  // tetrahedra
  }
  return h;
}

/// Of a place from the nearest of some triangles.
double distance_from(const std::vector<mesh::Facet>& facets, const Vec3& x_W) {
  double least = 1e300;
  for (const mesh::Facet& f : facets)
    least = std::min(least, reference::distance_to_triangle(x_W, f.a, f.b, f.c));
  return least;
}

/// Everything is allowed but to leave the triangles no better.
MaintenanceLimits lax() {
  MaintenanceLimits l = limits();
  l.shortest_edge = 0.0;
  l.longest_edge = l.volume_per_operation = l.farthest = 1e3;
  l.least_normal_cosine = l.sharp_cosine = -1.0;
  l.steepest_overhang = 2.0;
  return l;
}

/// Calls visit(v, independent result) for inner vertices of an uneven sheet.
template <class Visit>
void visit_inner(const mesh::Surface& s, Visit&& visit) {
  for (int v = 0; v < s.vertex_slots(); ++v)
    if (!s.is_boundary(v)) visit(v, by_hand(s, v));
}

/// The worst quality must rise by a fiftieth.
RC_GTEST_PROP(Smooth, is_rejected_unless_the_worst_triangle_gains, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.4)));
  visit_inner(rock.surface, [&](int v, const ByHand& h) {
    const SmoothVerdict found = judge_smooth(rock.surface, v, lax());
    RC_ASSERT((found.x_W - h.x_W).norm() < 1e-14);
    if (std::abs(h.worst_after / h.worst_before - 1.02) < 1e-9) return;
    RC_ASSERT(
        found.refused ==
        (h.worst_after > 1.02 * h.worst_before ? std::nullopt : std::optional(Refusal::quality)));
  });
}

/// Each limit alone, where the quality gains.
RC_GTEST_PROP(Smooth, is_rejected_for_lengths_volume_and_distance_beyond_their_limits, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.4)));
  const mesh::Surface& s = rock.surface;
  constexpr double close = 1e-9;  // of a limit: rounding decides
  const auto judge = [&](int v, double figure, double MaintenanceLimits::*limit, Refusal why,
                         double sign) {
    for (const double part : {1.0 - close, 1.0 + close}) {
      MaintenanceLimits l = lax();
      l.*limit = part * figure;
      const bool is_beyond = sign * (part - 1.0) < 0.0;
      RC_ASSERT(judge_smooth(s, v, l).refused == (is_beyond ? std::optional(why) : std::nullopt));
    }
  };
  visit_inner(s, [&](int v, const ByHand& h) {
    if (judge_smooth(s, v, lax()).refused) return;
    judge(v, h.longest, &MaintenanceLimits::longest_edge, Refusal::too_long, 1.0);
    judge(v, h.shortest, &MaintenanceLimits::shortest_edge, Refusal::too_short, -1.0);
    judge(v, h.swept, &MaintenanceLimits::volume_per_operation, Refusal::volume, 1.0);
    const double moved =
        std::max(distance_from(h.after, s.position(v)), distance_from(h.before, h.x_W));
    RC_ASSERT(std::abs(judge_smooth(s, v, lax()).drift - moved) < 1e-12);
    if (moved > 1e-4) judge(v, moved, &MaintenanceLimits::farthest, Refusal::distance, 1.0);
  });
}

/// What was moved before, at the vertex or beside it, counts too (M6).
TEST(Smooth, adds_to_the_largest_drift_around) {
  const Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.3, 4));
  int asked = 0;
  visit_inner(rock.surface, [&](int v, const ByHand&) {
    const SmoothVerdict alone = judge_smooth(rock.surface, v, lax());
    if (alone.refused) return;
    ++asked;
    SurfaceDrift drift;
    const mesh::VertexStar& star = rock.surface.star(v);
    drift.note(rock.surface.ring(star)[star.size - 1], 0.25);
    EXPECT_DOUBLE_EQ(judge_smooth(rock.surface, v, lax(), drift).drift, alone.drift + 0.25);
    drift.note(v, 0.5);
    EXPECT_DOUBLE_EQ(judge_smooth(rock.surface, v, lax(), drift).drift, alone.drift + 0.5);
  });
  EXPECT_GT(asked, 10);
}

/// A gable roof whose ridge runs along x: its vertices would slide, but may leave the ridge.
TEST(Smooth, leaves_a_sharp_ridge_alone) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.0, 7);
  for (Vec3& x : m.positions) x.z() = std::abs(x.y());
  Rock rock = rock_of(m);
  SurfaceDrift drift;
  MaintenanceReport report;
  int on_ridge = 0;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    const Vec3 x = rock.surface.position(v);
    if (std::abs(x.y()) > 1e-12 || rock.surface.is_boundary(v)) continue;
    ++on_ridge;
    EXPECT_EQ(judge_smooth(rock.surface, v, limits()).refused, Refusal::ridge);
    EXPECT_FALSE(try_smooth(rock, v, limits(), drift, report));
    EXPECT_EQ(rock.surface.position(v), x);
  }
  EXPECT_EQ(on_ridge, 9);
  EXPECT_EQ(report.refused[static_cast<std::size_t>(Operation::smoothing)]
                          [static_cast<std::size_t>(Refusal::ridge)],
            9);
}

TEST(Smooth, rejects_the_boundary) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.0, 7));
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (rock.surface.is_boundary(v)) {
      EXPECT_EQ(judge_smooth(rock.surface, v, limits()).refused, Refusal::boundary);
    }
}

}  // namespace tdbd::rock::smooth_test

namespace tdbd::rock::star_test {

MaintenanceLimits limits_with(double overhang) {
  MaintenanceLimits limits;
  limits.steepest_overhang = overhang;
  limits.least_normal_cosine = -1.0;  // any turn
  return limits;
}

/// z is down: a triangle whose normal points down hangs over. Areas in mm2 or m2 are judged alike.
RC_GTEST_PROP(JudgeTurn, depends_only_on_directions, ()) {
  MaintenanceLimits limits = limits_with(*battery::number(0.0, 0.5));
  limits.least_normal_cosine = *battery::number(-1.0, 1.0);
  const Vec3 before = *battery::point(1.0), after = *battery::point(1.0);
  const double small = std::pow(10.0, *battery::number(-9.0, 0.0)),
               large = std::pow(10.0, *battery::number(0.0, 3.0));
  RC_ASSERT(judge_turn(small * before, large * after, limits) == judge_turn(before, after, limits));
}

/// A unit normal that leans over by this sine.
Vec3 leaning(double sine) { return {std::sqrt(1.0 - sine * sine), 0.0, sine}; }

TEST(JudgeTurn, lets_upright_triangles_lean_a_little_and_others_not_at_all) {
  const MaintenanceLimits limits = limits_with(0.1);
  const auto judge = [&](double from, double to) {
    return judge_turn(1e-6 * leaning(from), 2e-6 * leaning(to), limits);
  };
  EXPECT_FALSE(judge(0.0, 0.09));
  EXPECT_EQ(judge(0.0, 0.11), Refusal::overhang);
  EXPECT_EQ(judge(0.09, 0.11), Refusal::overhang);
  EXPECT_FALSE(judge(0.11, 0.2));    // it hung over before
  EXPECT_FALSE(judge(-0.09, 0.05));  // it stood upright
  EXPECT_EQ(judge(-0.2, 0.05), Refusal::overhang);
  EXPECT_FALSE(judge(-0.2, -0.05));
}

TEST(JudgeTurn, rejects_to_turn_a_normal_far) {
  MaintenanceLimits limits = limits_with(2.0);
  limits.least_normal_cosine = 0.5;
  const Vec3 up(0.0, 0.0, -3e-6);
  EXPECT_FALSE(judge_turn(up, Vec3(0.8e-6, 0.0, -0.6e-6), limits));
  EXPECT_EQ(judge_turn(up, Vec3(0.9e-6, 0.0, -0.4e-6), limits), Refusal::normal);
}

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
  limits.worst_quality = 0.1;
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
  limits.worst_quality = 0.1;
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

}  // namespace tdbd::rock::star_test
