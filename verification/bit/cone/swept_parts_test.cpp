#include "bit/cone/swept_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/part_pose.hpp"
#include "bit/cone_generate.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::swept_parts_test {

constexpr int segments = 180;

/// Its body cuts or does not.
Bit any_cone_bit() {
  ConeLayout cone = toothed_cone();
  cone.body = *rc::gen::element(Cutting::never, Cutting::cuts);
  return cone_bit("any", {cone}, std::nullopt, {0.05, 0.1});
}

double distance(const ProfilePoint& a, const ProfilePoint& b, double r, double z) {
  const Eigen::Vector2d along(b.r - a.r, b.z - a.z), from(r - a.r, z - a.z);
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(from.dot(along) / length2, 0.0, 1.0) : 0.0;
  return (from - t * along).norm();
}

/// How far a place lies outside of the profile, m; 0 inside.
double beyond(const std::vector<ProfilePoint>& profile, const Vec3& x_B) {
  const double r = x_B.head<2>().norm(), z = x_B.z();
  const auto next = std::ranges::upper_bound(profile, r, {}, &ProfilePoint::r);
  if (next != profile.end()) {
    const ProfilePoint &a = *(next - 1), &b = *next;
    if (z <= a.z + (r - a.r) / (b.r - a.r) * (b.z - a.z)) return 0.0;
  }
  double nearest = 1.0;
  for (std::size_t k = 1; k < profile.size(); ++k)
    nearest = std::min(nearest, distance(profile[k - 1], profile[k], r, z));
  return nearest;
}

/// No cutting part of a cone that turns comes out of the profile, and one comes to its end.
RC_GTEST_PROP(SweptParts, the_profile_holds_every_cutting_part_at_every_angle, ()) {
  const Bit bit = any_cone_bit();
  constexpr double spacing = 2e-4, slack = 3.7e-4;  // m: corners that rays and points cut off
  const auto profile = exposure_profile(swept_parts(bit, segments), spacing);
  EXPECT_NEAR(profile.back().r, bit.gage_radius, 1e-5);
  double farthest = 0.0;
  for (int k = 0; k < 6; ++k) {
    const Bit there = turned(bit, {number(-pi, pi)});
    for (const Part& part : there.parts)
      if (part.cutting == Cutting::cuts)
        for (const Vec3& x_P : part.mesh_P.positions)
          farthest = std::max(farthest, beyond(profile, part.X_BP * x_P));
  }
  RC_ASSERT(farthest < slack);
}

TEST(SweptParts, names_rows_and_keeps_their_reach) {
  ConeLayout layout;
  layout.journal_angle = 36 * degree;
  layout.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  ToothRow row;
  row.s = 0.04;
  row.angles = {0.0, 1.0, 2.0};
  layout.rows = {row, row};
  layout.rows[1].s = 0.08;
  const Bit bit = cone_bit("any", {layout}, std::nullopt, {0.05, 0.1});
  const std::vector<Part> swept = swept_parts(bit);
  ASSERT_EQ(swept.size(), 2u);  // neither the cone's body nor the shank cuts
  EXPECT_EQ(swept[0].name, "cone-1/row-1");
  double deepest = -1.0;
  for (const Part& part : swept)
    for (const Vec3& x_P : part.mesh_P.positions)
      deepest = std::max(deepest, (part.X_BP * x_P).z());
  EXPECT_NEAR(deepest, 0.0, 1e-15);
}

TEST(SweptParts, are_the_cutting_parts_of_a_bit_without_cones) {
  const Bit bit = example_bit('b');
  const auto profile = exposure_profile(bit.parts, 1e-3),
             swept = exposure_profile(swept_parts(bit), 1e-3);
  ASSERT_EQ(profile.size(), swept.size());
  for (std::size_t k = 0; k < profile.size(); ++k) {
    EXPECT_EQ(profile[k].r, swept[k].r);
    EXPECT_EQ(profile[k].z, swept[k].z);
  }
}

/// In full turns of their cones, the shipped bits reach every place of the bottom, the axis included.
TEST(SweptParts, of_shipped_bits_cover_the_whole_bottom) {
  constexpr double inside = 0.105, spacing = 2e-4;  // m
  const auto highest = [&](const std::string& name) {
    const auto profile = exposure_profile(
        swept_parts(read(TDBD_SOURCE_DIR "/cases/bits/" + name), segments), spacing);
    EXPECT_LT(profile.front().r, 1e-6);
    double height = 0.0;
    for (const ProfilePoint& p : profile)
      if (p.r < inside) height = std::max(height, -p.z);
    return height;
  };
  EXPECT_NEAR(highest("bit-r.toml"), 7.93e-3, 1e-4);
  EXPECT_NEAR(highest("bit-m.toml"), 11.05e-3, 1e-4);
}

}  // namespace tdbd::bit::swept_parts_test
