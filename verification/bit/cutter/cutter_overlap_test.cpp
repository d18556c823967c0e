#include <gtest/gtest.h>

#include <cmath>

#include "bit/cutter/cutter.hpp"
#include "bit/generate.hpp"
#include "bit/generate_design.hpp"
#include "core/random.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::cutter_overlap_test {

/// A bit of cutters at these poses.
Bit bit_of(const std::vector<Cutter>& cutters, const PdcOptions& options = {}) {
  return pdc_bit("pair", cutters, options);
}

Cutter cutter_at(int id, double radius, double height) {
  Cutter c;
  c.id = id;
  c.diameter = 16e-3;
  c.tip_radius = radius;
  c.tip_height = height;
  c.chamfer = 0.4e-3;
  c.chamfer_angle = pi / 4;
  c.land = 0.3e-3;
  c.land_angle = 70 * degree;
  c.length = 13e-3;
  c.table_thickness = 2e-3;
  c.X_BC = cutter_pose(c);
  return c;
}

/// Two sharp cylinders side by side share a lens times their length: with rims inscribed in n
/// corners less by about (2 pi / n)^2 / 6 of it.
TEST(CutterOverlap, of_parallel_cylinders_is_a_lens) {
  Cutter a = cutter_at(1, 50e-3, 0.0), b = cutter_at(2, 60e-3, 0.0);
  for (Cutter* c : {&a, &b}) c->chamfer = c->land = 0.0, c->X_BC = cutter_pose(*c);
  PdcOptions options;
  options.meshing.rim_segments = 200;
  const auto overlaps = cutter_overlaps(bit_of({a, b}, options));
  ASSERT_EQ(overlaps.size(), 1u);
  const double r = 8e-3, half = std::acos(5e-3 / r);
  const double lens = 2 * r * r * (half - std::sin(half) * std::cos(half));
  EXPECT_NEAR(overlaps[0].volume / (lens * 13e-3), 1.0, 1e-3);
}

/// A cutter at the place of another shares all of it: the sum over its parts.
TEST(CutterOverlap, of_a_cutter_with_itself_is_its_volume) {
  const Bit bit = bit_of({cutter_at(1, 50e-3, 0.0), cutter_at(2, 50e-3, 0.0)});
  double volume = 0.0;
  for (const Part& part : bit.parts)
    if (part.cutter == 0 && part.density > 0.0) volume += mesh::enclosed_volume(part.mesh_P);
  const auto overlaps = cutter_overlaps(bit);
  ASSERT_EQ(overlaps.size(), 1u);
  EXPECT_NEAR(overlaps[0].volume, volume, 1e-12 * volume);
}

TEST(CutterOverlap, of_cutters_that_are_clear_is_nothing) {
  EXPECT_TRUE(
      cutter_overlaps(bit_of({cutter_at(1, 50e-3, 0.0), cutter_at(2, 67e-3, 0.0)})).empty());
}

RC_GTEST_PROP(CutterOverlap, of_a_generated_bit_is_nothing, ()) {
  RC_ASSERT(cutter_overlaps(bit_of(laid_out(any_design()))).empty());
}

bool inside_cylinder(const Cutter& c, const Vec3& x_B) {
  const Vec3 x = c.X_BC.R.transpose() * (x_B - c.X_BC.p);
  return x.x() < 0.0 && x.x() > -c.length && std::hypot(x.y(), x.z()) < c.diameter / 2;
}

/// Points thrown into the first cylinder: the share that lies in the second, to five standard
/// errors and what the polygons lose.
RC_GTEST_PROP(CutterOverlap, is_what_monte_carlo_finds, ()) {
  Cutter a = cutter_at(1, 50e-3, 0.0), b = cutter_at(2, number(50e-3, 62e-3), number(0.0, 6e-3));
  b.azimuth = number(-0.15, 0.15);
  b.back_rake = number(0.0, 0.5);
  for (Cutter* c : {&a, &b}) c->chamfer = c->land = 0.0, c->X_BC = cutter_pose(*c);
  PdcOptions options;
  options.meshing.rim_segments = 48;
  const auto overlaps = cutter_overlaps(bit_of({a, b}, options));
  const double volume = overlaps.empty() ? 0.0 : overlaps[0].volume;
  const double whole = pi * 64e-6 * 13e-3;
  constexpr int points = 40000;
  Random random{7};
  int hits = 0;
  for (int k = 0; k < points; ++k) {
    const double r = 8e-3 * std::sqrt(random.uniform()), angle = 2 * pi * random.uniform();
    const Vec3 x_C(-13e-3 * random.uniform(), r * std::sin(angle), r * std::cos(angle));
    hits += inside_cylinder(b, a.X_BC * x_C);
  }
  const double share = static_cast<double>(hits) / points;
  const double error = 5 * std::sqrt(std::max(share, 1.0 / points) / points) + 3e-3;
  RC_ASSERT(std::abs(volume / whole - share) < error);
}

/// Direction of motion at the cutter's azimuth: the bit turns about +z.
Vec3 motion_B(const Cutter& c) {
  return Vec3::UnitZ().cross(Vec3(std::cos(c.azimuth), std::sin(c.azimuth), 0.0));
}

RC_GTEST_PROP(CutterFrame, is_right_handed_and_orthonormal, ()) {
  const Mat3 R = any_cutter().X_BC.R;
  RC_ASSERT((R.transpose() * R - Mat3::Identity()).norm() < 1e-14);
  RC_ASSERT(std::abs(R.determinant() - 1.0) < 1e-14);
}

RC_GTEST_PROP(CutterFrame, puts_the_tip_at_the_place_of_the_table, ()) {
  const Cutter c = any_cutter();
  const Vec3 expected(c.tip_radius * std::cos(c.azimuth), c.tip_radius * std::sin(c.azimuth),
                      -c.tip_height);
  RC_ASSERT((c.X_BC * tip_C(c) - expected).norm() < 1e-15);
}

/// A steep chamfer (a small angle from the axis) is deep, a flat one shallow.
TEST(CutterFrame, measures_the_chamfer_from_the_axis) {
  Cutter c;
  c.chamfer = 1e-3;
  c.chamfer_angle = 60 * degree;
  EXPECT_NEAR(chamfer_depth(c), 1e-3 / std::sqrt(3.0), 1e-18);
}

/// -Z is tilted from n by the back rake, backwards, whatever the side rake.
RC_GTEST_PROP(CutterFrame, leans_over_the_rock_by_the_back_rake, ()) {
  const Cutter c = any_cutter();
  const Vec3 exposure_B = -c.X_BC.R.col(2);
  RC_ASSERT(std::abs(exposure_B.dot(profile_normal_B(c)) - std::cos(c.back_rake)) < 1e-15);
  RC_ASSERT(std::abs(exposure_B.dot(motion_B(c)) + std::sin(c.back_rake)) < 1e-15);
}

RC_GTEST_PROP(CutterFrame, turns_the_face_by_the_side_rake, ()) {
  Cutter c = any_cutter();
  const Vec3 x_B = c.X_BC.R.col(0);
  const double side_rake = std::exchange(c.side_rake, 0.0);
  const Pose straight = cutter_pose(c);
  RC_ASSERT(std::abs(x_B.dot(straight.R.col(0)) - std::cos(side_rake)) < 1e-14);
  RC_ASSERT(std::abs(x_B.dot(straight.R.col(1)) - std::sin(side_rake)) < 1e-14);
  RC_ASSERT(std::abs(straight.R.col(1).dot(profile_normal_B(c))) < 1e-15);
}

/// The rim, followed finely: nothing on it reaches farther along n than the tip, but for the
/// documented excess that a side rake makes.
RC_GTEST_PROP(CutterFrame, tip_is_the_farthest_point_of_the_edge, ()) {
  const Cutter c = any_cutter();
  const Vec3 n_C = c.X_BC.R.transpose() * profile_normal_B(c);
  const double ss = std::sin(c.side_rake), sb = std::sin(c.back_rake), cb = std::cos(c.back_rake);
  const double excess = 0.5 * c.diameter * (std::sqrt(cb * cb + ss * ss * sb * sb) - cb);
  double farthest = -1.0;
  for (int k = 0; k < 3600; ++k) {
    const double a = k * 2 * pi / 3600;
    const Vec3 rim_C(tip_C(c).x(), tip_C(c).z() * std::sin(a), tip_C(c).z() * std::cos(a));
    farthest = std::max(farthest, n_C.dot(rim_C - tip_C(c)));
  }
  RC_ASSERT(farthest <= excess + 1e-15);
  RC_ASSERT(farthest >= excess - 1e-8);
}

constexpr double near = 1e-9;  ///< m, that the clearance is off the gap

/// A cutter of 10 mm x 10 mm whose face has its centre at p, with axes R.
Cutter standing(const Vec3& p, const Mat3& R = Mat3::Identity()) {
  Cutter c;
  c.diameter = c.length = 0.01;
  c.X_BC = {R, p};
  return c;
}

void expect_gap(const Cutter& a, const Cutter& b, double gap) {
  EXPECT_TRUE(closer_than(a, b, gap + near));
  EXPECT_FALSE(closer_than(a, b, gap - near));
  EXPECT_FALSE(closer_than(b, a, gap - near));
}

TEST(CutterGap, of_parallel_cylinders_is_known) {
  const Cutter c = standing(Vec3::Zero());
  expect_gap(c, standing({0, 0.009, 0.012}), 0.005);  // side by side
  expect_gap(c, standing({0.012, 0, 0}), 0.002);      // one behind the other
  expect_gap(c, standing({0.013, 0.014, 0}), 0.005);  // edge to edge
}

/// Sizes that are whole in binary: the gap is exact, and a clearance as large as it is kept.
TEST(CutterGap, that_equals_the_clearance_is_wide_enough) {
  constexpr double size = 1.0 / 64.0, gap = 1.0 / 128.0;
  Cutter a = standing(Vec3::Zero()), b = standing({size + gap, 0, 0});
  for (Cutter* c : {&a, &b}) c->diameter = c->length = size;
  EXPECT_FALSE(closer_than(a, b, gap));
  EXPECT_TRUE(closer_than(a, b, std::nextafter(gap, 1.0)));
}

TEST(CutterGap, of_crossed_cylinders_is_known) {
  Mat3 R;
  R << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // axis along y
  expect_gap(standing(Vec3::Zero()), standing({-0.005, 0.005, 0.012}, R), 0.002);
}

TEST(CutterGap, of_overlapping_cylinders_is_none) {
  EXPECT_TRUE(closer_than(standing({0, 0, 0}), standing({0.009, 0.002, 0}), near));
  EXPECT_TRUE(closer_than(standing({0, 0, 0}), standing({0, 0.0099, 0}), near));
  EXPECT_FALSE(closer_than(standing({0, 0, 0}), standing({0, 0.0101, 0}), near));
}

/// Moved together the gap stays, to the micrometre that the header allows.
RC_GTEST_PROP(CutterGap, does_not_depend_on_the_frame, ()) {
  const Cutter a = any_cutter();
  Cutter b = any_cutter();
  b.X_BC.p = a.X_BC.p + Vec3(number(-0.03, 0.03), number(-0.03, 0.03), number(-0.03, 0.03));
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  const Pose X{q.normalized().toRotationMatrix(), {number(-1, 1), 0.5, 0.0}};
  constexpr double slack = 1e-6;
  double lo = 0.0, hi = 0.1;
  while (hi - lo > near) (closer_than(a, b, 0.5 * (lo + hi)) ? hi : lo) = 0.5 * (lo + hi);
  Cutter c = a, d = b;
  c.X_BC = X * a.X_BC;
  d.X_BC = X * b.X_BC;
  RC_ASSERT(closer_than(c, d, hi + slack));
  RC_ASSERT(lo < slack || !closer_than(d, c, lo - slack));
}

}  // namespace tdbd::bit::cutter_overlap_test

namespace tdbd::bit::rim_reach_test {

/// Columns are equal, from the axis to the widest rim, and no wider than requested.
TEST(RimReach, has_columns_no_wider_than_requested) {
  const std::vector<Cutter> cutters = table('b');
  double end = 0.0;
  for (const Cutter& c : cutters)
    for (const Vec3& p : turned_outline(c, rim_points)) end = std::max(end, p.x());
  for (const double widest : {0.1e-3, 0.37e-3, 1.3e-3, 7e-3}) {
    const RimReaches rims = rim_reaches(cutters, widest);
    ASSERT_EQ(rims.of_cutter.size(), cutters.size());
    const auto columns = static_cast<double>(rims.of_cutter.front().size());
    EXPECT_LE(rims.width, widest);
    EXPECT_GT(rims.width, widest * (1.0 - 1.0 / columns));
    EXPECT_NEAR(rims.width * columns, end, 1e-15);
  }
}

/// The rim starts at the tip, which stands on the outer edge of the chamfer.
TEST(TurnedOutline, starts_at_the_tip) {
  for (const Cutter& c : table('b')) {
    ASSERT_GT(c.chamfer, 0.0);
    const Vec3 first = turned_outline(c, 12).front();
    EXPECT_NEAR(first.x(), c.tip_radius, 1e-15);
    EXPECT_NEAR(first.y(), c.azimuth, 1e-13);
    EXPECT_NEAR(first.z(), -c.tip_height, 1e-15);
  }
}

}  // namespace tdbd::bit::rim_reach_test
