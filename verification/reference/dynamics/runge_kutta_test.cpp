#include "reference/dynamics/runge_kutta.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "battery/evidence.hpp"
#include "battery/golden.hpp"
#include "core/error.hpp"
#include "reference/dynamics/work_precision.hpp"

namespace tdbd::reference::runge_kutta_test {

using dynamics::Loads;

/// What rounding leaves after 10 s and up to 500 rad, also of free_asym_unstable, which passes the saddle again and
/// again: that multiplies every rounding by 1e4. Scale: 1 + momentum, angles in rad.
constexpr double rounding = 1e-12;

double largest_difference(const GyrostatState& a, const battery::GoldenState& b) {
  double d = (a.R_WB - b.R_WB).norm() + (a.body_momentum_B - b.body_momentum_B).norm();
  for (std::size_t k = 0; k < b.cone_angles.size(); ++k)
    d += std::abs(a.cone_angles[k] - b.cone_angles[k]) +
         std::abs(a.cone_momenta[k] - b.cone_momenta[k]);
  return d;
}

TEST(RungeKutta, reproduces_every_golden_state) {
  for (const std::string& name : battery::golden_names()) {
    const battery::GoldenCase c = battery::read_golden_case(name);
    double largest = 0.0;
    for (std::size_t i = 1; i < c.states.size(); ++i) {
      const GyrostatState s =
          runge_kutta(c.gyrostat, c.loads, matrix_state(c.initial), c.states[i].time).state;
      const double scale = 1.0 + c.states[i].body_momentum_B.norm();
      largest = std::max(largest, largest_difference(s, c.states[i]) / scale);
      EXPECT_NEAR(total_energy(c.gyrostat, c.loads, s), c.states[i].energy,
                  rounding * (1.0 + std::abs(c.states[i].energy)));
    }
    EXPECT_LE(largest, rounding) << name;
    battery::record({"chapter5/equations",
                     "Runge-Kutta twin against the Taylor series in 50 digits, golden " + name,
                     largest, "1", fmt::format("<= {:.0e}", rounding),
                     largest <= rounding ? battery::Verdict::holds : battery::Verdict::refuted});
  }
}

dynamics::Gyrostat body(const Vec3& principal, std::vector<dynamics::Cone> cones = {}) {
  return dynamics::make_gyrostat(principal.asDiagonal(), std::move(cones));
}

GyrostatState at_rest(std::size_t cones = 0) {
  GyrostatState s;
  s.cone_angles.assign(cones, 0.0);
  s.cone_momenta.assign(cones, 0.0);
  return s;
}

double angle_about_z(const GyrostatState& s) { return std::atan2(s.R_WB(1, 0), s.R_WB(0, 0)); }

/// I theta'' = -k theta, thrown so hard that the spring winds up by 20 rad: windings count.
TEST(RungeKutta, a_torsion_spring_counts_windings) {
  Loads l;
  l.stiffness_W = Vec3(0.0, 0.0, 0.75);
  GyrostatState s = at_rest();
  const double omega = std::sqrt(0.75 / 3.0), amplitude = 20.0;
  s.body_momentum_B.z() = 3.0 * omega * amplitude;
  for (const double t : {1.0, 3.0, 7.0, 10.0}) {
    const GyrostatState end = runge_kutta(body({2, 2, 3}), l, s, t).state;
    EXPECT_NEAR(end.twist, amplitude * std::sin(omega * t), 1e-12) << t;
    EXPECT_NEAR(end.body_momentum_B.z(), 3.0 * amplitude * omega * std::cos(omega * t), 1e-12);
  }
}

/// A free spherical body turns about a tilted axis u: q = (cos, u sin) of half the angle, and twist
/// = 2 atan2(u_z sin, cos), a turn for every turn. The spring is there so that the twist is
/// computed; it is too soft to matter.
TEST(RungeKutta, a_tilted_body_winds_the_twist_too) {
  Loads l;
  l.stiffness_W.z() = 1e-30;
  GyrostatState s = at_rest();
  const Vec3 axis(std::sqrt(0.75), 0.0, 0.5);
  s.body_momentum_B = 2.0 * 4.0 * axis;
  for (const double t : {1.0, 2.5, 10.0}) {
    const double half = 0.5 * 4.0 * t, turns = std::round(half / std::numbers::pi);
    const double rest = half - turns * std::numbers::pi;
    const double twist = 2.0 * (std::atan(0.5 * std::tan(rest)) + turns * std::numbers::pi);
    EXPECT_NEAR(runge_kutta(body({2, 2, 2}), l, s, t).state.twist, twist, 1e-12) << t;
  }
}

TEST(RungeKutta, a_damper_brakes_exponentially) {
  Loads l;
  l.damping_W = Vec3(9.0, 9.0, 1.5);
  GyrostatState s = at_rest();
  s.body_momentum_B.z() = 6.0;
  const GyrostatState end = runge_kutta(body({2, 2, 3}), l, s, 2.0).state;
  EXPECT_NEAR(end.body_momentum_B.z(), 6.0 * std::exp(-1.0), 1e-13);
  EXPECT_NEAR(angle_about_z(end), 2.0 * 2.0 * (1.0 - std::exp(-1.0)), 1e-13);
}

TEST(RungeKutta, springs_keep_the_energy_of_an_unsymmetric_body_with_cones) {
  const dynamics::Gyrostat g = body({2.0, 2.6, 3.0}, {{Vec3(1, 0, 1), 0.1}, {Vec3(0, 1, 1), 0.2}});
  Loads l;
  l.stiffness_W = Vec3(4.0, 6.0, 2.0);
  l.gravity_moment = 3.0;
  GyrostatState s = at_rest(2);
  s.body_momentum_B = Vec3(1.0, -0.7, 4.0);
  s.cone_momenta = {0.5, -0.9};
  const double energy = total_energy(g, l, s);
  for (const double t : {1.0, 5.0, 10.0})
    EXPECT_NEAR(total_energy(g, l, runge_kutta(g, l, s, t).state), energy, 1e-12) << t;
}

/// A spherical body feels no gyroscopic torque: Pi is the time integral of a body torque.
TEST(RungeKutta, harmonics_add_up_in_their_frames) {
  const dynamics::Gyrostat g = body({2, 2, 2});
  Loads l;
  l.harmonics = {{dynamics::TorqueFrame::body, Vec3(1, 2, 3), 5.0, 0.7}};
  GyrostatState end = runge_kutta(g, l, at_rest(), 3.0).state;
  const Vec3 expected = Vec3(1, 2, 3) * (std::sin(15.7) - std::sin(0.7)) / 5.0;
  EXPECT_LE((end.body_momentum_B - expected).norm(), 1e-13);
  l.harmonics[0].frame = dynamics::TorqueFrame::space;
  l.space_torque_W = Vec3(0.5, 0, 0);
  end = runge_kutta(body({2, 2.6, 3}), l, at_rest(), 3.0).state;
  EXPECT_LE((end.R_WB * end.body_momentum_B - expected - Vec3(1.5, 0, 0)).norm(), 1e-13);
}

/// A ramp, a drop and a constant: the momentum is the area, whatever the corners.
TEST(RungeKutta, samples_with_corners_add_up) {
  Loads l;
  l.samples = {{dynamics::TorqueFrame::space,
                {1.0, 2.0, 2.25},
                {Vec3(0, 0, 0), Vec3(2, 4, 6), Vec3(-1, 0, 1)}}};
  const GyrostatState end = runge_kutta(body({2, 2.6, 3}), l, at_rest(), 4.0).state;
  const Vec3 area = Vec3(1, 2, 3) + 0.125 * Vec3(1, 4, 7) + 1.75 * Vec3(-1, 0, 1);
  EXPECT_LE((end.R_WB * end.body_momentum_B - area).norm(), 1e-13);
}

/// A body at rest lets the step grow; a pulse shorter than the step must not be stepped over.
TEST(RungeKutta, a_short_pulse_is_not_missed) {
  Loads l;
  l.samples = {{dynamics::TorqueFrame::space,
                {4.0, 4.0 + 0x1p-8, 4.0 + 0x1p-7},
                {Vec3(0, 0, 0), Vec3(0, 0, 256), Vec3(0, 0, 0)}}};
  const GyrostatState end = runge_kutta(body({2, 2.6, 3}), l, at_rest(), 8.0).state;
  EXPECT_NEAR(end.body_momentum_B.z(), 1.0, 1e-12);
}

/// One cone on the body's axis: internal torque leaves the whole's momentum, external changes it.
TEST(RungeKutta, internal_and_external_cone_torques_differ) {
  const dynamics::Gyrostat g = body({2, 2, 3}, {{Vec3::UnitZ(), 0.5}});
  Loads l;
  l.cones = {{0.3, 0.0, 0.0}};
  GyrostatState end = runge_kutta(g, l, at_rest(1), 2.0).state;
  EXPECT_NEAR(end.body_momentum_B.z(), 0.0, 1e-14);
  EXPECT_NEAR(end.cone_momenta[0], 0.6, 1e-14);
  EXPECT_NEAR(end.cone_angles[0], 0.5 * 4.0 * (0.3 / 0.5 + 0.3 / 2.5), 1e-13);
  l.cones = {{0.0, 0.3, 0.0}};
  end = runge_kutta(g, l, at_rest(1), 2.0).state;
  EXPECT_NEAR(end.body_momentum_B.z(), 0.6, 1e-14);
  EXPECT_NEAR(end.cone_momenta[0], 0.6, 1e-14);
  EXPECT_NEAR(angle_about_z(end), 0.0, 1e-13);
}

/// phi'' = -damping (1/Ic + 1/It) phi' on the body's axis; the whole's momentum stays.
TEST(RungeKutta, bearing_friction_brakes_the_cone_against_the_bit) {
  const dynamics::Gyrostat g = body({2, 2, 3}, {{Vec3::UnitZ(), 0.5}});
  Loads l;
  l.cones = {{0.0, 0.0, 0.2}};
  GyrostatState s = at_rest(1);
  const double spin = 4.0, rate = 0.2 * (1.0 / 0.5 + 1.0 / 2.5);
  s.cone_momenta[0] = 0.5 * spin;
  s.body_momentum_B.z() = 0.5 * spin;
  const GyrostatState end = runge_kutta(g, l, s, 2.0).state;
  EXPECT_NEAR(end.body_momentum_B.z(), 2.0, 1e-14);
  EXPECT_NEAR(end.cone_angles[0], spin / rate * (1.0 - std::exp(-rate * 2.0)), 1e-13);
}

TEST(RungeKutta, wider_tolerances_need_fewer_evaluations) {
  const battery::GoldenCase c = battery::read_golden_case("slow_top");
  const auto run = [&](OdeMethod method, double tolerance) {
    return runge_kutta(c.gyrostat, c.loads, matrix_state(c.initial), 10.0, method,
                       {tolerance, tolerance});
  };
  const RungeKuttaRun loose = run(OdeMethod::rk8pd, 1e-6), tight = run(OdeMethod::rk8pd, 1e-12);
  EXPECT_LT(2 * loose.evaluations, tight.evaluations);
  EXPECT_LT(2 * tight.evaluations, run(OdeMethod::rkf45, 1e-12).evaluations);
  const auto error = [&](const RungeKuttaRun& r) {
    return (r.state.R_WB - c.states.back().R_WB).norm();
  };
  EXPECT_LT(1e3 * error(tight), error(loose));
}

const std::map<std::string, ComparisonMethod> rivals{{"rk8pd", ComparisonMethod::rk8pd},
                                                     {"rkf45", ComparisonMethod::rkf45},
                                                     {"rk4", ComparisonMethod::rk4}};

std::vector<WorkPrecision> on_the_slow_top(ComparisonMethod rival,
                                           const std::vector<double>& accuracies) {
  const battery::GoldenCase c = battery::read_golden_case("slow_top");
  return work_precision(c.gyrostat, c.loads, matrix_state(c.initial), 10.0, rival, accuracies);
}

std::vector<double> ladder(ComparisonMethod rival) {
  if (rival == ComparisonMethod::rk4) return {200, 400, 800, 1600, 3200, 6400, 12800, 25600};
  return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13};
}

TEST(WorkPrecision, the_rivals_on_the_slow_top) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& [name, rival] : rivals)
    for (const WorkPrecision& p : on_the_slow_top(rival, ladder(rival))) {
      EXPECT_GT(p.evaluations, 0);
      rows.push_back({{"method", name},
                      {"accuracy", p.accuracy},
                      {"torque_evaluations", p.evaluations},
                      {"attitude_error_rad", p.attitude_error}});
    }
  battery::record_table("work-precision-rivals", rows);
}

/// The error is the angle to the golden attitude, too.
TEST(WorkPrecision, errors_are_true_errors) {
  const battery::GoldenCase c = battery::read_golden_case("slow_top");
  for (const auto& [name, rival] : rivals)
    for (const WorkPrecision& p : on_the_slow_top(rival, ladder(rival)))
      EXPECT_NEAR(p.attitude_error, angle_between(p.end.R_WB, c.states.back().R_WB), 1e-12) << name;
}

TEST(WorkPrecision, rk4_converges_with_order_4_at_4_evaluations_a_step) {
  const auto points = on_the_slow_top(ComparisonMethod::rk4, {3200, 6400});
  EXPECT_EQ(points[0].evaluations, 4 * 3200);
  EXPECT_NEAR(std::log2(points[0].attitude_error / points[1].attitude_error), 4.0, 0.1);
}

TEST(WorkPrecision, angle_between_attitudes) {
  const auto turned = [](double angle) {
    return Mat3(Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()));
  };
  EXPECT_NEAR(angle_between(turned(0.3), turned(0.3 + 1e-9)), 1e-9, 1e-15);
  EXPECT_NEAR(angle_between(turned(0.3), turned(2.8)), 2.5, 1e-14);
}

TEST(WorkPrecision, rejects_what_it_cannot_run) {
  EXPECT_THROW(on_the_slow_top(ComparisonMethod::rk4, {0.5}), InputError);
  EXPECT_THROW(on_the_slow_top(ComparisonMethod::rk4, {-2.0}), InputError);
  EXPECT_THROW(on_the_slow_top(ComparisonMethod::rk4, {1e9}), InputError);
  EXPECT_THROW(on_the_slow_top(ComparisonMethod::rkf45, {0.0}), InputError);
  EXPECT_THROW(on_the_slow_top(ComparisonMethod::rk8pd, {std::nan("")}), InputError);
  dynamics::Loads sampled;
  sampled.samples.resize(1);
  EXPECT_THROW(work_precision({}, sampled, {}, 1.0, ComparisonMethod::rk4, {10.0}), InputError);
}

}  // namespace tdbd::reference::runge_kutta_test
