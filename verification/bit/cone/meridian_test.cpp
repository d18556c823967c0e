#include "bit/cone/meridian.hpp"

#include <gtest/gtest.h>

#include "bit/cone/meridian_gap.hpp"
#include "bit/cone/tooth_mesh.hpp"
#include "bit/cone_generate.hpp"

namespace tdbd::bit::meridian_test {

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

RC_GTEST_PROP(Meridian, knows_the_distance_from_a_cylinder, ()) {
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

constexpr double resolution = 1e-4;  ///< asked for; scale: the balls' radius
constexpr int sides = 48;
const double sagitta = 1.0 - std::cos(pi / sides / 2);  ///< of the polygon's sides

/// Two balls at a known distance, their axes anywhere: gap and depth of overlap.
RC_GTEST_PROP(MeridianGap, of_two_balls_is_known_to_the_resolution, ()) {
  const double distance = number(1.2, 4.0);
  const Meridian m = ball(sides);
  const Gap gap = smallest_gap(m, any_pose(0.0), m, any_pose(distance), resolution, INFINITY);
  RC_ASSERT(std::abs(gap.distance - (distance - 2.0)) < resolution + 2.0 * sagitta);
}

/// A sampled twin: no sample of A's surface is nearer to B than the gap says.
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

}  // namespace tdbd::bit::meridian_test
