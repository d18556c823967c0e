#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/tolerance.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/penetration.hpp"

namespace tdbd::simulation::nonconvex_test {

/// Drills 120 ms into a flat rock of 40 mm radius; after every cut no vertex is inside, and the
/// ledger closes at the end. Returns the volume that is gone, m3.
double drill(const mesh::TriangleMesh& tool_mm) {
  const auto folder = test_folder();
  const std::string bit = write_one_part_bit(folder, tool_mm, "kind = \"tooth\"\n");
  const Case c = read_case(
      write_case(folder, bit,
                 "shape = \"flat\"\nradius = \"40 mm\"\nwall = \"15 mm\"\nedge_length = \"1 mm\"",
                 "step = \"1 ms\"\nduration = \"120 ms\""),
      {});
  Simulation s = start(c);
  EXPECT_TRUE(s.work.cutting.groups[0].parts[0].tree_P.has_value());
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    if (s.state.steps_done % c.maintenance.every == 0)
      continue;  // new vertices wait for the next cut
    const Pose X_WB = pose_at(c.motion, c.time.step * static_cast<double>(s.state.steps_done));
    EXPECT_LE(deepest_penetration(s.state.rock, s.work.cutting, X_WB),
              tolerance::inside * s.work.cutting.size);
  }
  EXPECT_LE(ledger_defect(s), tolerance::ledger);
  return s.state.ledger.removed.value();
}

/// Depth of the tool after `drill`: 60 m/h for 120 ms.
constexpr double depth = 60.0 / 3600.0 * 0.12;

TEST(Nonconvex, a_ring_cuts_an_annular_groove) {
  constexpr double minor = 5e-3, major = 25e-3;
  const double half_angle = std::acos(1.0 - depth / minor);
  const double segment = minor * minor * (half_angle - 0.5 * std::sin(2.0 * half_angle));
  EXPECT_NEAR(drill(battery::torus(25.0, 5.0, 96, 48)) / (2.0 * std::numbers::pi * major * segment),
              1.0, 6.6e-3);
}

/// A U with its legs down turns about its middle: the legs cut a groove about a standing core.
TEST(Nonconvex, a_u_leaves_a_core) {
  const Mat3 legs_down =
      Eigen::AngleAxisd(std::numbers::pi / 2.0, Vec3::UnitX()).toRotationMatrix();
  const double removed = drill(battery::placed(
      {legs_down, Vec3::Zero()}, battery::prism(battery::u_outline(40.0, 10.0), -4.0, 4.0)));
  const double outer = 20e-3, inner = 10e-3;
  const double at_rest = 2 * 10e-3 * 8e-3 * depth;
  const double full_turn = std::numbers::pi * (outer * outer - inner * inner) * depth;
  EXPECT_GT(removed, at_rest);
  EXPECT_LT(removed, 1.1 * full_turn);
}

TEST(Nonconvex, an_l_cuts) {
  EXPECT_GT(drill(battery::prism(battery::l_outline(40.0, 12.0), -5.0, 5.0)), 0.0);
}

TEST(Nonconvex, a_star_cuts) {
  EXPECT_GT(drill(battery::prism(battery::star_outline(30.0, 10.0, 6), -5.0, 5.0)), 0.0);
}

}  // namespace tdbd::simulation::nonconvex_test
