#include "rock/maintain/limits.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace tdbd::rock::limits_test {

/// rock (15) to (18), in edge lengths.
TEST(Limits, follow_the_edge_length) {
  constexpr double h = 0.002, just_below = 1.0 - 1e-9;
  const MaintenanceLimits l = limits_for(h);
  EXPECT_DOUBLE_EQ(l.shortest_edge, 0.4 * h);
  EXPECT_DOUBLE_EQ(l.longest_edge, 1.6 * h);
  EXPECT_DOUBLE_EQ(l.volume_per_operation, 0.01 * h * h * h);
  EXPECT_DOUBLE_EQ(l.untangle_volume, 0.2 * h * h * h);
  EXPECT_DOUBLE_EQ(l.ridge_cut, 0.05 * h);
  EXPECT_DOUBLE_EQ(l.farthest, just_below * 0.2 * h);
  EXPECT_DOUBLE_EQ(l.untangle_farthest, just_below * 0.8 * h);
}

TEST(Limits, of_another_shortest_edge_take_its_distances_along) {
  MaintenanceLimits l = limits_for(0.002);
  const MaintenanceLimits before = l;
  set_shortest_edge(l, 0.0001);
  EXPECT_EQ(l.shortest_edge, 0.0001);
  EXPECT_LT(l.farthest, 0.00005);
  EXPECT_NEAR(l.farthest, 0.00005, 1e-13);
  EXPECT_LT(l.untangle_farthest, 0.0002);
  EXPECT_NEAR(l.untangle_farthest, 0.0002, 4e-13);
  EXPECT_EQ(l.longest_edge, before.longest_edge);
  EXPECT_EQ(l.volume_per_operation, before.volume_per_operation);
}

MaintenanceReport report_of(int times) {
  MaintenanceReport r;
  for (int k = 0; k < times; ++k) {
    count_done(r, Operation::flip, -2e-9);
    count_done(r, Operation::bisection, 0.0);
    count_done(r, Operation::untangling, 3e-9);
    count_refused(r, Operation::flip, Refusal::normal);
    count_refused(r, Operation::flip, Refusal::normal);
    count_refused(r, Operation::bisection, Refusal::boundary);
    count_refused(r, Operation::untangling, Refusal::intersection);
  }
  r.touched_triangles = 7L * times;
  return r;
}

/// Volumes gained and lost cancel in the change, not in what was disturbed.
void expect_report(const MaintenanceReport& r, int times) {
  std::map<std::string, long> expected{{"flips", times},
                                       {"bisections", times},
                                       {"untanglings", times},
                                       {"refused_flips_normal", 2 * times},
                                       {"refused_bisections_boundary", times},
                                       {"refused_untanglings_intersection", times}};
  for (const auto& [name, count] : counts(r)) {
    EXPECT_EQ(count, expected[name]) << name;
    expected.erase(name);
  }
  EXPECT_TRUE(expected.empty());
  EXPECT_EQ(counts(r).size(), 6u + 6u * 11u);
  EXPECT_EQ(refusals(r), 4 * times);
  EXPECT_EQ(r.touched_triangles, 7 * times);
  EXPECT_DOUBLE_EQ(r.volume_change, 1e-9 * times);
  EXPECT_DOUBLE_EQ(r.volume_disturbed, 5e-9 * times);
}

TEST(MaintenanceReport, counts_operations_and_refusals_by_name_and_adds_up) {
  MaintenanceReport sum = report_of(1);
  expect_report(sum, 1);
  add(report_of(2), sum);
  expect_report(sum, 3);
}

}  // namespace tdbd::rock::limits_test
