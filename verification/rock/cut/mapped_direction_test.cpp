#include "rock/cut/mapped_direction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::mapped_direction_test {

/// One part with a core, in a bit that makes any small move.
struct Cored {
  bit::Bit bit;
  Pose X_WB0, X_WB1;
};

Cored any_cored() {
  Cored c;
  bit::Part& part = c.bit.parts.emplace_back();
  part.mesh_P = *battery::convex_polyhedron();
  part.X_BP = *battery::pose(2.0);
  part.core_P = bit::Segment{*battery::point(0.3), *battery::point(0.3)};
  part.update_direction_B = Vec3(0.6, 0.0, 0.8);
  c.X_WB0 = *battery::pose(1.0);
  c.X_WB1 = c.X_WB0 * Pose{Mat3::Identity(), 0.05 * *battery::direction()};
  return c;
}

/// Outwards, around and down in the bit frame at pose 1, of a vector at x.
Vec3 cylindrical(const Pose& X_WB1, const Vec3& x_W, const Vec3& u_W) {
  const Vec3 x_B = inverse(X_WB1) * x_W, u_B = X_WB1.R.transpose() * u_W;
  const Vec3 out = Vec3(x_B.x(), x_B.y(), 0.0).normalized();
  return {u_B.dot(out), u_B.dot(Vec3::UnitZ().cross(out)), u_B.z()};
}

RC_GTEST_PROP(MappedDirectionW, lies_in_the_half_plane_outwards_and_down, ()) {
  const Cored c = any_cored();
  const CuttingBit cutting = prepare_cutting_bit(c.bit);
  const GroupMotion m = group_motion(cutting.groups[0], c.X_WB0, c.X_WB1);
  const Vec3 x_W = c.X_WB1 * *battery::point(2.0);
  const Vec3 u = cylindrical(c.X_WB1, x_W, mapped_direction_W(cutting.groups[0], m, x_W));
  RC_ASSERT(u.x() >= -1e-15 && u.z() >= -1e-15);
  RC_ASSERT(std::abs(u.y()) < 1e-14);
  RC_ASSERT(std::abs(u.norm() - 1.0) < 1e-14);
}

/// The twin: the nearest of many points of the core, in space, halfway through the step.
RC_GTEST_PROP(MappedDirectionW, is_the_normal_about_the_core_where_that_points_out_and_down, ()) {
  Cored c = any_cored();
  c.X_WB1 = c.X_WB0;  // at rest: halfway is here
  const bit::Part& part = c.bit.parts[0];
  const CuttingBit cutting = prepare_cutting_bit(c.bit);
  const GroupMotion m = group_motion(cutting.groups[0], c.X_WB0, c.X_WB1);
  const Vec3 x_W = c.X_WB1 * *battery::point(2.0);
  constexpr int samples = 20000;
  Vec3 nearest_W = Vec3::Constant(1e9);
  for (int k = 0; k <= samples; ++k) {
    const Vec3 p_P = part.core_P->from +
                     static_cast<double>(k) / samples * (part.core_P->to - part.core_P->from);
    const Vec3 p_W = c.X_WB1 * (part.X_BP * p_P);
    if ((x_W - p_W).norm() < (x_W - nearest_W).norm()) nearest_W = p_W;
  }
  const Vec3 n = cylindrical(c.X_WB1, x_W, x_W - nearest_W);
  RC_PRE(std::max(n.x(), n.z()) > 0.05);
  const Vec3 along(std::max(0.0, n.x()), 0.0, std::max(0.0, n.z()));
  const Vec3 u = cylindrical(c.X_WB1, x_W, mapped_direction_W(cutting.groups[0], m, x_W));
  const double spacing = (part.core_P->to - part.core_P->from).norm() / samples;
  constexpr double rounding = 1e-14;
  RC_ASSERT((u - along.normalized()).norm() < 0.5 * spacing / along.norm() + rounding);
}

TEST(MappedDirectionW, is_the_groups_own_where_the_normal_points_up_and_in) {
  bit::Bit bit;
  bit::Part& part = bit.parts.emplace_back();
  part.mesh_P = battery::box(Vec3::Constant(-0.1), Vec3::Constant(0.1));
  part.X_BP.p = Vec3(1.0, 0.0, 0.0);
  part.core_P = bit::Segment{Vec3::Zero(), Vec3::Zero()};
  part.update_direction_B = Vec3(0.6, 0.0, 0.8);
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const GroupMotion m = group_motion(cutting.groups[0], Pose{}, Pose{});
  EXPECT_EQ(mapped_direction_W(cutting.groups[0], m, Vec3(0.95, 0.0, -0.05)), Vec3(0.6, 0, 0.8));
  EXPECT_EQ(mapped_direction_W(cutting.groups[0], m, Vec3(1.05, 0.0, -0.05)), Vec3(1, 0, 0));
  EXPECT_EQ(mapped_direction_W(cutting.groups[0], m, Vec3(0.95, 0.0, 0.05)), Vec3(0, 0, 1));
}

}  // namespace tdbd::rock::mapped_direction_test
