#include "rock/maintain/untangle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/mesh/self_intersections.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::untangle_test {

constexpr double edge = 0.3;

std::size_t pairs_in(const Rock& rock) {
  return reference::self_intersecting_pairs(mesh::compact(rock.surface));
}

constexpr int middle = 5 * 11 + 5;

/// An uneven sheet of which one vertex was carried past its neighbours, by 1 to 1.6 edges along the
/// sheet and up to a fifth out of it: what a part does to rock that it takes along a wall by more
/// than an edge at once.
mesh::TriangleMesh tangled_mesh(std::uint64_t seed) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.2, seed);
  const double turn = 2.399963 * static_cast<double>(seed);  // the golden angle: all directions
  const double far = edge * (1.0 + 0.1 * static_cast<double>(seed % 7));
  const double out = 0.1 * edge * static_cast<double>(static_cast<int>(seed % 5) - 2);
  m.positions[middle] += Vec3(far * std::cos(turn), far * std::sin(turn), out);
  return m;
}

/// As rock, what changed being touched.
Rock tangled(const mesh::TriangleMesh& m) {
  Rock rock = rock_of(m);
  touch(rock, middle);
  touch_neighbours(rock, middle);
  return rock;
}

Rock tangled(std::uint64_t seed) { return tangled(tangled_mesh(seed)); }

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

/// The vertices that untangling removed.
std::vector<int> removed_from(const mesh::TriangleMesh& m) {
  Rock rock = tangled(m);
  MaintenanceLimits l = limits();
  l.flip_quality = 0.0;
  l.smoothing = Smoothing::off;
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(rock, l, work, report);
  if (report.carried_out(Operation::untangling) == 0) return {};
  std::vector<int> removed;
  for (int v = 0; v < static_cast<int>(m.positions.size()); ++v)
    if (!rock.surface.is_alive(v)) removed.push_back(v);
  return removed;
}

/// Triangles near the middle, each with each corner, come first in turn: corner 0 is a corner like others.
TEST(Untangle, does_not_depend_on_which_corner_comes_first) {
  int asked = 0;
  for (std::uint64_t seed = 0; asked < 4; ++seed) {
    const mesh::TriangleMesh m = tangled_mesh(seed);
    const std::vector<int> removed = removed_from(m);
    if (removed.empty()) continue;
    ++asked;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      if ((mesh::corners(m, t)[0] - m.positions[middle]).norm() > 3.0 * edge) continue;
      for (std::ptrdiff_t k = 0; k < 3; ++k) {
        mesh::TriangleMesh other = m;
        std::rotate(other.triangles[t].begin(), other.triangles[t].begin() + k,
                    other.triangles[t].end());
        std::swap(other.triangles[0], other.triangles[t]);
        EXPECT_EQ(removed_from(other), removed) << seed << " " << t << " " << k;
      }
    }
  }
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
