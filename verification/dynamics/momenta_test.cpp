#include "dynamics/momenta.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "verification/battery/generators.hpp"

namespace tdbd::dynamics::momenta_test {

constexpr double rounding = 1e-12;  // momenta and energies here are below 1e3

/// A body with two or three cones that differ, and how all of it moves.
struct Motion {
  Gyrostat g;
  Mat3 R_WB;
  Vec3 w_B;
  std::vector<double> spins, angles;
};

Motion any_motion() {
  Motion m;
  Mat3 I = Vec3(3.0, 4.0, 5.0).asDiagonal();
  std::vector<Cone> cones(static_cast<std::size_t>(*battery::integer(2, 3)));
  for (Cone& c : cones) {
    c = {*battery::direction(), *battery::number(0.01, 0.3)};
    I += c.axial_inertia * Mat3::Identity();
    m.spins.push_back(*battery::number(-20.0, 20.0));
    m.angles.push_back(*battery::number(-6.0, 6.0));
  }
  m.g = make_gyrostat(I, cones);
  m.R_WB = Eigen::AngleAxisd(*battery::number(-3.0, 3.0), *battery::direction()).toRotationMatrix();
  m.w_B = *battery::point(5.0);
  return m;
}

RotationState state_of(const Motion& m) {
  return make_state(m.g, m.R_WB, m.w_B, m.spins, m.angles);
}

/// Everything turns with the bit, and each cone about its axis besides: dynamics (2) without It.
RC_GTEST_PROP(Momenta, are_those_of_locked_cones_and_of_their_spins, ()) {
  const Motion m = any_motion();
  const RotationState s = state_of(m);
  Vec3 momentum_B = m.g.inertia_B * m.w_B;
  for (std::size_t k = 0; k < m.g.cones.size(); ++k) {
    const Cone& c = m.g.cones[k];
    momentum_B += c.axial_inertia * m.spins[k] * c.axis_B;
    const double about_axis = c.axial_inertia * (m.spins[k] + c.axis_B.dot(m.w_B));
    RC_ASSERT(std::abs(s.cone_momenta[k] - about_axis) < rounding);
    RC_ASSERT(s.cone_angles[k] == m.angles[k]);
  }
  RC_ASSERT((s.momentum_W - m.R_WB * momentum_B).norm() < rounding);
  RC_ASSERT((body_momentum(s) - momentum_B).norm() < rounding);
}

RC_GTEST_PROP(Momenta, give_the_velocities_back, ()) {
  const Motion m = any_motion();
  const RotationState s = state_of(m);
  const Vec3 w_B = angular_velocity(m.g, s);
  RC_ASSERT((w_B - m.w_B).norm() < rounding);
  for (std::size_t k = 0; k < m.g.cones.size(); ++k)
    RC_ASSERT(std::abs(cone_rate(m.g.cones[k], s.cone_momenta[k], w_B) - m.spins[k]) < rounding);
}

/// Half of w I w, of Ic spin^2, and what couples them.
RC_GTEST_PROP(Momenta, have_the_energy_of_body_and_spins, ()) {
  const Motion m = any_motion();
  double energy = 0.5 * m.w_B.dot(m.g.inertia_B * m.w_B);
  for (std::size_t k = 0; k < m.g.cones.size(); ++k) {
    const Cone& c = m.g.cones[k];
    energy += c.axial_inertia * m.spins[k] * (0.5 * m.spins[k] + c.axis_B.dot(m.w_B));
  }
  RC_ASSERT(std::abs(kinetic_energy(m.g, state_of(m)) - energy) < rounding);
}

}  // namespace tdbd::dynamics::momenta_test
