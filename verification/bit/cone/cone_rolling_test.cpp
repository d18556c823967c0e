#include "bit/cone/cone_rolling.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_frame.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone_generate.hpp"
#include "bit/files/bit_reading.hpp"

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

/// A tooth's tip is as far from the journal as its row says, at every angle.
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
