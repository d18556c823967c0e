#include "rock/section/face_outline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "bit/cutter/cutter_frame.hpp"
#include "bit/cutter/cutter_parts.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/bit/generate.hpp"

namespace tdbd::rock {
namespace {

/// Scale of the tolerances: a cutter's place, below a metre.
constexpr double rounding = 1e-14;

RC_GTEST_PROP(face_outline, is_the_circle_through_the_tip_up_to_the_wear_flat, ()) {
  bit::Cutter c = bit::any_cutter();
  c.wear = *rc::gen::element(0.0, 0.5e-3, 2e-3);
  bit::CutterMeshing meshing;
  meshing.rim_segments = *battery::integer(8, 64);
  std::vector<bit::Part> parts = bit::cutter_parts(c, meshing);
  for (bit::Part& part : parts) part.cutter = 3;
  const FaceOutline face = face_outline(c, 3, parts);
  double farthest = -1.0, nearest = 1.0;
  const double area = moments(face.rim_F).area;
  for (const Vec2& x_F : face.rim_F) {
    const Vec3 x_B = face.X_BF * Vec3(0.0, x_F.x(), x_F.y());
    RC_ASSERT(x_F.norm() <= 0.5 * c.diameter * (1.0 + rounding));
    nearest = std::min(nearest, (x_B - bit::tip_B(c)).norm());
    farthest = std::max(farthest, bit::profile_normal_B(c).dot(x_B - bit::tip_B(c)));
  }
  RC_ASSERT(area > 0.0);
  if (c.wear > 0.0) RC_ASSERT(std::abs(farthest + c.wear) <= rounding);
  if (c.wear == 0.0) RC_ASSERT(nearest <= rounding);
}

TEST(face_outline, is_empty_without_parts) {
  EXPECT_TRUE(face_outline(bit::Cutter{}, 0, {}).rim_F.empty());
}

/// A screw motion of times s and t is one of s + t; at its start points have the twist's velocity.
RC_GTEST_PROP(twist, carried_is_the_screw_motion_of_the_velocity, ()) {
  const Twist twist{*battery::point(3.0), *battery::point(2.0)};
  const double s = *battery::number(-1.0, 1.0), t = *battery::number(-0.001, 0.001);
  const Pose both = carried(twist, s) * carried(twist, t), sum = carried(twist, s + t);
  RC_ASSERT((both.R - sum.R).norm() + (both.p - sum.p).norm() <= 1e-13);
  constexpr double h = 1e-5;  // central difference: error h^2 |w|^3 / 6, below 2e-9
  const Vec3 x_B = *battery::point(1.0);
  const Vec3 velocity = (carried(twist, h) * x_B - carried(twist, -h) * x_B) / (2.0 * h);
  RC_ASSERT((velocity - velocity_B(twist, x_B)).norm() <= 1e-8);
}

/// Also for no turn at all, and for turns too small to have an axis.
RC_GTEST_PROP(twist, from_two_poses_is_the_screw_motion_between_them, ()) {
  const double scale = *rc::gen::element(1.0, 1e-4, 1e-9, 0.0), dt = *battery::number(0.01, 0.5);
  const Twist twist{scale * *battery::point(3.0), *battery::point(2.0)};
  const Pose X_WB0{*battery::rotation(), *battery::point(1.0)};
  const Twist found = twist_from(X_WB0, X_WB0 * carried(twist, dt), dt);
  RC_ASSERT((found.angular_B - twist.angular_B).norm() * dt <= 1e-14);  // of 1 rad
  RC_ASSERT((found.linear_B - twist.linear_B).norm() * dt <= 1e-14);    // of 1 m
}

}  // namespace
}  // namespace tdbd::rock
