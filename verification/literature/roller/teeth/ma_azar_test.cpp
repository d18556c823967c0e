#include "reference/literature/roller/teeth/ma_azar.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "bit/cone/cone_bit.hpp"
#include "core/error.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::reference::ma_azar_test {
namespace {

using battery::number;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double speed = 3.0 * std::numbers::pi;  // 90 rpm
constexpr double printed = 5e-12;                 // m: half the last digit of mm with 8 decimals

struct Example {
  RollerCone cone{0.0, 36.0 * degree, 4e-3, 0.0, 0.0, {}};
  ToothPlace tooth{80e-3, 60e-3, 0.2};
  RollerRow row{80e-3, 60e-3, 6e-3, {0.2}};
};

RollerMotion bit_at(double t) {
  return {steady_course(0.0, speed, t), steady_course(0.0, 8.0 / 3600.0, t)};
}

Course cone_at(double t) { return steady_course(0.0, -1.37 * speed, t); }

ToothState state(double t) {
  const Example x;
  return tooth_state(x.cone, x.tooth, bit_at(t), cone_at(t));
}

void expect_mm(const Vec3& found, const Vec3& mm) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], 1e-3 * mm[i], printed) << "component " << i;
}

TEST(MaAzar, gives_the_worked_example_at_the_start) {
  const ToothState x = state(0.0);
  expect_mm(x.place, {99.28548039, 15.92015985, 0.55061084});
  expect_mm(x.velocity, {-59.57649873, 176.46961506, 126.74001635});
  expect_mm(x.acceleration, {-269.67115541, -1696.16874324, -7931.36366294});
}

TEST(MaAzar, gives_the_worked_example_at_13_ms) {
  const ToothState x = state(0.013);
  expect_mm(x.place, {99.97025582, 5.92835014, 1.52201225});
  expect_mm(in_space(Example().cone, bit_at(0.013), x).place,
            {98.49629581, 18.10185335, 1.52201225});
  expect_mm(x.velocity, {-41.23826423, 167.88093138, 22.36573617});
  expect_mm(x.acceleration, {-161.11674435, -572.22007513, -8088.49778905});
}

/// The radius is that of the lowest point, q_r = 100 mm, with the offset.
TEST(MaAzar, gives_the_rolling_and_the_slip_of_the_worked_row) {
  const Example x;
  const ToothState low = tooth_state(x.cone, {x.tooth.along, x.tooth.radius, 0.0}, bit_at(0.0), {});
  EXPECT_NEAR(cylindrical(x.cone, {}, low.place).radius, 100.068e-3, 0.5e-6);
  EXPECT_NEAR(rolling_ratio(x.cone, x.row), 1.66647, 0.5e-5);
  const RowSlip slip = slip_at_the_lowest(x.cone, x.row, 1.37, speed);
  EXPECT_NEAR(slip.tangential, 167.65e-3, 0.5e-5);
  EXPECT_NEAR(slip.radial, -37.70e-3, 0.5e-5);
}

TEST(MaAzar, cylindrical_coordinates_are_those_of_the_place_in_space) {
  const Example x;
  const RollerMotion bit = bit_at(0.013);
  const Vec3 q = state(0.013).place, p_W = in_space(x.cone, bit, state(0.013)).place;
  const CylindricalPlace c = cylindrical(x.cone, bit, q);
  const Vec3 again(c.radius * std::cos(c.azimuth), c.radius * std::sin(c.azimuth), c.depth);
  EXPECT_LE((again - p_W).norm(), 1e-16);
}

TEST(MaAzar, requires_a_motion_of_every_cone) {
  std::vector<ToothState> teeth;
  const RollerBit bit{{Example().cone, Example().cone}};
  try {
    place_teeth(bit, {}, {Course{}}, teeth);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "Ma and Azar: found 1 cone motions, expected one for each of 2 cones");
  }
}

/// Anything that a cone of chapter 2 can be, and any motion of it with second derivatives.
struct AnyMotion {
  RollerCone cone;
  ToothPlace tooth;
  Course turn, depth, cone_turn;
};

Course any_course(double value, double rate, double acceleration) {
  return {*number(-value, value), *number(-rate, rate), *number(-acceleration, acceleration)};
}

AnyMotion any_motion() {
  AnyMotion m;
  m.cone = {
      *number(-3.0, 3.0), *number(0.0, 1.2), *number(-0.01, 0.01), *number(-0.1, 0.1), 0.0, {}};
  m.tooth = {*number(-0.05, 0.1), *number(0.0, 0.1), *number(-3.0, 3.0)};
  m.turn = any_course(3.0, 20.0, 500.0);
  m.depth = any_course(0.5, 0.1, 10.0);
  m.cone_turn = any_course(3.0, 30.0, 500.0);
  return m;
}

/// The course a little later, all of its accelerations constant.
Course later(const Course& c, double t) {
  return {c.value + t * (c.rate + t * c.acceleration / 2.0), c.rate + t * c.acceleration,
          c.acceleration};
}

ToothState state_later(const AnyMotion& m, double t) {
  const RollerMotion bit{later(m.turn, t), later(m.depth, t)};
  return in_space(m.cone, bit, tooth_state(m.cone, m.tooth, bit, later(m.cone_turn, t)));
}

/// First derivative of a vector by central differences of the eighth order.
template <typename F>
Vec3 derivative(const F& f, double h) {
  constexpr std::array weights{4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  Vec3 sum = Vec3::Zero();
  for (int k = 1; k <= 4; ++k) sum += weights[at(k - 1)] / h * (f(k * h) - f(-k * h));
  return sum;
}

/// The step balances the eighth-order remainder, (rate h)^8, with rounding, 1e-16/h.
RC_GTEST_PROP(MaAzar, derivatives_are_those_of_finite_differences, ()) {
  constexpr double h = 2e-4, of_rounding = 1e-9;
  const AnyMotion m = any_motion();
  const ToothState x = state_later(m, 0.0);
  const Vec3 v = derivative([&](double t) { return state_later(m, t).place; }, h);
  const Vec3 a = derivative([&](double t) { return state_later(m, t).velocity; }, h);
  RC_ASSERT((v - x.velocity).norm() <= of_rounding * (1.0 + x.velocity.norm()));
  RC_ASSERT((a - x.acceleration).norm() <= of_rounding * (1.0 + x.acceleration.norm()));
}

/// Our cone with the same journal, at any place along it; our bit's frame in space.
struct Ours {
  bit::ConeLayout layout;
  Pose X_WB;
  Vec3 p_K;
};

Ours ours(const AnyMotion& m) {
  Ours o;
  o.layout.journal_angle = m.cone.journal_angle;
  o.layout.offset = m.cone.offset;
  o.layout.azimuth = m.cone.azimuth;
  o.layout.foot_height = -m.cone.elevation;
  o.layout.apex = *number(-20e-3, 20e-3);
  o.X_WB = {Eigen::AngleAxisd(m.turn.value, Vec3::UnitZ()).toRotationMatrix(),
            Vec3(0, 0, m.depth.value)};
  o.p_K = {m.tooth.radius * std::cos(m.tooth.angle), m.tooth.radius * std::sin(m.tooth.angle),
           -o.layout.apex - m.tooth.along};
  return o;
}

/// Velocity and acceleration of the point from our cone's pose alone, as a body that turns with w_W
/// about its origin, which itself turns with the bit.
ToothState ours_state(const Ours& o, const AnyMotion& m) {
  const Pose X_WK = o.X_WB * bit::cone_pose(o.layout, m.cone_turn.value);
  const Vec3 s_W = X_WK.R.col(2), z = Vec3::UnitZ();
  const Vec3 r_W = X_WK.rotate(o.p_K), c_W = X_WK.p - o.X_WB.p;
  const Vec3 bit_w = m.turn.rate * z, w = bit_w + m.cone_turn.rate * s_W;
  const Vec3 bit_w1 = m.turn.acceleration * z;
  const Vec3 w1 = bit_w1 + m.cone_turn.acceleration * s_W + bit_w.cross(m.cone_turn.rate * s_W);
  return {X_WK * o.p_K, m.depth.rate * z + bit_w.cross(c_W) + w.cross(r_W),
          m.depth.acceleration * z + bit_w1.cross(c_W) + bit_w.cross(bit_w.cross(c_W)) +
              w1.cross(r_W) + w.cross(w.cross(r_W))};
}

/// Relative to the largest terms of each: rates up to 50 rad/s over at most 0.3 m.
constexpr double to_rounding = 1e-12;

RC_GTEST_PROP(MaAzar, a_tooth_moves_as_on_the_cone_of_tdbd, ()) {
  const AnyMotion m = any_motion();
  const Ours o = ours(m);
  const ToothState x = state_later(m, 0.0), y = ours_state(o, m);
  RC_ASSERT((x.place - y.place).norm() <= to_rounding);
  RC_ASSERT((x.velocity - y.velocity).norm() <= to_rounding * 15.0);
  RC_ASSERT((x.acceleration - y.acceleration).norm() <= to_rounding * 750.0);
}

/// The claim's numbers: every tooth of the comparison's bit, at 25 instants of an uneven motion.
TEST(MaAzar, teeth_of_a_bit_move_as_in_tdbd) {
  double place = 0.0, velocity = 0.0, acceleration = 0.0;
  const Example x;
  for (int i = 0; i < 25; ++i)
    for (const RollerRow& row : {x.row, RollerRow{45e-3, 40e-3, 6e-3, {0.0}}})
      for (int j = 0; j < 25; ++j) {
        AnyMotion m{x.cone,
                    {row.along, row.radius, 0.25 * j},
                    {0.3, speed, -40.0},
                    {0.1, 3e-3, 0.5},
                    {0.7, -1.6 * speed, 90.0}};
        m.turn = later(m.turn, 0.01 * i);
        m.cone_turn = later(m.cone_turn, 0.01 * i);
        Ours o;
        o.layout.journal_angle = m.cone.journal_angle;
        o.layout.offset = m.cone.offset;
        o.X_WB = {Eigen::AngleAxisd(m.turn.value, Vec3::UnitZ()).toRotationMatrix(),
                  Vec3(0, 0, m.depth.value)};
        o.p_K = {m.tooth.radius * std::cos(m.tooth.angle), m.tooth.radius * std::sin(m.tooth.angle),
                 -m.tooth.along};
        const ToothState a = state_later(m, 0.0), b = ours_state(o, m);
        place = std::max(place, (a.place - b.place).norm());
        velocity = std::max(velocity, (a.velocity - b.velocity).norm() / b.velocity.norm());
        acceleration = std::max(acceleration,
                                (a.acceleration - b.acceleration).norm() / b.acceleration.norm());
      }
  const auto recorded = [](const std::string& what, double worst, const std::string& unit) {
    EXPECT_LE(worst, to_rounding) << what;
    battery::record({"chapter2/tooth-kinematics", "two rows at 25 instants: " + what, worst, unit,
                     "<= 1e-12",
                     worst <= to_rounding ? battery::Verdict::holds : battery::Verdict::refuted});
  };
  recorded("place", place, "m");
  recorded("velocity, relative", velocity, "1");
  recorded("acceleration, relative", acceleration, "1");
}

/// The same point by the pose of a part, as a run of the program moves it.
RC_GTEST_PROP(MaAzar, a_tooth_is_at_the_place_of_the_part_of_tdbd, ()) {
  const AnyMotion m = any_motion();
  const Ours o = ours(m);
  bit::Bit b;
  b.cones = {{"cone-1", o.layout, bit::cone_pose(o.layout, 0.0)}};
  bit::Part part;
  part.cone = 0;
  part.X_BP = b.cones[0].X_BK * Pose{*battery::rotation(), o.p_K};
  const Pose X_BP = bit::part_pose(b, part, {m.cone_turn.value});
  RC_ASSERT(((o.X_WB * X_BP).p - state_later(m, 0.0).place).norm() <= to_rounding);
}

RC_GTEST_PROP(MaAzar, all_teeth_at_once_are_the_teeth_one_by_one, ()) {
  const AnyMotion m = any_motion();
  RollerBit bit{{m.cone, m.cone}};
  bit.cones[0].rows = {{m.tooth.along, m.tooth.radius, 0.0, {m.tooth.angle, 1.0}},
                       {0.01, 0.02, 0.0, {2.0}}};
  bit.cones[1].rows = {{m.tooth.along, m.tooth.radius, 0.0, {0.3}}};
  bit.cones[1].azimuth += 2.0;
  const RollerMotion motion{m.turn, m.depth};
  const std::vector<Course> turns{m.cone_turn, later(m.cone_turn, 0.01)};
  std::vector<ToothState> teeth;
  place_teeth(bit, motion, turns, teeth);
  std::size_t next = 0;
  for (std::size_t k = 0; k < 2; ++k)
    for (const RollerRow& row : bit.cones[k].rows)
      for (const double angle : row.angles) {
        const ToothState x =
            in_space(bit.cones[k], motion,
                     tooth_state(bit.cones[k], {row.along, row.radius, angle}, motion, turns[k]));
        RC_ASSERT(teeth[next].place == x.place);
        RC_ASSERT(teeth[next].velocity == x.velocity);
        RC_ASSERT(teeth[next++].acceleration == x.acceleration);
      }
  RC_ASSERT(next == teeth.size());
}

/// At its own ratio a row without offset stands still where it is lowest, along the motion.
RC_GTEST_PROP(MaAzar, a_row_at_its_own_ratio_does_not_slip_along_the_motion, ()) {
  AnyMotion m = any_motion();
  const RollerRow row{0.01 + std::abs(m.tooth.along), 0.01 + m.tooth.radius, 0.0, {0.0}};
  const double ratio = *number(0.5, 2.5), bit_speed = *number(1.0, 20.0);
  const RollerMotion bit{{0.0, bit_speed, 0.0}, {}};
  const ToothState x =
      tooth_state(m.cone, {row.along, row.radius, 0.0}, bit, {0.0, -ratio * bit_speed, 0.0});
  const RowSlip slip = slip_at_the_lowest(m.cone, row, ratio, bit_speed);
  RC_ASSERT(std::abs(slip.tangential - x.velocity.y()) <= to_rounding * 15.0);
  RC_ASSERT(std::abs(slip.radial - x.velocity.x()) <= to_rounding * 15.0);
  const double own = rolling_ratio(m.cone, row);
  RC_ASSERT(std::abs(slip_at_the_lowest(m.cone, row, own, bit_speed).tangential) == 0.0);
}

}  // namespace
}  // namespace tdbd::reference::ma_azar_test
