#include "rock/maintain/flip.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/measures.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/star.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::flip_test {

MaintenanceLimits limits() {
  MaintenanceLimits l = limits_for(0.35);
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

TEST(Flip, of_the_better_diagonal_is_refused) {
  Rock r = kite(0.0).rock();
  SurfaceDrift drift;
  MaintenanceReport report;
  ASSERT_TRUE(try_flip(r, Kite::diagonal(r), limits(), drift, report));
  EXPECT_EQ(judge_flip(r.surface, Kite::diagonal(r), limits()).refused, Refusal::quality);
}

TEST(Flip, that_cuts_a_ridge_or_changes_too_much_is_refused_by_name) {
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

TEST(Flip, is_refused_once_the_maintenance_has_moved_the_surface_far) {
  const Rock r = kite(0.005).rock();
  SurfaceDrift drift;
  EXPECT_EQ(judge_flip(r.surface, Kite::diagonal(r), limits(), drift).refused, std::nullopt);
  drift.note(2, 0.99 * limits().farthest);
  EXPECT_EQ(judge_flip(r.surface, Kite::diagonal(r), limits(), drift).refused, Refusal::distance);
  drift.clear();
  EXPECT_EQ(judge_flip(r.surface, Kite::diagonal(r), limits(), drift).refused, std::nullopt);
}

}  // namespace tdbd::rock::flip_test
