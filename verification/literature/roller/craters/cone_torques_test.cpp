#include "reference/literature/roller/craters/cone_torques.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "verification/battery/generators.hpp"
#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::cone_torques_test {
namespace {

/// Sums over 120 teeth; scale: the largest power among them.
constexpr double of_sums = 1e-12;

/// What the teeth's forces do on their ways is what the bit's torque and the cones' torques do: the arms of
/// the torques are right if the velocities are.
RC_GTEST_PROP(ConeTorques, have_the_power_of_the_forces, ()) {
  const RollerBit bit = example::roller_bit(*battery::number(-8.0, 8.0) * 1e-3);
  const double turn = *battery::number(-3.0, 3.0), speed = *battery::number(1.0, 20.0);
  std::vector<Course> cones;
  std::vector<double> cone_speeds;
  for (int k = 0; k < 3; ++k) {
    cone_speeds.push_back(-speed * *battery::number(0.5, 2.5));
    cones.push_back({*battery::number(-3.0, 3.0), cone_speeds.back(), 0.0});
  }
  std::vector<ToothState> teeth_W;
  place_teeth(bit, {{turn, speed, 0.0}, {}}, cones, teeth_W);
  std::vector<double> vertical;
  for (std::size_t i = 0; i < teeth_W.size(); ++i)
    vertical.push_back(std::max(0.0, *battery::number(-5.0, 5.0)) * 1e3);
  const SlidingOptions options{.friction = 0.4};
  std::vector<ConeTorque> torques(3);
  const RollerLoads loads =
      teeth_loads(bit, turn, teeth_W, vertical, cone_speeds, options, torques);
  double power = 0.0, lost = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < teeth_W.size(); ++i) {
    const Vec3& v = teeth_W[i].velocity;
    const double slip = v.head<2>().norm();
    lost += 0.4 * vertical[i] * slip * slip / std::hypot(slip, options.slip_speed);
    power -= vertical[i] * v.z();
    weight += vertical[i];
  }
  power -= lost;
  double turned = -loads.torque * speed;
  for (std::size_t k = 0; k < 3; ++k)
    turned += (torques[k].pull - torques[k].drag * cone_speeds[k]) * cone_speeds[k];
  RC_ASSERT(std::abs(power - turned) <= of_sums * (1.0 + weight * speed));
  RC_ASSERT(std::abs(loads.force.z() + weight) <= of_sums * (1.0 + weight));
}

/// A bearing takes its torque from the cone, either way.
TEST(ConeTorques, of_a_bearing_are_against_the_turning) {
  RollerBit bit = example::roller_bit(0.0);
  std::vector<ToothState> teeth_W;
  place_teeth(bit, {{0.0, 9.0, 0.0}, {}}, {{0, -14, 0}, {0, 14, 0}, {0, 0, 0}}, teeth_W);
  std::vector<ConeTorque> torques(3);
  const std::vector<double> speeds{-14.0, 14.0, 0.0};
  const SlidingOptions options{.bearing = 5.0, .slip = SlipTime::beginning};
  teeth_loads(bit, 0.0, teeth_W, std::vector<double>(teeth_W.size()), speeds, options, torques);
  EXPECT_NEAR(torque_of_step(torques[0], -14.0, 0.005, 1e-3, options), 5.0, 2e-4);
  EXPECT_NEAR(torque_of_step(torques[1], 14.0, 0.005, 1e-3, options), -5.0, 2e-4);
  EXPECT_EQ(torque_of_step(torques[2], 0.0, 0.005, 1e-3, options), 0.0);
}

/// At the step's end friction stops a cone and never turns it round; at its beginning it overshoots when
/// dt D/Ic > 1.
TEST(ConeTorques, of_friction_at_the_end_of_the_step_do_not_overshoot) {
  const ConeTorque friction{0.0, 20.0};
  const double speed = -10.0, inertia = 0.005, step = 1e-3;
  const auto after = [&](SlipTime slip) {
    return speed + step / inertia * torque_of_step(friction, speed, inertia, step, {.slip = slip});
  };
  EXPECT_NEAR(after(SlipTime::end), speed / 5.0, 1e-12);
  EXPECT_NEAR(after(SlipTime::beginning), 30.0, 1e-12);
}

}  // namespace
}  // namespace tdbd::reference::cone_torques_test
