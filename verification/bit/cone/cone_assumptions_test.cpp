#include "bit/cone/cone_assumptions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

#include "bit/cone/cone_measures.hpp"
#include "bit/cone/part_pose.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/mass_properties.hpp"
#include "core/angles.hpp"

namespace tdbd::bit::cone_assumptions_test {

/// The modulations are shares of the bit's inertia about its own axis, and the torque that is left out is
/// W^2 (A1 / 2 + A2): bit (11), bit (12). A bit off its axis has the more inertia about it.
TEST(ConeAssumptions, are_shares_of_the_inertia_about_the_axis) {
  Bit b = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  constexpr double speed = 12.0;
  for (const double aside : {0.0, 0.02}) {
    for (Part& part : b.parts)
      if (part.kind == PartKind::bit_body) part.X_BP.p.x() += aside;
    const MassProperties m = mass_properties(b);
    const double inertia = m.inertia(2, 2) + m.mass * m.centre.head<2>().squaredNorm();
    const ConeAssumptions a = cone_assumptions(b, 0, speed, 1.4);
    EXPECT_GT(a.torque_error, 0.0);
    EXPECT_NEAR(a.torque_error,
                speed * speed * inertia * (0.5 * a.modulation_once + a.modulation_twice),
                1e-14 * a.torque_error);
  }
}

/// About the axis of the bit.
double axial_inertia(const Bit& b) {
  const MassProperties m = mass_properties(b);
  return m.inertia(2, 2) + m.mass * m.centre.head<2>().squaredNorm();
}

/// Of the first cone as it turns: amplitudes of the bit's axial inertia at once and twice its frequency.
std::pair<double, double> swings(const Bit& b) {
  constexpr int n = 16;
  std::complex<double> once = 0.0, twice = 0.0;
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * pi * k / n;
    const double inertia = axial_inertia(turned(b, {angle, 0.0, 0.0}));
    once += 2.0 / n * std::polar(inertia, -angle);
    twice += 2.0 / n * std::polar(inertia, -2.0 * angle);
  }
  return {std::abs(once), std::abs(twice)};
}

/// Bit R with a tooth of its first cone as heavy as many.
Bit lopsided(double times) {
  Bit b = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const auto tooth = std::ranges::find_if(b.parts, [](const Part& p) {
    return p.kind == PartKind::tooth && p.cone == 0 && p.row == 2;
  });
  tooth->density *= times;
  return b;
}

/// The inertia of a turned bit swings at most by what is told at once, and by what is told at twice the
/// frequency: to first order in the asymmetry.
TEST(ConeAssumptions, bound_the_swing_of_the_inertia_of_a_turned_bit) {
  for (const double times : {5.0, 250.0}) {
    const Bit b = lopsided(times);
    const ConeAssumptions a = cone_assumptions(b, 0, 12.0, 1.4);
    const auto [once, twice] = swings(b);
    EXPECT_LE(once, a.modulation_once * axial_inertia(b));
    EXPECT_NEAR(twice, a.modulation_twice * axial_inertia(b), 5e-6 * twice);  // 2e-6 seen
    EXPECT_NEAR(a.gravity_torque * 12.0 * 12.0 * 1.4 * 1.4, 9.80665 * a.unbalance_force,
                1e-13 * a.unbalance_force);
  }
}

/// By hand, in m, kg and s: the rest of what is told follows from the cone's mass, its centre's distance from
/// its axis, its speed and standard gravity.
TEST(ConeAssumptions, are_those_of_a_mass_that_goes_round) {
  const Bit b = lopsided(50.0);
  const ConeMass c = cone_mass(b, 0);
  const double mass = c.body_K.mass, e = c.centre_off_axis, speed = -12.0 * 1.4;
  const ConeAssumptions a = cone_assumptions(b, 0, -12.0, 1.4);
  constexpr double rounding = 2e-15;
  EXPECT_NEAR(a.cone_speed, speed, rounding * 12.0);
  EXPECT_NEAR(a.unbalance_force / (mass * e * speed * speed), 1.0, rounding);
  EXPECT_NEAR(a.unbalance_share * mass_properties(b).mass * 9.80665 / a.unbalance_force, 1.0,
              rounding);
  EXPECT_NEAR(a.gravity_torque / (mass * e * 9.80665), 1.0, rounding);
  EXPECT_NEAR(a.frequency * 2.0 * pi / -speed, 1.0, rounding);
  EXPECT_NEAR(a.torque_share * c.axial_inertia * speed * speed / a.torque_error, 1.0, rounding);
  EXPECT_GT(a.unbalance_force, 1.0);
}

/// Parallel to the bit's axis only the eccentric mass swings, by 2 m e r; on the bit's axis and tilted
/// only the products of inertia do. Either is told exactly.
TEST(ConeAssumptions, tell_either_swing_by_itself) {
  const ConeMass c = cone_mass(lopsided(50.0), 0);
  const Mat3 tilted = Eigen::AngleAxisd(0.6, Vec3(0.8, 0.6, 0.0)).toRotationMatrix();
  const double height = c.body_K.centre.z();
  for (const Pose& X_BK : {Pose{Mat3::Identity(), Vec3(0.05, 0.02, 0.0)},
                           Pose{tilted, Vec3(-height * tilted.col(2))}}) {
    Bit b = lopsided(50.0);
    for (Part& part : b.parts)
      if (part.cone == 0) part.X_BP = X_BK * (inverse(b.cones[0].X_BK) * part.X_BP);
    b.cones[0].X_BK = X_BK;
    const double told = cone_assumptions(b, 0, 12.0, 1.4).modulation_once * axial_inertia(b);
    Bit alone = b;  // what else turns with the bit does not swing
    std::erase_if(alone.parts, [](const Part& p) { return p.cone != 0; });
    std::complex<double> swing = 0.0;
    for (int k = 0; k < 16; ++k) {
      const double angle = pi * k / 8.0;
      const Pose turn{Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()};
      Bit at = alone;
      for (Part& part : at.parts) part.X_BP = X_BK * turn * inverse(X_BK) * part.X_BP;
      swing += std::polar(axial_inertia(at) / 8.0, -angle);
    }
    EXPECT_NEAR(std::abs(swing), told, 1e-11 * told);
    EXPECT_GT(told, 1e-5);
  }
}

}  // namespace tdbd::bit::cone_assumptions_test
