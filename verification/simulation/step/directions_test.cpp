#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::directions_test {

/// What one reading of eq. 4.2 makes of the same rock.
struct Outcome {
  std::string stopped;         ///< why the run ended early; empty if it did not
  double turned = 0.0;         ///< revolutions
  double ledger = 0.0;         ///< worst defect of the volume ledger after any step, relative
  double volume = 0.0;         ///< removed in the last full revolution over pi R^2 d; nan if none
  double removed = 0.0;        ///< in all, m3
  double added = 0.0;          ///< rock that parts added in steps, m3
  double maintenance = 0.0;    ///< volume disturbed by maintenance, m3
  double growth = 0.0;         ///< triangles at the end over those at the start
  std::size_t pairs = 0;       ///< intersecting triangles (CGAL)
  long folds = 0;              ///< edges where the surface turns by more than 150 degrees
  double worst_quality = 0.0;  ///< of a triangle
};

/// Bit B on a coarse bottom that fits it.
Case drilling(const std::string& directions, const std::string& inside,
              std::vector<std::string> overrides) {
  overrides.insert(overrides.end(),
                   {"rock.edge_length=\"3 mm\"", "update.directions=\"" + directions + "\"",
                    "update.inside_cutters=\"" + inside + "\""});
  return read_case(std::string(TDBD_SOURCE_DIR) + "/cases/bit-b-steady.toml", overrides);
}

Vec3 normal(const mesh::Surface& s, int t) {
  const auto& [a, b, c] = s.triangles[t];
  return mesh::area_vector(s.position(a), s.position(b), s.position(c)).normalized();
}

long folds(const mesh::Surface& s) {
  const double limit = std::cos(150.0 / 180.0 * std::numbers::pi);
  long n = 0;
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (!s.triangle_is_alive(c / 3) || s.opposite_of(c) < c) continue;
    n += normal(s, c / 3).dot(normal(s, s.opposite_of(c) / 3)) < limit;
  }
  return n;
}

double worst_quality(const mesh::TriangleMesh& m) {
  double worst = 1.0;
  for (const auto& [a, b, c] : m.triangles)
    worst = std::min(worst, mesh::triangle_quality(m.positions[a], m.positions[b], m.positions[c]));
  return worst;
}

/// Removed in the last revolution that was completed, over pi R^2 d.
double last_revolution(const Case& c, const Simulation& s, double turned) {
  if (turned < 1.0) return std::nan("");
  const double r = c.bit.gage_radius;
  const double d = c.motion.rate_of_penetration * 2.0 * std::numbers::pi / c.motion.rotary_speed;
  const auto last = static_cast<std::size_t>(turned + 1e-9) - 1;
  const std::vector<double>& v = s.state.ledger.removed_by_revolution[last];
  return std::accumulate(v.begin(), v.end(), 0.0) / (std::numbers::pi * r * r * d);
}

/// Steps until the end or an error.
void drill_on(const Case& c, Simulation& s, Outcome& o) {
  try {
    while (s.state.steps_done < c.time.steps) {
      step(c, s);
      o.ledger = std::max(o.ledger, ledger_defect(s));
      for (const double v : s.state.cut.removed_by_part) o.added -= std::min(0.0, v);
    }
  } catch (const RunError& e) {
    o.stopped = e.what();
  }
}

Outcome drill(const Case& c) {
  Simulation s = start(c);
  Outcome o;
  drill_on(c, s, o);
  const mesh::TriangleMesh m = mesh::compact(s.state.rock.surface);
  const double time = c.time.step * static_cast<double>(s.state.steps_done);
  o.turned = angle_turned(c.motion, time) / (2.0 * std::numbers::pi);
  o.volume = last_revolution(c, s, o.turned);
  o.removed = s.state.ledger.removed.value();
  o.maintenance = s.state.maintenance.volume_disturbed;
  o.growth = static_cast<double>(m.triangles.size()) / static_cast<double>(s.state.start_triangles);
  o.pairs = reference::self_intersecting_pairs(m);
  o.folds = folds(s.state.rock.surface);
  o.worst_quality = worst_quality(m);
  return o;
}

void print(const Case& c, const char* reading, const Outcome& o) {
  std::printf("  %s, %.2f of %.2f revolutions %s\n", reading, o.turned,
              angle_turned(c.motion, c.time.step * static_cast<double>(c.time.steps)) /
                  (2.0 * std::numbers::pi),
              o.stopped.c_str());
  std::printf(
      "    removed %.4g cm3 (last revolution %.4f pi R^2 d), added %.2g cm3, "
      "maintenance %.2g cm3, ledger %.1e\n",
      1e6 * o.removed, o.volume, 1e6 * o.added, 1e6 * o.maintenance, o.ledger);
  std::printf("    triangles x %.2f, intersecting pairs %zu, folds %ld, worst quality %.3f\n",
              o.growth, o.pairs, o.folds, o.worst_quality);
}

/// Maintenance that keeps edges' lengths alone and heals no bad triangle, so that a mesh shows what
/// the directions did to it.
/// Without a rest, as the study measured: with one nothing folds, healed or not.
const std::vector<std::string> no_healing = {"maintenance.rest=0", "maintenance.worst_quality=0",
                                             "maintenance.flip_quality=0",
                                             "maintenance.smoothing=\"off\""};

/// 75 mm of hole: 9 revolutions at 8.3 mm each, as deep as 36 at the usual 2.1 mm.
Outcome deep_hole(const std::string& directions, std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.end(), {"time.revolutions=9", "time.step=\"5 ms\"",
                                     "motion.rate_of_penetration=\"60 m/h\""});
  const Case c = drilling(directions, "down", overrides);
  const Outcome o = drill(c);
  print(c, (directions + ", inside cutters down").c_str(), o);
  return o;
}

/// A third of a revolution from the conforming bottom.
Outcome first_third(const std::string& inside, std::vector<std::string> overrides = {}) {
  overrides.emplace_back("time.revolutions=0.34");
  const Case c = drilling("hybrid", inside, overrides);
  const Outcome o = drill(c);
  print(c, ("hybrid, inside cutters " + inside).c_str(), o);
  return o;
}

/// The default drills: nothing folds over, no rock is added, and the steady volume is that of the
/// gage's disc. The thesis' figures 4.7-4.9 compare it with the two extremes, which drill too, but
/// with worse meshes: straight down crowds the wall at the gage, along the profile the axis.
TEST(Directions, hybrid_drills_a_deep_hole_and_has_the_best_mesh) {
  const Outcome hybrid = deep_hole("hybrid");
  EXPECT_EQ(hybrid.stopped, "");
  EXPECT_LT(hybrid.ledger, tolerance::ledger);
  EXPECT_NEAR(hybrid.volume, 1.0, 4.4e-4);
  EXPECT_LT(hybrid.added, tolerance::ledger * hybrid.removed);
  EXPECT_LT(hybrid.maintenance, 5e-5 * hybrid.removed);
  EXPECT_EQ(hybrid.pairs, 0u);
  for (const char* extreme : {"all-down", "along-profile"}) {
    const Outcome o = deep_hole(extreme);
    EXPECT_LT(o.ledger, tolerance::ledger);
    EXPECT_NEAR(o.volume, 1.0, 3.3e-3);
    EXPECT_LT(o.worst_quality, hybrid.worst_quality);
  }
}

/// Without maintenance, "all-down" folds the surface; maintenance undoes most of these folds.
TEST(Directions, hybrid_folds_least_without_repair) {
  const Outcome hybrid = deep_hole("hybrid", no_healing);
  EXPECT_LE(hybrid.folds, 3);
  EXPECT_GE(deep_hole("along-profile", no_healing).folds, hybrid.folds);
  EXPECT_GT(deep_hole("all-down", no_healing).folds, 200);
}

/// e of eq. 4.2 straight down, and the two signs of [1, 0, 0] between which our excerpt leaves the
/// choice. +X pushes the cone's vertices out of the rock: more rock is added than removed. -X
/// drills, but pushes them through the axis: the surface folds over, where nothing heals it.
TEST(Directions, of_inside_cutters_must_be_straight_down) {
  const Outcome down = first_third("down");
  EXPECT_EQ(down.stopped, "");
  EXPECT_EQ(down.pairs, 0u);
  EXPECT_EQ(down.folds, 0);
  EXPECT_LT(down.added, tolerance::ledger * down.removed);

  const Outcome plus_x = first_third("plus-x");
  EXPECT_LT(plus_x.removed, 0.0);
  EXPECT_GT(first_third("plus-x", no_healing).pairs, 1000u);

  const Outcome minus_x = first_third("minus-x", no_healing);
  EXPECT_GT(minus_x.pairs, 20u);
  EXPECT_GT(minus_x.folds, 20);

  for (const Outcome& o : {down, plus_x, minus_x}) EXPECT_LT(o.ledger, tolerance::ledger);
}

}  // namespace tdbd::simulation::directions_test
