#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "battery/generators.hpp"
#include "dynamics/momenta.hpp"
#include "dynamics/rotation/step.hpp"
#include "reference/dynamics/applied_torque.hpp"
#include "reference/dynamics/runge_kutta.hpp"

/// The program's torques against the twin's, loads of every kind at once.
namespace tdbd::reference::program_torque_test {

using dynamics::TorqueFrame;

/// The twin differences the potential: good to 1e-12 of the largest energy.
constexpr double torque_agreement = 1e-12;  // of 1 + energies and torques
constexpr double energy_agreement = 1e-12;  // of 1 + energies

rc::Gen<Vec3> not_negative(double largest) {
  return rc::gen::apply([](double x, double y, double z) { return Vec3(x, y, z); },
                        battery::number(0.0, largest), battery::number(0.0, largest),
                        battery::number(0.0, largest));
}

dynamics::Loads any_loads(std::size_t cones) {
  dynamics::Loads l;
  l.body_torque_B = *battery::point(2.0);
  l.space_torque_W = *battery::point(2.0);
  l.gravity_moment = *battery::number(-5.0, 5.0);
  l.gravity_arm_B = *battery::direction();
  for (const TorqueFrame frame : {TorqueFrame::body, TorqueFrame::space}) {
    l.harmonics.push_back(
        {frame, *battery::point(2.0), *battery::number(0.0, 9.0), *battery::number(-3.0, 3.0)});
    l.samples.push_back({frame,
                         {0.1, 0.4, 0.5},
                         {*battery::point(2.0), *battery::point(2.0), *battery::point(2.0)}});
  }
  l.stiffness_W = *not_negative(4.0);
  l.damping_W = *not_negative(1.0);
  for (std::size_t k = 0; k < cones; ++k)
    l.cones.push_back(
        {*battery::number(-0.5, 0.5), *battery::number(-0.5, 0.5), *battery::number(0.0, 0.1)});
  return l;
}

dynamics::Gyrostat some_bit() {
  return dynamics::make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(),
                                 {{Vec3(0.8, 0, 0.6), 0.1}, {Vec3(-0.6, 0.5, 0.6), 0.2}});
}

/// Away from half a turn of swing, where no angle is defined.
dynamics::RotationState any_state(const dynamics::Gyrostat& g) {
  const double z = *battery::number(-3.0, 3.0);
  const Vec3 swing(*battery::number(-1.4, 1.4), *battery::number(-1.4, 1.4), 0.0);
  const Mat3 R_WB = Eigen::AngleAxisd(swing.norm(), swing.normalized()).toRotationMatrix() *
                    Eigen::AngleAxisd(z, Vec3::UnitZ()).toRotationMatrix();
  const std::vector<double> spins{*battery::number(-9.0, 9.0), *battery::number(-9.0, 9.0)};
  auto s = dynamics::make_state(g, R_WB, *battery::point(4.0), spins, std::vector<double>(2, 0.0));
  s.turns = *battery::integer(-2, 2);
  s.time = *battery::number(0.0, 1.0);
  return s;
}

RC_GTEST_PROP(ProgramTorque, is_the_twins, ()) {
  const dynamics::Gyrostat g = some_bit();
  const dynamics::Loads loads = any_loads(g.cones.size());
  const dynamics::RotationState s = any_state(g);
  const GyrostatState twin = matrix_state(s);
  const double potential = total_energy(g, loads, twin) - total_energy(g, {}, twin);
  const double scale =
      1.0 + std::abs(potential) + spring_energy(loads.stiffness_W, twin.R_WB, twin.twist);
  dynamics::Torque t;
  dynamics::evaluate(g, loads, s, t);
  const Vec3 w_B = bit_angular_velocity(g, twin);
  Vec3 total_B = applied_torque(loads, s.time, twin.R_WB, w_B, twin.twist);
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    const dynamics::ConeLoad& load = loads.cones[k];
    const Vec3& axis_B = g.cones[k].axis_B;
    const double spin = s.cone_momenta[k] / g.cones[k].axial_inertia - axis_B.dot(w_B);
    total_B += load.external * axis_B;
    RC_ASSERT(std::abs(t.cones[k] - (load.internal + load.external - load.damping * spin)) <
              energy_agreement * scale);
  }
  RC_ASSERT((t.total_W - twin.R_WB * total_B).norm() < torque_agreement * scale);
  RC_ASSERT(std::abs(dynamics::potential_energy(loads, s) - potential) < energy_agreement * scale);
}

/// A whole motion that does not swing near half a turn, where the twist's rate is singular and the
/// twin's error grows without bound, under loads of every kind but samples, whose corners no high
/// order likes: the eighth-order composition at a step at which its own error is below rounding's.
RC_GTEST_PROP(ProgramTorque, moves_the_bit_as_the_twin_does, ()) {
  constexpr double h = 1.0 / 256.0, agreement = 1.5e-11;  // of 1 + momentum, angles in rad
  const dynamics::Gyrostat g = some_bit();
  dynamics::Loads loads = any_loads(g.cones.size());
  loads.samples.clear();
  dynamics::RotationState s = any_state(g);
  s.time = 0.0;
  const GyrostatState expected = runge_kutta(g, loads, matrix_state(s), 0.25).state;
  const dynamics::Integrator integrator{dynamics::Drift::split, 1, 8,
                                        dynamics::VelocityTorque::symmetric};
  dynamics::Rotating r = dynamics::start(g, loads, s);
  double lowest = 1.0;  // cosine of the swing
  for (int i = 0; i < 64; ++i) {
    dynamics::step(g, loads, integrator, h, r);
    lowest = std::min(lowest, matrix_state(r.state).R_WB(2, 2));
  }
  RC_PRE(lowest > -0.8);
  const GyrostatState end = matrix_state(r.state);
  double difference =
      (end.R_WB - expected.R_WB).norm() + (end.body_momentum_B - expected.body_momentum_B).norm();
  for (std::size_t k = 0; k < g.cones.size(); ++k)
    difference += std::abs(end.cone_angles[k] - expected.cone_angles[k]) +
                  std::abs(end.cone_momenta[k] - expected.cone_momenta[k]);
  RC_ASSERT(difference < agreement * (1.0 + expected.body_momentum_B.norm()));
}

}  // namespace tdbd::reference::program_torque_test
