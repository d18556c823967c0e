#include "bit/cone/part_pose.hpp"

#include <gtest/gtest.h>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone_generate.hpp"

namespace tdbd::bit::part_pose_test {

constexpr double rounding = 1e-14;  ///< of a few products of poses; scale: 1 and 1 m

/// The line through the cone's origin along its axis, and a turn about it by Rodrigues' formula.
Vec3 turned_about_journal(const Cone& cone, const Vec3& x_B, double angle) {
  const Vec3 s = cone.X_BK.R.col(2), d = x_B - cone.X_BK.p;
  return cone.X_BK.p + std::cos(angle) * d + std::sin(angle) * s.cross(d) +
         (1 - std::cos(angle)) * s.dot(d) * s;
}

RC_GTEST_PROP(PartPose, turns_every_part_of_a_cone_about_its_journal, ()) {
  const Bit bit = cone_bit("any", {toothed_cone(), toothed_cone()}, std::nullopt, {0.05, 0.1});
  const std::vector<double> angles{number(-50, 50), number(-50, 50)};
  const Bit there = turned(bit, angles);
  double farthest = 0.0;
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    const Part& part = bit.parts[i];
    const Vec3 x_P(0.01, -0.02, 0.03);
    Vec3 expected = part.X_BP * x_P;
    for (int k = 0; k < 2; ++k)
      if (part.cone == k)
        expected = turned_about_journal(bit.cones[static_cast<std::size_t>(k)], expected,
                                        angles[static_cast<std::size_t>(k)]);
    farthest = std::max(farthest, (part_pose(bit, part, angles) * x_P - expected).norm());
    farthest = std::max(farthest, (there.parts[i].X_BP * x_P - expected).norm());
  }
  RC_ASSERT(farthest < rounding);
}

}  // namespace tdbd::bit::part_pose_test
