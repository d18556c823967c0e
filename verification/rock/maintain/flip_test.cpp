#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mesh/measures.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/limits.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/maintain/operations.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::flip_test {

MaintenanceLimits limits() {
  MaintenanceLimits l = bare_limits_for(0.35);
  l.flip_quality = 1.0;
  return l;
}

double worse_quality(const mesh::Surface& s, int c) {
  return std::min(quality(facet_at(s, c)), quality(facet_at(s, s.opposite_of(c))));
}

/// Every flip raises the worse of the two qualities, keeps M1, M4, M5, M6 and M7.
RC_GTEST_PROP(Flip, raises_the_worse_quality_and_keeps_the_promises, ()) {
  Rock rock = rock_of(any_sheet(0.4));
  const MaintenanceLimits l = limits();
  int flips = 0;
  for (int c = 0; c < 3 * rock.surface.triangle_slots(); ++c) {
    Rock before = rock;
    SurfaceDrift drift;
    MaintenanceReport report;
    if (!try_flip(rock, c, l, drift, report)) continue;
    ++flips;
    before.touched = rock.touched;
    RC_ASSERT(worse_quality(rock.surface, mesh::next_corner(c)) > worse_quality(before.surface, c));
    RC_ASSERT(describe(check_disc(rock)) == "");
    RC_ASSERT(describe(check_ledger(before.surface, rock.surface, report.volume_change)) == "");
    RC_ASSERT(describe(check_distance(before.surface, rock.surface, l)) == "");
    RC_ASSERT(describe(check_locality(before, rock.surface)) == "");
  }
  RC_TAG(flips > 0 ? "flips" : "nothing to do");
}

/// Two triangles over a square's diagonal with the other corners pulled together along it: the flip
/// is wanted. Lifted corners make a ridge of the diagonal, or too large a volume.
struct Kite {
  mesh::TriangleMesh m;
  Rock rock() const { return rock_of(m); }
  static int diagonal(const Rock& r) {
    int c = 0;
    while (r.surface.opposite_of(c) < 0) ++c;
    return c;
  }
};

Kite kite(double lift) {
  Kite k;
  k.m.positions = {{-0.3, 0.0, -lift}, {0.3, 0.0, -lift}, {0.0, 0.12, 0.0}, {0.0, -0.12, 0.0}};
  k.m.triangles = {{0, 2, 1}, {1, 3, 0}};
  return k;
}

std::optional<Refusal> refused(const Kite& k, const MaintenanceLimits& l) {
  const Rock r = k.rock();
  return judge_flip(r.surface, Kite::diagonal(r), l).refused;
}

TEST(Flip, of_a_flat_kite_is_accepted) { EXPECT_EQ(refused(kite(0.0), limits()), std::nullopt); }

TEST(Flip, of_the_better_diagonal_is_rejected) {
  Rock r = kite(0.0).rock();
  SurfaceDrift drift;
  MaintenanceReport report;
  ASSERT_TRUE(try_flip(r, Kite::diagonal(r), limits(), drift, report));
  EXPECT_EQ(judge_flip(r.surface, Kite::diagonal(r), limits()).refused, Refusal::quality);
}

TEST(Flip, that_cuts_a_ridge_or_changes_too_much_is_rejected_by_name) {
  MaintenanceLimits l = limits();
  l.volume_per_operation = 1.0;
  l.sharp_cosine = 0.95;  // the kite's sides meet at 28 degrees for a lift of 0.03
  EXPECT_EQ(refused(kite(0.03), l), Refusal::ridge);
  l.sharp_cosine = -1.0;
  EXPECT_EQ(refused(kite(0.03), l), std::nullopt);
  l.farthest = 0.02;
  EXPECT_EQ(refused(kite(0.03), l), Refusal::distance);
  l.volume_per_operation = 1e-6;
  EXPECT_EQ(refused(kite(0.03), l), Refusal::volume);
  l.longest_edge = 0.2;
  EXPECT_EQ(refused(kite(0.03), l), Refusal::too_long);
  l = limits();
  l.shortest_edge = 0.25;
  EXPECT_EQ(refused(kite(0.0), l), Refusal::too_short);
  l = limits();
  l.least_normal_cosine = 0.999;
  EXPECT_EQ(refused(kite(0.03), l), Refusal::normal);
}

/// Everything is allowed but to leave the triangles no better.
MaintenanceLimits lax() {
  MaintenanceLimits l = limits();
  l.shortest_edge = 0.0;
  l.longest_edge = l.volume_per_operation = l.farthest = l.ridge_cut = 1e3;
  l.least_normal_cosine = -1.0;
  l.steepest_overhang = 2.0;
  l.flip_quality = 2.0;  // no triangle is so good that its flip may change no volume
  return l;
}

/// Distance between the lines through two pairs of points, by the foot points on both.
double distance_of_lines(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q) {
  Eigen::Matrix<double, 3, 2> A;
  A << b - a, p - q;
  const Eigen::Vector2d x = A.colPivHouseholderQr().solve(p - a);
  return (A * x - (p - a)).norm();
}

/// An inner edge that may be flipped, found independently.
struct Edge {
  int c;
  Vec3 a, b, p, q;
  double before, after, volume, distance;
};

template <class Visit>
void visit_edges(const mesh::Surface& s, Visit&& visit) {
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (s.opposite_of(c) < 0) continue;
    Edge e{c,
           s.position(s.vertex(mesh::next_corner(c))),
           s.position(s.vertex(mesh::previous_corner(c))),
           s.position(s.vertex(c)),
           s.position(s.vertex(s.opposite_of(c))),
           0,
           0,
           0,
           0};
    e.before =
        std::min(mesh::triangle_quality(e.p, e.a, e.b), mesh::triangle_quality(e.q, e.b, e.a));
    e.after =
        std::min(mesh::triangle_quality(e.p, e.a, e.q), mesh::triangle_quality(e.q, e.b, e.p));
    e.volume = std::abs((e.b - e.a).cross(e.p - e.a).dot(e.q - e.a)) / 6.0;
    e.distance = distance_of_lines(e.a, e.b, e.p, e.q);
    visit(e);
  }
}

/// The worse of the two must gain a tenth.
RC_GTEST_PROP(Flip, is_rejected_unless_the_worse_triangle_gains, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.4)));
  visit_edges(rock.surface, [&](const Edge& e) {
    if (std::abs(e.after / e.before - 1.1) < 1e-9) return;
    const auto refused = judge_flip(rock.surface, e.c, lax()).refused;
    if (refused == Refusal::topology) return;
    RC_ASSERT(refused ==
              (e.after > 1.1 * e.before ? std::nullopt : std::optional(Refusal::quality)));
  });
}

/// Each limit alone, where the quality gains. The better the triangles already are, the less volume may change.
RC_GTEST_PROP(Flip, is_rejected_for_lengths_volume_and_distance_beyond_their_limits, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.4)));
  constexpr double close =
      1e-6;  // of a limit: rounding decides, also of volumes of thin tetrahedra
  const auto judge = [&](int c, double figure, double MaintenanceLimits::*limit, Refusal why,
                         double sign) {
    for (const double part : {1.0 - close, 1.0 + close}) {
      MaintenanceLimits l = lax();
      l.*limit = part * figure;
      const bool is_beyond = sign * (part - 1.0) < 0.0;
      RC_ASSERT(judge_flip(rock.surface, c, l).refused ==
                (is_beyond ? std::optional(why) : std::nullopt));
    }
  };
  visit_edges(rock.surface, [&](const Edge& e) {
    if (judge_flip(rock.surface, e.c, lax()).refused) return;
    const double length = (e.q - e.p).norm();
    judge(e.c, length, &MaintenanceLimits::longest_edge, Refusal::too_long, 1.0);
    judge(e.c, length, &MaintenanceLimits::shortest_edge, Refusal::too_short, -1.0);
    if (e.distance < 1e-3) return;
    RC_ASSERT(std::abs(judge_flip(rock.surface, e.c, lax()).drift - e.distance) < 1e-12);
    judge(e.c, e.volume / (1.0 - e.before / 2.0), &MaintenanceLimits::volume_per_operation,
          Refusal::volume, 1.0);
    judge(e.c, e.distance, &MaintenanceLimits::farthest, Refusal::distance, 1.0);
    if (is_sharp(rock.surface, e.c, lax()))
      judge(e.c, e.distance, &MaintenanceLimits::ridge_cut, Refusal::ridge, 1.0);
  });
}

/// Both new neighbours have the drift, and all four corners are touched.
TEST(Flip, notes_its_drift_at_the_new_edge_and_touches_its_corners) {
  Rock r = kite(0.005).rock();
  const int c = Kite::diagonal(r);
  const double expected = judge_flip(r.surface, c, limits()).drift;
  EXPECT_NEAR(expected, 0.005, 1e-15);
  SurfaceDrift drift;
  MaintenanceReport report;
  ASSERT_TRUE(try_flip(r, c, limits(), drift, report));
  EXPECT_EQ(drift.of(2), expected);
  EXPECT_EQ(drift.of(3), expected);
  EXPECT_EQ(drift.of(0), 0.0);
  EXPECT_EQ(drift.of(1), 0.0);
  std::ranges::sort(r.touched_list);
  EXPECT_EQ(r.touched_list, (std::vector{0, 1, 2, 3}));
}

TEST(Flip, is_rejected_once_the_maintenance_has_moved_the_surface_far) {
  const Rock r = kite(0.005).rock();
  SurfaceDrift drift;
  EXPECT_EQ(judge_flip(r.surface, Kite::diagonal(r), limits(), drift).refused, std::nullopt);
  drift.note(2, 0.99 * limits().farthest);
  EXPECT_EQ(judge_flip(r.surface, Kite::diagonal(r), limits(), drift).refused, Refusal::distance);
  drift.clear();
  EXPECT_EQ(judge_flip(r.surface, Kite::diagonal(r), limits(), drift).refused, std::nullopt);
}

}  // namespace tdbd::rock::flip_test

namespace tdbd::rock::blunt_test {

constexpr int tip = 60;  // the middle of 11 x 11 vertices

/// Flat rock of edges 0.3 with one vertex drawn out to a spike.
Rock spiked(double height, double bump = 0.0) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, bump, 7);
  m.positions[tip].z() -= height;
  return rock_of(m);
}

/// L_min is 0.8: the triangles at a vertex, 0.27 in all, are less than its square.
MaintenanceLimits limits() { return bare_limits_for(2.0); }

/// Every maintenance may lower it by L_min / 2; in the end the tip is no spike any more.
RC_GTEST_PROP(Blunt, lowers_a_spike_straight_down_and_accounts_for_it, ()) {
  Rock rock = spiked(*battery::number(0.5, 3.0), 0.2);
  RC_ASSERT(judge_blunt(rock.surface, tip, limits()).is_spike);
  for (int k = 0; k < 20 && judge_blunt(rock.surface, tip, limits()).is_spike; ++k) {
    const Rock before = rock;
    SurfaceDrift drift;
    MaintenanceReport report;
    RC_ASSERT(try_blunt(rock, tip, limits(), drift, report));
    const Vec3 way = rock.surface.position(tip) - before.surface.position(tip);
    RC_ASSERT(way.x() == 0.0 && way.y() == 0.0 && way.z() > 0.0);
    RC_ASSERT(way.z() <= limits().farthest * (1.0 + 1e-12));
    RC_ASSERT(report.volume_change > 0.0);
    RC_ASSERT(describe(check_ledger(before.surface, rock.surface, report.volume_change)) == "");
    RC_ASSERT(describe(check_normals(before.surface, rock.surface)) == "");
    RC_ASSERT(!try_blunt(rock, tip, limits(), drift, report) || drift.of(tip) <= limits().farthest);
  }
  RC_ASSERT(!judge_blunt(rock.surface, tip, limits()).is_spike);
}

TEST(Blunt, leaves_alone_what_is_low_or_wide_or_no_tip) {
  EXPECT_FALSE(judge_blunt(spiked(0.39).surface, tip, limits()).is_spike);
  EXPECT_FALSE(judge_blunt(spiked(2.0).surface, tip, bare_limits_for(1.0)).is_spike);
  EXPECT_FALSE(judge_blunt(spiked(2.0).surface, tip + 1, limits()).is_spike);
}

TEST(Blunt, touches_all_around_the_tip_and_nothing_where_there_is_none) {
  Rock rock = spiked(2.0);
  SurfaceDrift drift;
  MaintenanceReport report;
  EXPECT_FALSE(try_blunt(rock, tip + 1, limits(), drift, report));
  EXPECT_TRUE(rock.touched_list.empty());
  ASSERT_TRUE(try_blunt(rock, tip, limits(), drift, report));
  const mesh::VertexStar& star = rock.surface.star(tip);
  std::vector<int> expected(rock.surface.ring(star), rock.surface.ring(star) + star.size);
  expected.push_back(tip);
  std::ranges::sort(expected);
  std::ranges::sort(rock.touched_list);
  EXPECT_EQ(rock.touched_list, expected);
}

/// Maintenance finds the tip among the corners of what was touched.
TEST(Blunt, is_part_of_maintenance) {
  Rock rock = spiked(2.0);
  touch(rock, tip);
  const double before = rock.surface.position(tip).z();
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(rock, limits(), work, report);
  EXPECT_EQ(report.carried_out(Operation::blunting), 1);
  for (const long refused : report.refused[static_cast<std::size_t>(Operation::blunting)])
    EXPECT_EQ(refused, 0);  // tested once, although many triangles have the tip
  EXPECT_GT(rock.surface.position(tip).z(), before);  // z down
}

TEST(Blunt, is_rejected_by_name) {
  const Rock rock = spiked(2.0);
  MaintenanceLimits l = limits();
  l.volume_per_operation = 1e-6;
  EXPECT_EQ(judge_blunt(rock.surface, tip, l).refused, Refusal::volume);
  SurfaceDrift drift;
  drift.note(tip, limits().farthest);
  EXPECT_EQ(judge_blunt(rock.surface, tip, limits(), drift).refused, Refusal::distance);
}

}  // namespace tdbd::rock::blunt_test
