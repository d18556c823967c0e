#include "bit/cutter/cutter_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bit/generate.hpp"

namespace tdbd::bit::cutter_gap_test {

constexpr double near = 1e-9;  ///< m, that the clearance is off the gap

/// A cutter of 10 mm x 10 mm whose face's centre stands at p, with axes R.
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

}  // namespace tdbd::bit::cutter_gap_test
