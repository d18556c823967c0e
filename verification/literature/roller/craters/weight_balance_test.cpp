#include "reference/literature/roller/craters/weight_balance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/roller/craters/cone_recursion.hpp"
#include "reference/literature/roller/craters/cone_torques.hpp"
#include "reference/literature/roller/craters/line_spectrum.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"
#include "verification/battery/generators.hpp"
#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::weight_balance_test {

constexpr std::array heights{0.0, 0.4e-3, 0.7e-3, 1.1e-3, 1.6e-3, 2.0e-3};

/// The worked places are those of a search down to 1e-6 mm; forces are printed to 0.01 N.
constexpr double of_print = 1e-10, of_force = 6e-3;

struct SixTeeth {
  ToothLaw law = PowerTooth{5000.0 / std::pow(1e-3, 1.5), 1.5, 6e-3};
  double operator()(double z) const {
    double sum = 0.0;
    for (const double h : heights) sum += tooth_force(law, z - h);
    return sum;
  }
};

void expect_forces(double z, const std::array<double, 6>& expected, double tolerance) {
  const SixTeeth teeth;
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(tooth_force(teeth.law, z - heights[i]), expected[i], tolerance) << i;
}

BalanceOptions finely(BalanceSearch search) {
  BalanceOptions options;
  options.tolerance = 1e-13;
  options.search = search;
  return options;
}

TEST(WeightBalance, gives_the_worked_places_and_forces) {
  for (const BalanceSearch search : {BalanceSearch::bisection, BalanceSearch::itp}) {
    const auto light = weight_balance(SixTeeth{}, 0.0, 20e3, finely(search), "test");
    EXPECT_NEAR(light.z, 1.5071192e-3, of_print);
    expect_forces(light.z, {9251.06, 5824.54, 3625.57, 1298.83, 0, 0}, of_force);
    const auto heavy = weight_balance(SixTeeth{}, 0.0, 88964.0, finely(search), "test");
    EXPECT_NEAR(heavy.z, 2.9714520e-3, of_print);
    expect_forces(heavy.z, {25610.8, 20617.6, 17116.9, 12800.8, 8030.5, 4787.4}, 0.06);
  }
}

/// [0, 10] mm down to 1e-6 mm.
TEST(WeightBalance, takes_24_halvings_or_a_third_of_them) {
  const SixTeeth teeth;
  const WeightBracket in{0.0, 10e-3, teeth(0.0) - 20e3, teeth(10e-3) - 20e3};
  BalanceOptions options;
  options.search = BalanceSearch::bisection;
  EXPECT_EQ(narrow_balance(teeth, in, 20e3, options).narrowings, 24);
  options.search = BalanceSearch::itp;
  const WeightBalance found = narrow_balance(teeth, in, 20e3, options);
  EXPECT_LE(found.narrowings, 9);
  EXPECT_NEAR(found.z, 1.5071192e-3, 1e-9);
}

RC_GTEST_PROP(WeightBalance, more_weight_goes_deeper_and_the_weight_is_carried, ()) {
  const auto search = *rc::gen::element(BalanceSearch::bisection, BalanceSearch::itp);
  const double weight = *battery::number(0.1, 200.0) * 1e3,
               more = *battery::number(0.1, 50.0) * 1e3;
  const double start = *battery::number(-30.0, 30.0) * 1e-3;
  const auto a = weight_balance(SixTeeth{}, start, weight, finely(search), "test");
  const auto b = weight_balance(SixTeeth{}, start, weight + more, finely(search), "test");
  RC_ASSERT(b.z > a.z);
  RC_ASSERT(std::abs(SixTeeth{}(a.z) - weight) <= 1e-7 * weight);
}

/// A tooth that does not spring back gives a weight with jumps: no more than one step beyond halves.
RC_GTEST_PROP(WeightBalance, finds_jumps_in_as_many_steps_as_bisection_and_one, ()) {
  const double jump = *battery::number(0.0, 9.0) * 1e-3;
  const auto weight_at = [&](double z) { return z < jump ? 0.1 * z : 1e4 + z; };
  const WeightBracket in{-1e-3, 10e-3, weight_at(-1e-3) - 5e3, weight_at(10e-3) - 5e3};
  const WeightBalance found = narrow_balance(weight_at, in, 5e3, {});
  RC_ASSERT(std::abs(found.z - jump) <= 1e-9);
  RC_ASSERT(found.narrowings <= 24 + 1);
}

TEST(WeightBalance, counts_its_evaluations) {
  int asked = 0;
  const auto weight_at = [&](double z) {
    ++asked;
    return SixTeeth{}(z);
  };
  for (const double start : {-50e-3, 0.0, 1.5e-3, 2e-3, 300e-3}) {
    asked = 0;
    EXPECT_EQ(weight_balance(weight_at, start, 20e3, {}, "test").evaluations, asked) << start;
  }
}

TEST(WeightBalance, reports_that_nothing_carries_the_weight) {
  const auto table = [](double z) { return std::min(1e4, std::max(0.0, z * 1e6)); };
  try {
    weight_balance(table, 0.0, 2e4, {}, "Ma, Zhou and Deng");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).substr(0, 62),
              "Ma, Zhou and Deng: no root for z: found 10000 N at the end of ");
  }
}

/// Sums of a few hundred increments; scale: the result.
constexpr double of_sums = 1e-12;

/// An observed order differs from the scheme's by this at most; scale: 1.
constexpr double of_orders = 0.06;

ConeProblem constant(double torque, double speed) {
  return {0.005, speed, 0.1, [torque](double, double) { return torque; }};
}

/// A cone that rocks between teeth, with drag that grows with the square of its speed.
ConeProblem rocking() {
  return {0.005, -12.9, 0.2, [](double angle, double speed) {
            return 0.8 * std::sin(3.0 * angle) - 2e-4 * speed * std::abs(speed);
          }};
}

/// Ic = 0.005 kg m2, T = 2 N m, 100 steps of 1 ms from rest.
TEST(ConeRecursion, gives_the_worked_table_of_its_readings) {
  const auto rows = recursion_table(constant(2.0, 0.0), 100);
  ASSERT_EQ(rows.size(), 4U);
  const double expected[] = {1.0e-6, 0.0400, 2.0200, 2.0000};
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_NEAR(rows[i].result, expected[i], of_sums * expected[i]) << i;
  EXPECT_NEAR(rows[2].error, 0.02, of_sums);
  EXPECT_EQ(rows[3].order.verdict, OrderVerdict::exact);
  // What is no integrator does not come nearer with the step.
  EXPECT_NEAR(rows[0].error, 2.0, 1e-5);
  EXPECT_NEAR(rows[1].error, 1.96, of_sums);
}

/// Without torque a cone coasts; only the increments know that.
TEST(ConeRecursion, coasts_only_when_it_adds_increments) {
  const auto rows = recursion_table(constant(0.0, -12.9), 100);
  EXPECT_EQ(rows[0].result, 0.0);
  EXPECT_EQ(rows[1].result, 0.0);
  EXPECT_NEAR(rows[2].result, -1.29, of_sums);
  EXPECT_NEAR(rows[3].result, -1.29, of_sums);
}

/// The result of reading (ii) is (T/Ic) t dt: it halves with the step.
TEST(ConeRecursion, without_inertia_the_angle_tends_to_nothing_with_the_step) {
  const ConeProblem p = constant(2.0, 0.0);
  const double coarse = recursion_result(p, ConeReading::divided, ConeStart::simple, 100);
  const double fine = recursion_result(p, ConeReading::divided, ConeStart::simple, 200);
  EXPECT_NEAR(fine, 0.5 * coarse, of_sums);
}

TEST(ConeRecursion, is_of_second_order_from_half_a_step_back_and_of_first_otherwise) {
  const auto rows = recursion_table(rocking(), 200);
  ASSERT_EQ(rows[2].order.verdict, OrderVerdict::order);
  ASSERT_EQ(rows[3].order.verdict, OrderVerdict::order);
  EXPECT_NEAR(rows[2].order.order, 1.0, of_orders);
  EXPECT_NEAR(rows[3].order.order, 2.0, of_orders);
  EXPECT_LT(rows[3].error, 0.5 * rows[2].error);
  for (int i = 0; i < 2; ++i)
    EXPECT_LT(std::abs(rows[static_cast<std::size_t>(i)].order.order_of_all), 2e-6) << i;
}

/// A tooth held by rock of stiffness k at radius rho is a spring on the cone: the torque of a step's
/// beginning is stable up to dt2 k rho2/Ic = 4.
TEST(ConeRecursion, runs_away_beyond_its_limit_of_stiffness) {
  constexpr double k = 1e7, rho = 0.06, inertia = 0.005;
  const double limit = std::sqrt(4.0 * inertia / (k * rho * rho));
  EXPECT_NEAR(limit, 0.745e-3, 1e-6);
  const auto after = [&](double step) {
    ConeTurn cone = started_cone(1e-3, 0.0, 0.0, inertia, step, ConeStart::half_step);
    double largest = 0.0;
    for (int i = 0; i < 2000; ++i) {
      advance_cone(cone, ConeReading::increments, -k * rho * rho * cone.angle, inertia, step);
      largest = std::max(largest, std::abs(cone.angle));
    }
    return largest;
  };
  EXPECT_LT(after(0.99 * limit), 20e-3);
  EXPECT_GT(after(1.01 * limit), 1e10);
}

/// Rounding of a recursion over 2000 readings; scale: the largest amplitude.
constexpr double of_recursion = 1e-9;

TEST(LineSpectrum, finds_the_amplitudes_of_sines_and_nothing_between_them) {
  constexpr double step = 1e-3, pi = std::numbers::pi;
  std::vector<double> series;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * step;
    series.push_back(7.0 + 3.0 * std::sin(2 * pi * 60.0 * t + 0.4) +
                     0.5 * std::cos(2 * pi * 150.5 * t));
  }
  constexpr std::array frequencies{60.0, 100.0, 150.5};
  const std::vector<double> a = line_spectrum(series, step, frequencies);
  EXPECT_NEAR(a[0], 3.0, of_recursion);
  EXPECT_NEAR(a[1], 0.0, of_recursion);
  EXPECT_NEAR(a[2], 0.5, of_recursion);
}

}  // namespace tdbd::reference::weight_balance_test

namespace tdbd::reference::cone_torques_test {

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

}  // namespace tdbd::reference::cone_torques_test
