#include "rock/maintain/blunt.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/measures.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::blunt_test {

constexpr int tip = 60;  // the middle of 11 x 11 vertices

/// Flat rock of edges 0.3 with one vertex drawn out to a spike.
Rock spiked(double height, double bump = 0.0) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, bump, 7);
  m.positions[tip].z() -= height;
  return rock_of(m);
}

/// L_min is 0.8: the triangles at a vertex, 0.27 in all, are less than its square.
MaintenanceLimits limits() { return limits_for(2.0); }

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
  EXPECT_FALSE(judge_blunt(spiked(2.0).surface, tip, limits_for(1.0)).is_spike);
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
    EXPECT_EQ(refused, 0);  // asked once, though many triangles have the tip
  EXPECT_GT(rock.surface.position(tip).z(), before);  // z down
}

TEST(Blunt, is_refused_by_name) {
  const Rock rock = spiked(2.0);
  MaintenanceLimits l = limits();
  l.volume_per_operation = 1e-6;
  EXPECT_EQ(judge_blunt(rock.surface, tip, l).refused, Refusal::volume);
  SurfaceDrift drift;
  drift.note(tip, limits().farthest);
  EXPECT_EQ(judge_blunt(rock.surface, tip, limits(), drift).refused, Refusal::distance);
}

}  // namespace tdbd::rock::blunt_test
