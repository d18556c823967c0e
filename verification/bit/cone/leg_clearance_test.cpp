#include "bit/cone/leg_clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_interference.hpp"
#include "bit/cone/legs.hpp"
#include "bit/cone/part_pose.hpp"
#include "bit/files/bit_reading.hpp"
#include "core/angles.hpp"
#include "mesh/search/inside.hpp"

namespace tdbd::bit::leg_clearance_test {
namespace {

Bit with_legs(const Legs& changed) {
  Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  std::erase_if(bit.parts, [](const Part& p) { return p.name.starts_with("leg-"); });
  EXPECT_TRUE(leg_faults(bit, changed).empty());
  add_legs(bit, changed);
  return bit;
}

Legs legs_of_r() { return read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml").legs; }

const LegClearance& between(const std::vector<LegClearance>& all, const std::string& leg,
                            const std::string& cone) {
  return *std::ranges::find_if(
      all, [&](const LegClearance& c) { return c.leg == leg && c.part.starts_with(cone + "/"); });
}

/// A leg's plane is parallel to the base of its own cone, so their gap is exactly the clearance.
TEST(LegClearance, is_that_of_the_file_from_a_legs_own_cone) {
  for (const double clearance : {1e-3, 2e-3, 3e-3}) {
    Legs legs = legs_of_r();
    legs.tip_radius = 0.038;
    legs.clearance = clearance;
    const std::vector<LegClearance> all = leg_clearances(with_legs(legs));
    for (const std::string k : {"1", "2", "3"}) {
      const LegClearance& own = between(all, "leg-" + k, "cone-" + k);
      EXPECT_NEAR(own.distance, clearance, clearance_tolerance);
      EXPECT_EQ(own.part, "cone-" + k + "/body");
    }
  }
}

/// For each of three legs and three cones one entry, sorted, none of them a clash; the place is on the leg.
TEST(LegClearance, is_found_for_every_leg_and_cone) {
  const Bit bit = with_legs(legs_of_r());
  const std::vector<LegClearance> all = leg_clearances(bit);
  ASSERT_EQ(all.size(), 9U);
  EXPECT_TRUE(std::ranges::is_sorted(all, {}, &LegClearance::distance));
  for (const LegClearance& c : all) {
    EXPECT_GT(c.distance, 0.0);
    const Part& leg = *std::ranges::find(bit.parts, c.leg, &Part::name);
    const mesh::TriangleMesh m = mesh_B(leg);
    EXPECT_LT(mesh::distance(mesh::TriangleTree(m), c.place_B), 1e-12);
  }
}

/// A twin: the teeth and shells themselves, the cones turned in steps, and the distance of every
/// corner of theirs from the leg's mesh. It is never less than the gap found, but for the tolerance.
TEST(LegClearance, is_never_more_than_that_of_turned_meshes) {
  const Bit bit = with_legs(legs_of_r());
  const std::vector<LegClearance> all = leg_clearances(bit);
  constexpr int steps = 24;
  for (int leg = 1; leg <= 3; ++leg) {
    const std::string name = "leg-" + std::to_string(leg);
    const mesh::TriangleMesh m = mesh_B(*std::ranges::find(bit.parts, name, &Part::name));
    const mesh::TriangleTree tree(m);
    for (int cone = 0; cone < 3; ++cone) {
      double nearest = 1e300;
      for (int k = 0; k < steps; ++k)
        for (const Part& part : bit.parts) {
          if (part.cone != cone) continue;
          const double phi = full_turn * k / steps / 12.0;
          const Pose X_BP = part_pose(bit, part, {phi, phi, phi});
          for (const Vec3& x : part.mesh_P.positions)
            nearest = std::min(nearest, mesh::distance(tree, X_BP * x));
        }
      const double found = between(all, name, "cone-" + std::to_string(cone + 1)).distance;
      EXPECT_LE(found, nearest + clearance_tolerance) << name << " " << cone;
      EXPECT_GT(found, nearest - 2.5e-3) << name << " " << cone;
    }
  }
}

/// A leg pushed through its cone's base by d overlaps it by d.
TEST(LegClearance, is_negative_by_the_depth_of_an_overlap) {
  Legs legs = legs_of_r();
  legs.clearance = -1.5e-3;
  const std::vector<LegClearance> all = leg_clearances(with_legs(legs));
  EXPECT_EQ(all.front().part, "cone-1/body");
  EXPECT_NEAR(all.front().distance, -1.5e-3, clearance_tolerance);
  EXPECT_EQ(clearance_text(all.front()).find("an overlap of 1.500 mm of leg-"), 0U)
      << clearance_text(all.front());
}

TEST(LegClearance, is_told_with_cone_angle_and_place) {
  const LegClearance c{
      "leg-1", "cone-2/row-4/tooth-1", 1.2034e-3, 30 * degree, {1e-3, 2e-3, -3e-3}};
  EXPECT_EQ(clearance_text(c),
            "a gap of 1.203 mm of leg-1 and cone-2/row-4/tooth-1 (at 30.0 deg) at (1.0, 2.0, -3.0) "
            "mm");
}

}  // namespace
}  // namespace tdbd::bit::leg_clearance_test
