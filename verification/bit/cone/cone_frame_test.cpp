#include <gtest/gtest.h>

#include <algorithm>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cone/swept_parts.hpp"
#include "bit/cone_generate.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/error.hpp"
#include "mesh/measures.hpp"

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

namespace tdbd::bit::cone_reach_test {

Vec3 on_circle(const Pose& X_BK, const ShellPoint& p, double angle) {
  return X_BK * Vec3(p.r * std::cos(angle), p.r * std::sin(angle), -p.s);
}

/// No place of a point's circle is farther out or deeper than the result, and some sampled places
/// are as far, up to the spacing of the samples.
RC_GTEST_PROP(ConeReach, is_the_farthest_and_the_deepest_of_a_circle, ()) {
  const Pose X_BK = cone_pose(any_cone(), 0.0);
  const ShellPoint p{number(-0.05, 0.12), number(1e-3, 0.08)};
  const ConeReach reach = reach_of(X_BK, p);
  constexpr int n = 4000;
  constexpr double between = 1e-7;  // m: p.r (pi / n)^2 / 2, and what curves more
  double radius = 0.0, depth = -1.0;
  for (int k = 0; k < n; ++k) {
    const Vec3 x = on_circle(X_BK, p, full_turn * k / n);
    radius = std::max(radius, x.head<2>().norm());
    depth = std::max(depth, x.z());
  }
  RC_ASSERT(reach.radius >= radius - 1e-15);
  RC_ASSERT(reach.radius < radius + between);
  RC_ASSERT(reach.depth >= depth - 1e-15);
  RC_ASSERT(reach.depth < depth + between);
  RC_ASSERT(std::abs(on_circle(X_BK, p, reach.angle).head<2>().norm() - reach.radius) < 1e-15);
}

/// Of a meridian it is that of its farthest corner, and the depth of its deepest, whichever they are.
RC_GTEST_PROP(ConeReach, of_a_meridian_is_that_of_its_corners, ()) {
  const Pose X_BK = cone_pose(any_cone(), 0.0);
  Meridian m;
  for (int i = 0, count = *rc::gen::inRange(1, 6); i < count; ++i)
    m.push_back({number(-0.05, 0.12), number(1e-3, 0.08)});
  const ConeReach all = reach_of(X_BK, m);
  double radius = 0.0, depth = -1.0, angle = 0.0;
  for (const ShellPoint& p : m) {
    const ConeReach one = reach_of(X_BK, p);
    if (one.radius > radius) angle = one.angle;
    radius = std::max(radius, one.radius);
    depth = std::max(depth, one.depth);
  }
  RC_ASSERT(all.radius == radius);
  RC_ASSERT(all.depth == depth);
  RC_ASSERT(all.angle == angle);
}

/// With the apex that it finds the gage row reaches the gage, whatever the others reach.
TEST(ApexForGage, brings_the_gage_row_to_the_gage) {
  ConeLayout cone;
  cone.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  ToothRow inner, gage;
  inner.s = 0.065;  // which reaches farther
  inner.angles = {0.0};
  inner.shape.protrusion = 0.05;
  gage.s = 0.08;
  gage.angles = {0.0};
  gage.place = RowPlace::gage;
  cone.rows = {inner, gage};
  for (const auto& [journal, offset, radius] :
       {std::tuple(0.6, 0.0, 0.1), {0.3, 5e-3, 0.12}, {1.0, -8e-3, 0.09}}) {
    cone.journal_angle = journal;
    cone.offset = offset;
    cone.apex = apex_for_gage(cone, radius);
    const ConeReach reach = reach_of(cone_pose(cone, 0.0), row_meridian(cone, gage));
    EXPECT_NEAR(reach.radius, radius, 1e-13);
  }
}

TEST(ApexForGage, is_none_for_an_impossible_gage) {
  ConeLayout cone;
  cone.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  ToothRow gage;
  gage.s = 0.08;
  gage.angles = {0.0};
  gage.place = RowPlace::gage;
  cone.rows = {gage};
  try {
    apex_for_gage(cone, 0.005);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "no place along the journal at which the gage row reaches 5.000 mm");
  }
}

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
RC_GTEST_PROP(SweptParts, the_profile_contains_every_cutting_part_at_every_angle, ()) {
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

}  // namespace tdbd::bit::cone_reach_test
