#include "reference/dynamics/closed_forms.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "battery/generators.hpp"
#include "battery/golden.hpp"
#include "reference/dynamics/runge_kutta.hpp"

namespace tdbd::reference::closed_forms_test {

/// Rounding of a Runge-Kutta run, up to 100 rad; scale: 1 + rates.
constexpr double agreement = 1e-12;

Mat3 some_attitude() { return Mat3(Eigen::AngleAxisd(0.7, Vec3(1, -2, 3).normalized())); }

/// The same start in the twin's unknowns; a cone, if any, on e3.
GyrostatState twin_start(const dynamics::Gyrostat& g, const Turning& s, double cone_momentum) {
  GyrostatState start;
  start.R_WB = s.R_WB;
  start.body_momentum_B = g.carrier_B * s.w_B;
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    start.body_momentum_B += cone_momentum * g.cones[k].axis_B;
    start.cone_angles.push_back(0.0);
    start.cone_momenta.push_back(cone_momentum);
  }
  return start;
}

double difference(const dynamics::Gyrostat& g, const GyrostatState& a, const Turning& b) {
  return ((a.R_WB - b.R_WB).norm() + (bit_angular_velocity(g, a) - b.w_B).norm()) /
         (1.0 + b.w_B.norm());
}

dynamics::Gyrostat body(const Vec3& principal) {
  return dynamics::make_gyrostat(principal.asDiagonal(), {}, dynamics::InertiaCheck::off);
}

double free_difference(const Vec3& principal, const Turning& start, double t) {
  const dynamics::Gyrostat g = body(principal);
  return difference(g, runge_kutta(g, {}, twin_start(g, start, 0.0), t).state,
                    free_asymmetric_body(principal, start, t));
}

TEST(ClosedForms, free_symmetric_body_agrees_with_the_twin) {
  for (const double cone_momentum : {0.0, -2.0}) {
    const SymmetricBody b{2.0, 3.0, cone_momentum};
    const dynamics::Gyrostat g = dynamics::make_gyrostat(
        Vec3(2.0, 2.0, 3.4).asDiagonal(), {{Vec3::UnitZ(), 0.4}}, dynamics::InertiaCheck::off);
    const Turning start{some_attitude(), Vec3(0.3, -1.2, 2.0)};
    const GyrostatState end = runge_kutta(g, {}, twin_start(g, start, cone_momentum), 10.0).state;
    EXPECT_LE(difference(g, end, free_symmetric_body(b, start, 10.0)), agreement);
  }
}

TEST(ClosedForms, free_asymmetric_body_agrees_with_the_twin_on_both_sides_of_the_separatrix) {
  for (const Vec3& principal : {Vec3(1, 2, 3), Vec3(2.6, 3, 2), Vec3(3, 2, 1), Vec3(2, 1, 2.5)})
    for (const double x : {-2.0, 0.3, 1.0})
      for (const double y : {0.0, -0.4, 1.3})
        for (const double z : {0.2, -1.5, 2.0}) {
          const Turning start{some_attitude(), Vec3(x, y, z)};
          EXPECT_LE(free_difference(principal, start, 10.0), agreement)
              << principal.transpose() << ", " << start.w_B.transpose();
        }
}

TEST(ClosedForms, free_asymmetric_body_may_turn_steadily) {
  for (const Vec3& w_B : {Vec3(2, 0, 0), Vec3(0, -1e-3, 0), Vec3(0, 0, -2), Vec3(0, 0, 0)})
    EXPECT_LE(free_difference({1, 2, 3}, {some_attitude(), w_B}, 10.0), agreement);
}

/// On the separatrix, I1 W1^2 (I2 - I1) = I3 W3^2 (I3 - I2), exact in binary here, the body turns
/// over once and never again; the twin leaves it by its rounding, which grows exponentially.
TEST(ClosedForms, free_asymmetric_body_on_the_separatrix) {
  const Vec3 principal(1, 2, 2.25);
  for (const Vec3& w_B : {Vec3(3, 0.5, 4), Vec3(-3, 0.5, 4), Vec3(3, 0.5, -4), Vec3(-3, -1, -4)}) {
    const Turning start{some_attitude(), w_B};
    EXPECT_LE(free_difference(principal, start, 2.0), agreement);
    const Vec3 late = free_asymmetric_body(principal, start, 40.0).w_B;
    EXPECT_NEAR(std::abs(late.y()), late.norm(), 1e-12);
  }
}

TEST(ClosedForms, free_asymmetric_body_is_the_golden_one) {
  for (const char* name : {"free_asym_111", "free_asym_unstable"}) {
    const battery::GoldenCase c = battery::read_golden_case(name);
    const Turning start{c.states[0].R_WB, c.states[0].w_B};
    for (const battery::GoldenState& s : c.states) {
      const Turning end = free_asymmetric_body(c.gyrostat.inertia_B.diagonal(), start, s.time);
      // Of the unstable rotation: rounding of the start grows.
      EXPECT_LE((end.R_WB - s.R_WB).norm() + (end.w_B - s.w_B).norm(), 7e-12) << name << s.time;
    }
  }
}

/// Invariants, for any body: momentum in space, energy, orthogonality; and a motion of t1 + t2 is
/// one of t1 followed by one of t2.
RC_GTEST_PROP(ClosedForms, free_asymmetric_body_keeps_its_invariants, ()) {
  const double low = *battery::number(0.5, 1.5), gap = *battery::number(0.2, 1.0);
  const Vec3 principal(low + gap, low, low + gap + *battery::number(0.2, 1.0));
  const Turning start{*battery::rotation(), *battery::point(3.0)};
  const Turning end = free_asymmetric_body(principal, start, 5.0);
  const auto momentum_W = [&](const Turning& s) {
    return Vec3(s.R_WB * principal.cwiseProduct(s.w_B));
  };
  const auto energy = [&](const Turning& s) { return s.w_B.dot(principal.cwiseProduct(s.w_B)); };
  const double scale = 1.0 + energy(start);
  RC_ASSERT((momentum_W(end) - momentum_W(start)).norm() < 1e-12 * scale);
  RC_ASSERT(std::abs(energy(end) - energy(start)) < 1e-12 * scale);
  RC_ASSERT((end.R_WB.transpose() * end.R_WB - Mat3::Identity()).norm() < 1e-13);
  const Turning whole = free_asymmetric_body(principal, start, 1.0);
  const Turning pieces =
      free_asymmetric_body(principal, free_asymmetric_body(principal, start, 0.4), 0.6);
  RC_ASSERT((whole.R_WB - pieces.R_WB).norm() + (whole.w_B - pieces.w_B).norm() < 1e-12);
}

TEST(ClosedForms, steady_precession_agrees_with_the_twin) {
  for (const double tilt : {0.5, 2.4})
    for (const double cone_momentum : {0.0, 1.5}) {
      const SymmetricBody top{5.0, 1.0, cone_momentum};
      const double axial_rate = -25.0;
      const std::vector<double> rates = steady_precession_rates(top, 20.0, tilt, axial_rate);
      ASSERT_EQ(rates.size(), 2u);
      for (const double rate : rates) {
        const dynamics::Gyrostat g =
            dynamics::make_gyrostat(Vec3(5.0, 5.0, 1.4).asDiagonal(), {{Vec3::UnitZ(), 0.4}});
        dynamics::Loads l;
        l.gravity_moment = 20.0;
        const Turning start = steady_precession(tilt, axial_rate, rate, 0.0);
        const GyrostatState end = runge_kutta(g, l, twin_start(g, start, cone_momentum), 2.0).state;
        EXPECT_LE(difference(g, end, steady_precession(tilt, axial_rate, rate, 2.0)), agreement);
        EXPECT_NEAR(end.R_WB(2, 2), std::cos(tilt), agreement);  // no nutation
      }
    }
}

TEST(ClosedForms, a_slow_top_cannot_precess_steadily) {
  const SymmetricBody top{5.0, 1.0, 0.0};
  EXPECT_TRUE(steady_precession_rates(top, 20.0, 0.5, 5.0).empty());
  EXPECT_EQ(steady_precession_rates(top, -20.0, 0.5, 5.0).size(), 2u);  // hanging, it can
  const auto level = steady_precession_rates(top, 20.0, 0.5 * std::numbers::pi, 5.0);
  ASSERT_EQ(level.size(), 1u);
  EXPECT_NEAR(level[0], 4.0, 1e-14);
}

TEST(ClosedForms, constant_torque_about_an_axis_agrees_with_the_twin) {
  const dynamics::Gyrostat g =
      dynamics::make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(), {{Vec3::UnitZ(), 0.5}});
  dynamics::Loads l;
  l.body_torque_B.z() = 0.7;
  l.cones = {{-0.3, 0.0, 0.0}};
  const AxialBody b{2.5, 0.5, 0.7, -0.3};
  const AxialMotion start{0.0, 1.1, 0.0, -6.0};
  GyrostatState s = twin_start(g, {Mat3::Identity(), Vec3(0, 0, 1.1)}, 0.5 * (1.1 - 6.0));
  s = runge_kutta(g, l, s, 10.0).state;
  const AxialMotion end = constant_axial_torque(b, start, 10.0);
  EXPECT_LE((s.R_WB - Mat3(Eigen::AngleAxisd(end.angle, Vec3::UnitZ()))).norm(), agreement);
  EXPECT_NEAR(bit_angular_velocity(g, s).z(), end.rate, agreement);
  EXPECT_NEAR(s.cone_angles[0], end.cone_angle, agreement);
  EXPECT_NEAR(s.cone_momenta[0] / 0.5 - end.rate, end.cone_rate, agreement);
  // Its own invariants: the momenta grow as the torques say.
  EXPECT_NEAR(2.5 * end.rate + 0.5 * (end.rate + end.cone_rate), 2.75 - 2.45 + 7.0, 1e-13);
  EXPECT_NEAR(0.5 * (end.rate + end.cone_rate), -2.45 - 3.0, 1e-13);
}

}  // namespace tdbd::reference::closed_forms_test
