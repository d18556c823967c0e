#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::simulation::trimming_test {

Case core(const std::string& trim) {
  return read_case(TDBD_SOURCE_DIR "/cases/core.toml",
                   {"rock.edge_length='4 mm'", "rock.wall='90 mm'", "rock.trim=" + trim});
}

/// The least and the greatest z of what cuts, m, down.
std::pair<double, double> heights_of_what_cuts(const bit::Bit& bit) {
  std::pair<double, double> z{1.0, -1.0};
  for (const bit::Part& p : bit.parts) {
    if (p.cutting != bit::Cutting::cuts) continue;
    for (const Vec3& x : p.mesh_P.positions) {
      z.first = std::min(z.first, (p.X_BP * x).z());
      z.second = std::max(z.second, (p.X_BP * x).z());
    }
  }
  return z;
}

TEST(TrimHeight, is_that_far_above_the_lowest_place_that_cuts) {
  EXPECT_EQ(trim_height(core("0")), 0.0);
  const Case c = core("0.085");
  const auto [top, bottom] = heights_of_what_cuts(c.bit);
  ASSERT_LT(top, bottom);
  EXPECT_NEAR(trim_height(c), 0.085 - bottom, 1e-15);
}

/// All that cuts, and four edges of wall above it.
TEST(TrimHeight, leaves_four_edges_of_wall_above_the_highest_place_that_cuts) {
  Case c = core("0.085");
  const auto [top, bottom] = heights_of_what_cuts(c.bit);
  const double least = bottom - top + 4.0 * 4e-3;
  c.rock.trim = least + 1e-6;
  EXPECT_NO_THROW(trim_height(c));
  c.rock.trim = least - 1e-6;
  EXPECT_THROW(trim_height(c), InputError);
}

const Case& walled() {
  static const Case c = core("0");
  return c;
}

struct Wall {
  rock::Rock rock;
  rock::MaintenanceLimits limits;
  rock::TrimWorkspace work;
  Trimming trimming;
  double top = 0.0;  ///< m, of the wall

  Wall() {
    static const Simulation begun = start(walled());
    rock = begun.state.rock;
    limits = begun.work.limits;
    const mesh::Surface& surface = rock.surface;
    for (int v = 0; v < surface.vertex_slots(); ++v)
      if (surface.is_alive(v)) top = std::min(top, surface.position(v).z());
  }
  double cut(double depth) {
    return trim(walled().rock.edge_length, top + depth, limits, rock, trimming, work);
  }
  double hole() const { return mesh::hole_volume(rock.surface, Vec3::Zero()); }
  long triangles() const { return rock.surface.triangle_count(); }
};

TEST(Trim, acts_when_the_plane_has_moved_an_edge_further) {
  Wall wall;
  const long all = wall.triangles();
  EXPECT_GT(wall.cut(0.02), 0.0);
  EXPECT_DOUBLE_EQ(wall.trimming.done_W, wall.top + 0.02);
  EXPECT_GT(wall.trimming.triangles, 0);
  EXPECT_EQ(wall.triangles(), all - wall.trimming.triangles);
  const long before = wall.triangles();
  EXPECT_EQ(wall.cut(0.02 + 0.0039), 0.0);
  EXPECT_EQ(wall.triangles(), before);
  EXPECT_DOUBLE_EQ(wall.trimming.done_W, wall.top + 0.02);
  EXPECT_GT(wall.cut(0.02 + 0.0041), 0.0);
  EXPECT_EQ(wall.triangles(), all - wall.trimming.triangles);
}

/// However it goes down, the ledger has what the hole has lost, and at the end stands the same wall.
RC_GTEST_PROP(Trim, in_steps_removes_the_same_as_at_once, ()) {
  Wall at_once, in_steps;
  const double hole = at_once.hole(), depth = *battery::number(0.03, 0.05);
  const double taken = at_once.cut(depth);
  double sum = 0.0;
  for (double d = *battery::number(0.0, 0.01); d < depth - 0.004;
       d += *battery::number(0.002, 0.01))
    sum += in_steps.cut(d);
  sum += in_steps.cut(depth);
  constexpr double rounding = 1e-12;  // of the hole
  RC_ASSERT(std::abs(hole - taken - at_once.hole()) < rounding * std::abs(hole));
  RC_ASSERT(std::abs(hole - sum - in_steps.hole()) < rounding * std::abs(hole));
  RC_ASSERT(at_once.triangles() == in_steps.triangles());
  RC_ASSERT(std::abs(taken - sum) < rounding * std::abs(hole));
}

}  // namespace tdbd::simulation::trimming_test
