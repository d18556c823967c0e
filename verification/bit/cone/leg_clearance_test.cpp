#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone/legs.hpp"
#include "bit/cone_generate.hpp"
#include "bit/files/bit_reading.hpp"
#include "core/types.hpp"
#include "mesh/search/triangle_tree.hpp"

namespace tdbd::bit::leg_clearance_test {

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

/// A twin: turns the cones in steps and computes the distance of every corner of their teeth and
/// shells from the mesh of the leg. It is never less than the gap found, up to the tolerance.
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

TEST(LegClearance, is_reported_with_cone_angle_and_place) {
  const LegClearance c{
      "leg-1", "cone-2/row-4/tooth-1", 1.2034e-3, 30 * degree, {1e-3, 2e-3, -3e-3}};
  EXPECT_EQ(clearance_text(c),
            "a gap of 1.203 mm of leg-1 and cone-2/row-4/tooth-1 (at 30.0 deg) at (1.0, 2.0, -3.0) "
            "mm");
}

/// A ball of radius 1 as a meridian of many sides, its centre at s = 0.
Meridian ball(int sides) {
  Meridian m;
  for (int k = 0; k <= sides; ++k) {
    const double angle = pi * k / sides;
    m.push_back({-std::cos(angle), k == 0 || k == sides ? 0.0 : std::sin(angle)});
  }
  return m;
}

Pose any_pose(double distance) {
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  const Vec3 to(number(-1, 1), number(-1, 1), number(0.1, 1));
  return {q.normalized().toRotationMatrix(), distance * to.normalized()};
}

RC_GTEST_PROP(Meridian, computes_the_distance_from_a_cylinder, ()) {
  const Meridian cylinder = shell_meridian({{0.0, 1.0}, {4.0, 1.0}});
  const double r = number(0.0, 0.9), s = number(1.0, 3.0), out = number(0.1, 2.0);
  RC_ASSERT(std::abs(signed_distance(cylinder, {s, r}) - (r - 1.0)) < 1e-15);
  RC_ASSERT(std::abs(signed_distance(cylinder, {s, 1.0 + out}) - out) < 1e-15);
  RC_ASSERT(std::abs(signed_distance(cylinder, {-out, r}) - out) < 1e-15);
  RC_ASSERT(std::abs(signed_distance(cylinder, {4.0 + out, 1.0 + out}) - std::sqrt(2.0) * out) <
            1e-14);
}

/// Nothing of a tooth that turns with its cone comes out of its meridian.
RC_GTEST_PROP(Meridian, of_a_row_contains_what_its_teeth_sweep, ()) {
  const ToothShape t = any_tooth();
  const mesh::TriangleMesh m = tooth_mesh(t, 12);
  const Pose X_KT{Eigen::AngleAxisd(number(-pi, pi), Vec3::UnitY()).toRotationMatrix(),
                  Vec3(0.04, 0.0, number(-0.1, 0.1))};
  const Meridian swept = swept_meridian(m, X_KT);
  const mesh::Triangle side = *rc::gen::elementOf(m.triangles);
  const double a = number(0, 1), b = number(0, 1) * (1 - a);
  const Vec3 x_K = X_KT * (a * m.positions[static_cast<std::size_t>(side[0])] +
                           b * m.positions[static_cast<std::size_t>(side[1])] +
                           (1 - a - b) * m.positions[static_cast<std::size_t>(side[2])]);
  RC_ASSERT(signed_distance(swept, {-x_K.z(), std::hypot(x_K.x(), x_K.y())}) < 1e-15);
}

/// Where the tooth stands around its cone does not matter.
RC_GTEST_PROP(Meridian, of_a_row_is_the_same_all_around_the_cone, ()) {
  const mesh::TriangleMesh m = tooth_mesh(any_tooth(), 12);
  const Pose X_KT{Eigen::AngleAxisd(number(-pi, pi), Vec3::UnitY()).toRotationMatrix(),
                  Vec3(0.01, 0.0, number(-0.1, 0.1))};
  const Mat3 around = Eigen::AngleAxisd(number(-pi, pi), Vec3::UnitZ()).toRotationMatrix();
  const Meridian one = swept_meridian(m, X_KT),
                 other = swept_meridian(m, {around * X_KT.R, around * X_KT.p});
  for (const auto& [from, to] : {std::pair{&one, &other}, std::pair{&other, &one}})
    for (const ShellPoint& p : *from) RC_ASSERT(std::abs(signed_distance(*to, p)) < 1e-14);
}

constexpr double resolution = 1e-4;  ///< requested; scale: the radius of the balls
constexpr int sides = 48;
const double sagitta = 1.0 - std::cos(pi / sides / 2);  ///< of the polygon's sides

/// Two balls at a known distance, their axes anywhere: gap and depth of overlap.
RC_GTEST_PROP(MeridianGap, of_two_balls_is_known_to_the_resolution, ()) {
  const double distance = number(1.2, 4.0);
  const Meridian m = ball(sides);
  const Gap gap = smallest_gap(m, any_pose(0.0), m, any_pose(distance), resolution, INFINITY);
  RC_ASSERT(std::abs(gap.distance - (distance - 2.0)) < resolution + 2.0 * sagitta);
}

/// A sampled twin: no sample of A's surface is nearer to B than the gap.
RC_GTEST_PROP(MeridianGap, is_below_every_sample, ()) {
  const Meridian a = shell_meridian({{0.0, 0.2}, {1.0, 0.9}, {1.4, 0.5}}), b = ball(12);
  const Pose X_BA = any_pose(0.0), X_BB = any_pose(number(1.0, 2.5));
  const Gap gap = smallest_gap(a, X_BA, b, X_BB, resolution, INFINITY);
  double nearest = INFINITY;
  for (std::size_t i = 0; i + 1 < a.size(); ++i)
    for (int k = 0; k < 20; ++k)
      for (int turn = 0; turn < 60; ++turn) {
        const double t = k / 20.0, angle = 2 * pi * turn / 60;
        const double s = a[i].s + t * (a[i + 1].s - a[i].s), r = a[i].r + t * (a[i + 1].r - a[i].r);
        const Vec3 x = inverse(X_BB) * (X_BA * Vec3(r * std::cos(angle), r * std::sin(angle), -s));
        nearest = std::min(nearest, signed_distance(b, {-x.z(), std::hypot(x.x(), x.y())}));
      }
  RC_ASSERT(nearest >= gap.distance - resolution);
}

TEST(MeridianGap, stops_where_a_gap_is_large_enough) {
  const Meridian m = ball(sides);
  const Pose X_BA, X_BB{Mat3::Identity(), Vec3(0, 0, 5)};
  EXPECT_GE(smallest_gap(m, X_BA, m, X_BB, resolution, 1.0).distance, 1.0);
}

/// Two cylinders end to end: every patch of A's end is as near to B as every other, so that none can
/// be left out.
TEST(MeridianGap, gives_up_where_all_places_are_as_near) {
  const Meridian m = shell_meridian({{0.0, 1.0}, {1.0, 1.0}});
  const Pose X_BA, X_BB{Mat3::Identity(), Vec3(0, 0, 1.5)};
  const Gap gap = smallest_gap(m, X_BA, m, X_BB, 1e-7, INFINITY);
  EXPECT_FALSE(gap.is_exact);
  EXPECT_NEAR(gap.distance, 0.5, 1e-15);
}

}  // namespace tdbd::bit::leg_clearance_test
