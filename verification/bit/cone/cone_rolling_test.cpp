#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

#include "bit/bit.hpp"
#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone_generate.hpp"
#include "bit/files/bit_reading.hpp"
#include "core/types.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::bit::cone_rolling_test {

using rotation::Twist;

constexpr double rounding = 1e-12;  ///< of sums of a few products; scale: the largest term

Vec3 any_vector(double size) {
  return {number(-size, size), number(-size, size), number(-size, size)};
}

Twist any_twist() { return {any_vector(10.0), any_vector(0.1)}; }

std::vector<ConeContact> any_contacts() {
  std::vector<ConeContact> contacts;
  const int count = *rc::gen::inRange(1, 9);
  contacts.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) contacts.push_back({any_vector(0.1), number(1e-9, 1e-7)});
  return contacts;
}

double balanced(const SlipBalance& b) { return -b.moment / b.inertia; }

Vec3 slip(const Pose& X_BK, const Twist& bit, const Vec3& x_B, double speed) {
  return rotation::velocity_B(bit, x_B) + speed * X_BK.R.col(2).cross(x_B - X_BK.p);
}

/// One row without offset or skew, its contact straight below the journal: the exact ratio R/rho.
RC_GTEST_PROP(ConeRolling, a_single_row_on_a_flat_bottom_rolls_at_R_over_rho, ()) {
  ConeLayout c = any_cone();
  c.offset = c.skew = 0.0;
  const Pose X_BK = cone_pose(c, 0.0);
  const double rho = number(0.02, 0.08), along = number(-0.12, -0.06), w = number(1.0, 20.0);
  const Vec3 down = (Vec3::UnitZ() - X_BK.R(2, 2) * X_BK.R.col(2)).normalized();
  const Vec3 place = X_BK * Vec3(0, 0, along) + rho * down;
  const Vec3 inwards = X_BK.R.col(2) - X_BK.R(2, 2) * Vec3::UnitZ();
  const double R = -place.dot(inwards.normalized());
  const Twist bit{Vec3(0, 0, w), Vec3(0, 0, number(0.0, 0.01))};
  const double speed = balanced(slip_balance(X_BK, bit, {{place, 1.0}}));
  RC_ASSERT(std::abs(speed + w * R / rho) < rounding * w * 10);
}

/// Ahead of the lowest place and behind it alike, by psi: R/rho cos psi (journal level).
TEST(ConeRolling, contacts_before_the_lowest_place_slow_the_cone) {
  const ConeLayout c;
  const double R = 0.08, rho = 0.05, psi = 0.3;
  std::vector<ConeContact> contacts;
  for (const double side : {-psi, psi})
    contacts.push_back({{R, rho * std::sin(side), rho * std::cos(side)}, 2.0});
  const SlipBalance b = slip_balance(cone_pose(c, 0.0), {Vec3(0, 0, 3.0), Vec3::Zero()}, contacts);
  EXPECT_NEAR(balanced(b), -3.0 * R / rho * std::cos(psi), 1e-13);
}

/// No torque is left about the journal, and no other speed slips less.
RC_GTEST_PROP(ConeRolling, balances_the_torque_at_the_least_slip, ()) {
  const Pose X_BK = cone_pose(any_cone(), number(-pi, pi));
  const Twist bit = any_twist();
  const std::vector<ConeContact> contacts = any_contacts();
  const SlipBalance b = slip_balance(X_BK, bit, contacts);
  const auto squares = [&](double speed) {
    double sum = 0.0;
    for (const ConeContact& c : contacts)
      sum += c.weight * slip(X_BK, bit, c.x_B, speed).squaredNorm();
    return sum;
  };
  double torque = 0.0, scale = 0.0;
  for (const ConeContact& c : contacts) {
    const Vec3 r = c.x_B - X_BK.p, force = -c.weight * slip(X_BK, bit, c.x_B, balanced(b));
    torque += X_BK.R.col(2).dot(r.cross(force));
    scale += r.norm() * force.norm();
  }
  RC_ASSERT(std::abs(torque) <= rounding * scale);
  const double step = 1.0 + std::abs(balanced(b));
  RC_ASSERT(squares(balanced(b)) < squares(balanced(b) + step));
  RC_ASSERT(squares(balanced(b)) < squares(balanced(b) - step));
}

/// A bit turned about z rolls its cones alike, and so does one whose contacts all weigh more.
RC_GTEST_PROP(ConeRolling, does_not_depend_on_azimuth_or_weight, ()) {
  const ConeLayout cone = any_cone();
  ConeLayout turned_cone = cone;
  const double angle = number(-pi, pi), factor = number(0.1, 10.0);
  turned_cone.azimuth += angle;
  const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  const Twist bit = any_twist(), turned_bit{turn * bit.angular_B, turn * bit.linear_B};
  std::vector<ConeContact> contacts = any_contacts();
  const double speed = balanced(slip_balance(cone_pose(cone, 0.0), bit, contacts));
  for (ConeContact& c : contacts) c = {turn * c.x_B, factor * c.weight};
  const SlipBalance turned = slip_balance(cone_pose(turned_cone, 1.0), turned_bit, contacts);
  RC_ASSERT(std::abs(balanced(turned) - speed) <= rounding * (1.0 + std::abs(speed)));
}

/// The tip of a tooth is as far from the journal as its row specifies, at every angle.
RC_GTEST_PROP(ConeRolling, finds_the_tips_of_teeth, ()) {
  ConeLayout layout = toothed_cone();
  for (ToothRow& row : layout.rows) row.shape = any_tooth();
  const Cone cone{"cone-1", layout, cone_pose(layout, 0.0)};
  std::size_t i = 0;
  for (const ToothRow& row : layout.rows)
    for (const double angle : row.angles) {
      const Part tooth = cone_parts(cone, 0)[++i];
      const Vec3 tip_B =
          cone.X_BK * (tooth_pose(layout, row, angle) * Vec3(0, 0, row.shape.protrusion));
      RC_ASSERT((tooth.X_BP * tooth_tip_P(tooth) - tip_B).norm() < 1e-12);
    }
}

TEST(ConeRolling, takes_the_ratio_of_the_gage_row) {
  ConeLayout layout;
  layout.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  ToothRow inner, gage;
  inner.s = 0.07;  // farther out than the row at the gage
  gage.s = 0.04;
  gage.place = RowPlace::gage;
  inner.angles = gage.angles = {0.0};
  layout.rows = {gage, inner};
  const auto ratio = [&] {
    return rolling_ratio_of_gage_row({"cone-1", layout, cone_pose(layout, 0.0)});
  };
  const double with_gage = ratio();
  EXPECT_GT(with_gage, 0.0);
  layout.rows = {inner, gage};
  EXPECT_EQ(ratio(), with_gage);
  layout.rows.back().place = RowPlace::inner;  // then the outermost row
  EXPECT_NE(ratio(), with_gage);
  layout.rows.pop_back();
  const double outermost = ratio();
  layout.rows.push_back(gage);
  layout.rows.back().place = RowPlace::inner;
  EXPECT_EQ(ratio(), outermost);
}

/// A cone of solids has no rows; the ratio is computed from its teeth.
TEST(ConeRolling, takes_the_ratio_of_a_cone_without_rows_from_its_teeth) {
  constexpr double bound = 1e-4;
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    const double of_row = rolling_ratio_of_gage_row(bit.cones[k]);
    Cone cone = bit.cones[k];
    cone.layout.rows.clear();
    EXPECT_EQ(rolling_ratio_of_gage_row(cone), 0.0);
    cone.rolling_ratio = rolling_ratio_of_parts(cone, static_cast<int>(k), bit.parts);
    EXPECT_NEAR(rolling_ratio_of_gage_row(cone), of_row, bound * of_row) << k;
    fmt::print("cone {}: {:.4f} of its gage row, {:.4f} of its teeth\n", k, of_row,
               cone.rolling_ratio);
  }
  EXPECT_EQ(rolling_ratio_of_parts(bit.cones[0], 3, bit.parts), 0.0);  // no part of such a cone
}

}  // namespace tdbd::bit::cone_rolling_test

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

/// The inertia of a rotating bit oscillates at most by the reported amplitudes at once and twice
/// the frequency, to first order in the asymmetry.
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

/// Computed manually, in m, kg and s: the other reported values follow from the mass of the cone,
/// the distance of its centre from its axis, its speed and standard gravity.
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

/// Parallel to the bit's axis only the eccentric mass swings, by 2 m e r; on the bit's axis and
/// tilted only the products of inertia do. Both are reported exactly.
TEST(ConeAssumptions, report_each_oscillation_by_itself) {
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

namespace tdbd::bit::cone_measures_test {

/// A block of 2 x 3 x 5 cm of steel, 4 cm beside the axis of a cone that stands anywhere.
TEST(ConeMass, of_a_block_beside_the_axis_is_that_of_steiners_theorem) {
  constexpr double a = 0.02, b = 0.03, c = 0.05, off = 0.04, density = 7800.0;
  constexpr double rounding = 2.5e-15;  // relative
  Bit bit;
  bit.cones.resize(2);
  bit.cones[1].X_BK = {.R = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix(),
                       .p = Vec3(0.1, -0.2, 0.05)};
  Part block;
  block.cone = 1;
  block.density = density;
  block.mesh_P = battery::box({off - 0.5 * a, -0.5 * b, 0.0}, {off + 0.5 * a, 0.5 * b, c});
  block.X_BP = bit.cones[1].X_BK;
  bit.parts.push_back(block);
  Part other = block;
  other.cone = 0;
  bit.parts.push_back(other);
  const ConeMass m = cone_mass(bit, 1);
  const double mass = density * a * b * c;
  const double axial = mass * ((a * a + b * b) / 12.0 + off * off);
  EXPECT_NEAR(m.body_K.mass, mass, rounding * mass);
  EXPECT_NEAR(m.centre_off_axis, off, rounding * off);
  EXPECT_NEAR(m.axial_inertia, axial, rounding * axial);
  EXPECT_NEAR(m.asymmetry, mass * (b * b - a * a) / 12.0 / axial, rounding);
}

}  // namespace tdbd::bit::cone_measures_test
