#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::rotation::rotation_vector_test {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-15;  // of the entries of a rotation, some units in the last place

/// Twin: the power series of the matrix exponential, summed until nothing is added.
Mat3 exp_by_series(const Vec3& v) {
  Mat3 term = Mat3::Identity(), sum = term;
  for (int k = 1; k < 60; ++k) {
    term = term * skew(v) / k;
    sum += term;
  }
  return sum;
}

double distance(const Mat3& A, const Mat3& B) { return (A - B).cwiseAbs().maxCoeff(); }

/// Rotation vectors of all sizes: 1e-15 ... 1e0 times up to pi.
rc::Gen<Vec3> rotation_vector() {
  return rc::gen::apply(
      [](const Vec3& u, double share, int exponent) {
        return Vec3(share * pi * std::pow(10.0, -exponent) * u);
      },
      battery::direction(), battery::number(0.0, 1.0), rc::gen::inRange(0, 16));
}

RC_GTEST_PROP(Skew, is_the_cross_product, ()) {
  const Vec3 a = *battery::point(3.0), b = *battery::point(3.0);
  RC_ASSERT((skew(a) * b - a.cross(b)).norm() < 20.0 * rounding);
}

RC_GTEST_PROP(Exp, is_a_rotation, ()) {
  const Mat3 R = exp(*rotation_vector());
  RC_ASSERT(distance(R.transpose() * R, Mat3::Identity()) < 4.0 * rounding);
  RC_ASSERT(std::abs(R.determinant() - 1.0) < 4.0 * rounding);
}

/// The series loses digits where its terms grow beyond its sum: at most e^pi / 1, some 23.
RC_GTEST_PROP(Exp, equals_its_power_series, ()) {
  const Vec3 v = *rotation_vector();
  RC_ASSERT(distance(exp(v), exp_by_series(v)) < 25.0 * rounding);
}

/// Relative to the angle: the turn of a tiny rotation vector keeps all its digits.
RC_GTEST_PROP(Exp, keeps_the_digits_of_small_turns, ()) {
  const Vec3 v = *rotation_vector();
  const Mat3 R = exp(v);
  const Vec3 sine_axis = 0.5 * Vec3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double angle = v.norm();
  const Vec3 expected = angle > 0.0 ? Vec3(std::sin(angle) / angle * v) : Vec3::Zero();
  RC_ASSERT((sine_axis - expected).norm() <= 4.0 * rounding * angle);
}

RC_GTEST_PROP(Log, undoes_exp_up_to_a_half_turn, ()) {
  const Vec3 v = *rotation_vector();
  RC_PRE(v.norm() < pi - 1e-3);
  RC_ASSERT((log(exp(v)) - v).norm() <= 8.0 * rounding * std::max(v.norm(), 1e-8));
}

/// At a half turn v and -v are one rotation: compare rotations, not vectors.
RC_GTEST_PROP(Exp, undoes_log_also_near_a_half_turn, ()) {
  const Vec3 u = *battery::direction();
  const double short_of_pi = std::pow(10.0, -*rc::gen::inRange(1, 18));
  const Mat3 R = exp((pi - short_of_pi) * u);
  const Vec3 v = log(R);
  RC_ASSERT(v.norm() <= pi * (1.0 + rounding));
  RC_ASSERT(std::abs(v.norm() - (pi - short_of_pi)) < 8.0 * rounding);
  RC_ASSERT(distance(exp(v), R) < 8.0 * rounding);
}

RC_GTEST_PROP(Exp, undoes_log_of_any_rotation, ()) {
  const Mat3 R = *battery::rotation();
  RC_ASSERT(distance(exp(log(R)), R) < 8.0 * rounding);
}

TEST(Log, of_nothing_is_nothing) { EXPECT_EQ(log(Mat3::Identity()), Vec3(Vec3::Zero())); }

RC_GTEST_PROP(Exp, of_turns_about_one_axis_adds_their_angles, ()) {
  const Vec3 u = *battery::direction();
  const double a = *battery::number(-3.0, 3.0), b = *battery::number(-3.0, 3.0);
  RC_ASSERT(distance(exp(a * u) * exp(b * u), exp((a + b) * u)) < 8.0 * rounding);
  RC_ASSERT(distance(exp(-a * u), exp(a * u).transpose()) < rounding);
}

RC_GTEST_PROP(Exp, turns_with_its_frame, ()) {
  const Mat3 R = *battery::rotation();
  const Vec3 v = *rotation_vector();
  RC_ASSERT(distance(exp(R * v), R * exp(v) * R.transpose()) < 8.0 * rounding);
}

TEST(Exp, turns_x_to_y_about_z) {
  EXPECT_LT((exp(Vec3(0, 0, pi / 2)) * Vec3::UnitX() - Vec3::UnitY()).norm(), rounding);
}

/// exp(h v) = I + h S + h^2 S^2 / 2 + O(h^3): the remainder falls by 8 when h halves.
RC_GTEST_PROP(Exp, has_the_derivatives_of_a_rotation_at_zero, ()) {
  const Vec3 v = *battery::direction();
  const Mat3 S = skew(v);
  double before = 0.0;
  for (const double h : {0.2, 0.1, 0.05, 0.025, 0.0125}) {
    const Mat3 quadratic = Mat3::Identity() + h * S + 0.5 * h * h * S * S;
    const double remainder = (exp(h * v) - quadratic).norm();
    if (before > 0.0) RC_ASSERT(std::abs(std::log2(before / remainder) - 3.0) < 0.0024);
    before = remainder;
  }
}

/// The formula changes at an angle of 1e-4: no step there beyond rounding.
RC_GTEST_PROP(Exp, does_not_jump_where_its_formula_changes, ()) {
  const Vec3 u = *battery::direction();
  const double below = 1e-4 * (1.0 - 1e-9), above = 1e-4 * (1.0 + 1e-9);
  const Mat3 step = exp(above * u) - exp(below * u);
  RC_ASSERT(distance(step, (above - below) * skew(u)) < 1e-15);
}

/// What is small in a small rotation keeps its digits: (1 - cos) / angle^2 off the diagonal, where no sine stands.
TEST(Exp, of_a_small_turn_has_all_its_digits_off_the_diagonal) {
  for (const double a : {1e-6, 2e-5, 7e-5, 8e-5, 1e-3}) {
    const double angle = a * std::sqrt(2.0), half = std::sin(0.5 * angle);
    const double expected = 2.0 * half * half / 2.0;  // over angle^2, times a^2
    EXPECT_NEAR(exp(Vec3(a, a, 0.0))(0, 1) / expected, 1.0, 1e-14) << a;
  }
}

}  // namespace tdbd::rotation::rotation_vector_test
