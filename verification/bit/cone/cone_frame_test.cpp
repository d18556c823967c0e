#include "bit/cone/cone_frame.hpp"

#include <gtest/gtest.h>

#include "bit/cone_generate.hpp"

namespace tdbd::bit::cone_frame_test {

constexpr double rounding = 1e-15;  ///< of a product of few rotations; scale: 1 and 1 m

/// Turned about the unit axis by Rodrigues' formula: a chain of its own.
Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  return std::cos(angle) * v + std::sin(angle) * axis.cross(v) +
         (1 - std::cos(angle)) * axis.dot(v) * axis;
}

/// The journal's direction from angles of azimuth and dip, without any matrix.
Vec3 journal(const ConeLayout& c) {
  const double plan = c.azimuth + c.skew;
  return {-std::cos(c.journal_angle) * std::cos(plan), -std::cos(c.journal_angle) * std::sin(plan),
          std::sin(c.journal_angle)};
}

RC_GTEST_PROP(ConeFrame, has_its_axis_along_the_journal_inwards_and_down, ()) {
  const ConeLayout c = any_cone();
  const Pose X_BK = cone_pose(c, number(-pi, pi));
  RC_ASSERT((X_BK.R.col(2) - journal(c)).norm() < rounding);
  RC_ASSERT((X_BK.R.transpose() * X_BK.R - Mat3::Identity()).cwiseAbs().maxCoeff() < rounding);
  RC_ASSERT(X_BK.R.determinant() > 0.0);
  RC_ASSERT(X_BK.R.col(2).z() >= 0.0);
}

/// bit (2), p = r0 + S s + D Rot(s, phi) d0, in vectors.
RC_GTEST_PROP(ConeFrame, places_points_as_an_independent_chain_does, ()) {
  const ConeLayout c = any_cone();
  const double phi = number(-2 * pi, 2 * pi);
  const Vec3 x_K(number(-0.1, 0.1), number(-0.1, 0.1), number(-0.1, 0.1));
  const Vec3 s = journal(c);
  const Vec3 foot(-c.offset * std::sin(c.azimuth), c.offset * std::cos(c.azimuth), -c.foot_height);
  const double plan = c.azimuth + c.skew;
  const Vec3 y(-std::sin(plan), std::cos(plan), 0.0);
  const Vec3 d = turned(x_K.x() * y.cross(s) + x_K.y() * y, s, phi);
  RC_ASSERT((cone_pose(c, phi) * x_K - (foot + (c.apex + x_K.z()) * s + d)).norm() < rounding);
}

/// The journal passes the bit's axis at the offset, up to the cosine of the skew.
RC_GTEST_PROP(ConeFrame, passes_the_bits_axis_at_the_offset, ()) {
  ConeLayout c = any_cone();
  const Pose X_BK = cone_pose(c, 0.0);
  const Vec3 s = X_BK.R.col(2), across = s.cross(Vec3::UnitZ()).normalized();
  RC_ASSERT(std::abs(std::abs(X_BK.p.dot(across)) - std::abs(c.offset) * std::cos(c.skew)) <
            rounding);
}

/// A point of a cone that rolls on the bottom has no velocity: the bit turns about +z, phi' < 0.
TEST(ConeFrame, rolls_with_a_negative_rate) {
  ConeLayout c;
  c.journal_angle = 36 * degree;
  const double radius = 0.06, ahead = 1e-6;
  const Vec3 lowest_K(radius, 0.0, -0.08);
  const auto at = [&](double turn, double ratio) {
    return Vec3(turned(cone_pose(c, -ratio * turn) * lowest_K, Vec3::UnitZ(), turn));
  };
  const double ratio = at(0.0, 0.0).x() / radius;
  EXPECT_GT(at(0.0, 0.0).z(), 0.0);
  EXPECT_LT((at(ahead, ratio) - at(0.0, ratio)).norm(), 2 * ahead * ahead * radius);
}

TEST(ConeFrame, of_a_cone_at_an_angle_is_that_of_its_layout) {
  ConeLayout c;
  c.journal_angle = 0.6;
  c.apex = 0.01;
  const Cone cone{"cone-1", c, cone_pose(c, 0.0)};
  EXPECT_LT((cone_pose(cone, 0.7).R - cone_pose(c, 0.7).R).norm(), rounding);
}

}  // namespace tdbd::bit::cone_frame_test
