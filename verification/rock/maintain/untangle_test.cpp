#include "rock/maintain/untangle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reference/mesh/self_intersections.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::untangle_test {

constexpr double edge = 0.3;

std::size_t pairs_in(const Rock& rock) {
  return reference::self_intersecting_pairs(mesh::compact(rock.surface));
}

/// An uneven sheet of which one vertex was carried past its neighbours, by 1 to 1.6 edges along the
/// sheet and up to a fifth out of it: what a part does to rock that it takes along a wall by more
/// than an edge at once.
Rock tangled(std::uint64_t seed) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.2, seed));
  const double turn = 2.399963 * static_cast<double>(seed);  // the golden angle: all directions
  const double far = edge * (1.0 + 0.1 * static_cast<double>(seed % 7));
  const double out = 0.1 * edge * static_cast<double>(static_cast<int>(seed % 5) - 2);
  const int middle = 5 * 11 + 5;
  place_vertex(
      rock, middle,
      rock.surface.position(middle) + Vec3(far * std::cos(turn), far * std::sin(turn), out));
  touch_neighbours(rock, middle);
  return rock;
}

MaintenanceLimits limits() {
  MaintenanceLimits l = limits_for(edge);
  l.flip_quality = 0.6;
  l.smoothing = Smoothing::tangential;
  l.smooth_quality = 0.5;
  return l;
}

struct Outcome {
  std::size_t tangled = 0, left = 0;  ///< scenes with pairs, before and after maintenance
  std::string broken;
};

Outcome maintain_all(const MaintenanceLimits& l) {
  Outcome outcome;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Rock before = tangled(seed);
    Rock rock = before;
    MaintenanceWorkspace work;
    MaintenanceReport report;
    maintain(rock, l, work, report);
    outcome.tangled += pairs_in(before) > 0 ? 1U : 0U;
    outcome.left += pairs_in(rock) > 0 ? 1U : 0U;
    outcome.broken += describe(check_maintenance(before, rock, l, report, work.drift), 1);
  }
  return outcome;
}

/// Of 200 scenes; with the promises M1 to M3 and M5 to M7.
TEST(Untangle, parts_layers_that_pass_through_each_other) {
  MaintenanceLimits without = limits();
  without.untangle_farthest = 0.0;
  const Outcome off = maintain_all(without), on = maintain_all(limits());
  fmt::print("of {} tangled scenes {} stay so without untangling, {} with it\n", on.tangled,
             off.left, on.left);
  EXPECT_GT(on.tangled, 40U);
  EXPECT_GT(off.left, 20U);
  EXPECT_EQ(on.left, 0U);
  EXPECT_EQ(on.broken, "");
}

/// Where no place is near enough, the refusals say so, by name.
TEST(Untangle, counts_why_it_is_refused) {
  MaintenanceLimits l = limits();
  l.untangle_farthest = 1e-9;  // m: no collapse moves so little
  MaintenanceReport report;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Rock rock = tangled(seed);
    MaintenanceWorkspace work;
    maintain(rock, l, work, report);
  }
  const auto& why = report.refused[static_cast<std::size_t>(Operation::untangling)];
  EXPECT_GT(why[static_cast<std::size_t>(Refusal::distance)], 5);
  EXPECT_EQ(why[static_cast<std::size_t>(Refusal::intersection)], 0);
  EXPECT_EQ(report.carried_out(Operation::untangling), 0);
}

}  // namespace tdbd::rock::untangle_test
