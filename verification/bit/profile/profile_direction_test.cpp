#include "bit/profile/profile_direction.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"

namespace tdbd::bit::profile_direction_test {

std::vector<Part> parts_of_cutter(const Bit& bit, int cutter) {
  std::vector<Part> parts;
  for (const Part& part : bit.parts)
    if (part.cutter == cutter) parts.push_back(part);
  return parts;
}

/// Where the frame is known, both ways lead along the profile: a few degrees apart where the
/// profile bends or ends.
TEST(ProfileDirection, is_nearly_that_of_the_cutters_frame) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Bit bit = example_bit(letter);
    const auto profile = exposure_profile(bit.parts, 0.5e-3);
    for (int i = 0; i < static_cast<int>(bit.cutters.size()); ++i) {
      const Vec3 u = profile_direction(profile, parts_of_cutter(bit, i), DirectionRule::hybrid,
                                       InsideRule::down);
      const Vec3 expected =
          update_direction(bit.cutters[i].X_BC, DirectionRule::hybrid, InsideRule::down);
      EXPECT_GT(u.dot(expected), std::cos(8.0 * degree)) << letter << bit.cutters[i].id;
    }
  }
}

/// A part 10 mm wide at r = 50 mm.
Part ball() {
  Part part;
  part.X_BP.p = Vec3(30e-3, 40e-3, 0.0);
  part.mesh_P.positions = {{-5e-3, 0, 0}, {5e-3, 0, 0}, {0, 0, -5e-3}, {0, 0, 5e-3}};
  return part;
}

TEST(ProfileDirection, is_the_normal_of_a_straight_profile) {
  const auto along = [](const ProfilePoint& from, const ProfilePoint& to) {
    std::vector<ProfilePoint> line;
    for (int k = 0; k <= 100; ++k)
      line.push_back({std::lerp(from.r, to.r, k / 100.0), std::lerp(from.z, to.z, k / 100.0)});
    return profile_direction(line, {ball()}, DirectionRule::hybrid, InsideRule::minus_x);
  };
  const Vec3 slope = Vec3(1, 0, 1).normalized();
  EXPECT_LT((along({45e-3, 0.01}, {65e-3, -0.01}) - slope).norm(), 1e-12);
  EXPECT_LT((along({50e-3, 0.01}, {50e-3, -0.02}) - Vec3(1, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(along({0, 0.01}, {0.1, 0.01}), Vec3(-1, 0, 0));
}

/// A profile that is flat up to some way outside of the part's middle and rises there, as points
/// 0.3 mm apart. The part is 10 mm high: the first points 5 mm away are at 5.1 mm.
TEST(ProfileDirection, looks_as_far_to_both_sides_as_the_part_is_large) {
  const auto flat_up_to = [](double flat) {
    const double middle = 0.5 * (std::hypot(25e-3, 40e-3) + std::hypot(35e-3, 40e-3));
    std::vector<ProfilePoint> line;
    for (int k = -40; k <= 40; ++k)
      line.push_back({middle + 0.3e-3 * k, 0.01 - std::max(0.0, 0.3e-3 * k - flat)});
    return profile_direction(line, {ball()}, DirectionRule::along_profile, InsideRule::down);
  };
  EXPECT_LT((flat_up_to(5.2e-3) - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((flat_up_to(4.9e-3) - Vec3(0.2, 0.0, 10.2).normalized()).norm(), 1e-12);
}

/// Saw teeth of 45 degrees, 2 mm apart, on a flat profile: their own normals are far from down.
TEST(ProfileDirection, averages_scallops_out) {
  std::vector<ProfilePoint> line;
  for (int k = 0; k <= 400; ++k) line.push_back({k * 0.25e-3, 0.01 + 0.25e-3 * (k % 8)});
  const Vec3 u = profile_direction(line, {ball()}, DirectionRule::along_profile, InsideRule::down);
  EXPECT_GT(u.z(), std::cos(12.0 * degree));
}

}  // namespace tdbd::bit::profile_direction_test
