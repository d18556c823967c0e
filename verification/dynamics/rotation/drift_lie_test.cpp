#include "dynamics/rotation/drift_lie.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "verification/battery/dual.hpp"

namespace tdbd::dynamics::drift_lie_test {

using Jet3 = battery::Dual<3>;

constexpr double rounding = 1e-13;  // momenta of order ten

Vec3 random_vector(double size) {
  const auto component = [size] { return size * 1e-4 * *rc::gen::inRange(-10'000, 10'001); };
  const double x = component(), y = component(), z = component();
  return {x, y, z};
}

Vec3Of<Jet3> seeded(const Vec3& v) {
  Vec3Of<Jet3> s;
  for (int i = 0; i < 3; ++i) {
    s[i] = Jet3(v[i]);
    s[i].by[i] = 1.0;
  }
  return s;
}

RC_GTEST_PROP(LieMomentum, slope_is_its_derivative_on_both_sides_of_the_series_end, ()) {
  const Vec3 T = random_vector(1.5), P = random_vector(5.0);
  const Vec3Of<Jet3> P_constant = P.cast<Jet3>();
  for (const LieMomentum which : {LieMomentum::middle, LieMomentum::mean}) {
    const LieTerm<double> term = lie_momentum<double>(which, T, P);
    const Vec3Of<Jet3> m = lie_momentum<Jet3>(which, seeded(T), P_constant).m;
    for (int i = 0; i < 3; ++i)
      RC_ASSERT((m[i].by.matrix().transpose() - term.by_T.row(i)).norm() <= rounding);
  }
}

/// The mean of exp(-s T) P by Gauss's rule, exact to rounding for angles up to three.
Vec3 mean_by_quadrature(const Vec3& T, const Vec3& P) {
  constexpr int intervals = 16;
  const double nodes[] = {-0.7745966692414834, 0.0, 0.7745966692414834};
  const double weights[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < intervals; ++k)
    for (int n = 0; n < 3; ++n) {
      const double s = (k + 0.5 + 0.5 * nodes[n]) / intervals;
      sum += weights[n] / intervals * (rotation::quaternion_exp<double>(-s * T) * P);
    }
  return sum;
}

RC_GTEST_PROP(LieMomentum, is_that_of_the_middle_or_the_mean_of_the_way, ()) {
  const Vec3 T = random_vector(1.5), P = random_vector(5.0);
  const Vec3 middle = rotation::quaternion_exp<double>(-0.5 * T) * P;
  constexpr double quadrature = 2.8e-11;
  RC_ASSERT((lie_momentum<double>(LieMomentum::middle, T, P).m - middle).norm() <= rounding);
  RC_ASSERT((lie_momentum<double>(LieMomentum::mean, T, P).m - mean_by_quadrature(T, P)).norm() <=
            quadrature);
}

TEST(SolveLie, carries_derivatives_that_solve_the_equation_too) {
  const Gyrostat g = make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(), {});
  const Vec3Of<Jet3> P = seeded(Vec3(1.5, -2.0, 3.0)), none = Vec3Of<Jet3>::Zero();
  constexpr double h = 0.3;
  for (const LieMomentum which : {LieMomentum::middle, LieMomentum::mean}) {
    Vec3Of<Jet3> T;
    ASSERT_EQ(solve_lie<Jet3>(g, which, h, P, none, {}, T), LieOutcome::solved);
    const Vec3Of<Jet3> residual =
        g.carrier_B.cast<Jet3>() * T - h * lie_momentum<Jet3>(which, T, P).m;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(residual[i].value, 0.0, rounding);
      EXPECT_LE(residual[i].by.matrix().norm(), rounding);
    }
  }
}

}  // namespace tdbd::dynamics::drift_lie_test
