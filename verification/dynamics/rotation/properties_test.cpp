#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/battery/rotation_checks.hpp"
#include "verification/battery/symplectic_defect.hpp"

/// What holds for every gyrostat: any inertia that a body can have, up to three cones about any
/// axes with any spin, any attitude and velocity, steps up to one radian of what turns fastest
/// (enough for the Lie drifts; the others take any step).
namespace tdbd::battery::properties_test {

using dynamics::Gyrostat;
using dynamics::RotationState;

constexpr double unit_quaternion = 1e-15;
constexpr double symplectic = 1e-12;   ///< scale: 1 + the largest momentum, inertia of order one
constexpr double same_motion = 1e-12;  ///< the same, after ten steps

double between(double lo, double hi) {
  return lo + (hi - lo) * 1e-6 * *rc::gen::inRange(0, 1'000'001);
}
Vec3 vector(double size) {
  const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
  return {x, y, z};
}
Vec3 direction() {
  const double z = between(-1.0, 1.0), angle = between(-3.2, 3.2), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}
Mat3 rotation_matrix() { return rotation::quaternion_exp<double>(vector(2.0)).toRotationMatrix(); }

/// Second moments of mass make every inertia that a body can have, a rod and a sheet nearly.
Mat3 body_inertia() {
  const Mat3 Q = rotation_matrix();
  const Vec3 moments(between(0.0, 2.0), between(0.05, 2.0), between(0.05, 2.0));
  const Mat3 second = Q * moments.asDiagonal() * Q.transpose();
  return second.trace() * Mat3::Identity() - second;
}

struct Scene {
  Gyrostat g;
  RotationState state;
  double step = 0.0;
};

/// A body, and cones that add at least what a disc adds.
Gyrostat random_gyrostat() {
  Mat3 I = body_inertia();
  std::vector<dynamics::Cone> cones(static_cast<std::size_t>(*rc::gen::inRange(0, 4)));
  for (dynamics::Cone& c : cones) {
    c = {direction(), between(0.01, 0.3)};
    const Mat3 along = c.axis_B * c.axis_B.transpose();
    I += c.axial_inertia * (along + between(0.5, 3.0) * (Mat3::Identity() - along));
  }
  return dynamics::make_gyrostat(0.5 * (I + I.transpose()), cones);
}

Scene random_scene() {
  Scene s;
  s.g = random_gyrostat();
  std::vector<double> spins, angles;
  for (std::size_t k = 0; k < s.g.cones.size(); ++k) {
    spins.push_back(between(-20.0, 20.0));
    angles.push_back(between(-6.0, 6.0));
  }
  const Vec3 w_B = vector(5.0);
  s.state = dynamics::make_state(s.g, rotation_matrix(), w_B, spins, angles);
  const double fastest =
      w_B.norm() + (s.state.momentum_W.norm() + dynamics::cone_momentum_sum(s.g, s.state).norm()) /
                       s.g.principal[0];
  s.step = between(0.01, 1.0) / (0.1 + fastest);
  return s;
}

double scale(const Scene& s) { return 1.0 + s.state.momentum_W.norm(); }

dynamics::Rotating carried(const RotationScheme& scheme, const Scene& s,
                           const dynamics::Loads& loads, int steps) {
  dynamics::Rotating r = dynamics::start(s.g, loads, s.state);
  for (int i = 0; i < steps; ++i) scheme.step(s.g, loads, s.step, r);
  return r;
}

dynamics::Loads gravity() {
  dynamics::Loads loads;
  loads.gravity_moment = between(-5.0, 5.0);
  loads.gravity_arm_B = direction();
  return loads;
}

RC_GTEST_PROP(EveryGyrostat, keeps_its_momenta_bitwise_when_free, ()) {
  const Scene s = random_scene();
  for (const RotationScheme& scheme : second_order_schemes()) {
    const dynamics::Rotating r = carried(scheme, s, {}, 20);
    RC_ASSERT(r.state.momentum_W == s.state.momentum_W);
    RC_ASSERT(r.state.cone_momenta == s.state.cone_momenta);
    RC_ASSERT(std::abs(r.state.q_WB.squaredNorm() - 1.0) <= unit_quaternion);
  }
}

RC_GTEST_PROP(EveryGyrostat, keeps_its_vertical_momentum_bitwise_under_gravity, ()) {
  const Scene s = random_scene();
  const dynamics::Loads loads = gravity();
  for (const RotationScheme& scheme : second_order_schemes()) {
    const dynamics::Rotating r = carried(scheme, s, loads, 20);
    RC_ASSERT(r.state.momentum_W.z() == s.state.momentum_W.z());
    RC_ASSERT(r.state.cone_momenta == s.state.cone_momenta);
  }
}

RC_GTEST_PROP(EveryGyrostat, has_symplectic_steps_except_by_the_thesis_drift, ()) {
  const Scene s = random_scene();
  const dynamics::Loads loads = gravity();
  for (const RotationScheme& scheme : second_order_schemes()) {
    if (scheme.name.starts_with("lie-midpoint")) continue;
    const double defect = symplectic_defect(scheme, s.g, loads, s.state, s.step);
    RC_ASSERT(defect <= symplectic * scale(s) * scale(s));
  }
}

RC_GTEST_PROP(EveryGyrostat, comes_back_with_minus_h, ()) {
  Scene s = random_scene();
  const dynamics::Loads loads = gravity();
  for (const RotationScheme& scheme : second_order_schemes()) {
    dynamics::Rotating r = carried(scheme, s, loads, 10);
    for (int i = 0; i < 10; ++i) scheme.step(s.g, loads, -s.step, r);
    const StateErrors e = state_errors(r.state, s.state);
    RC_ASSERT(*std::max_element(e.begin(), e.end()) <= same_motion * scale(s));
  }
}

/// Nothing depends on how the bit's frame lies in the bit.
RC_GTEST_PROP(EveryGyrostat, has_the_same_motion_in_another_bit_frame, ()) {
  const Scene s = random_scene();
  const Mat3 R_BC = rotation_matrix();
  Scene other = s;
  std::vector<dynamics::Cone> cones = s.g.cones;
  for (dynamics::Cone& c : cones) c.axis_B = R_BC.transpose() * c.axis_B;
  const Mat3 I = R_BC.transpose() * s.g.inertia_B * R_BC;
  other.g = dynamics::make_gyrostat(0.5 * (I + I.transpose()), cones);
  other.state.q_WB = s.state.q_WB * Eigen::Quaterniond(R_BC);
  dynamics::Loads loads = gravity(), turned = loads;
  turned.gravity_arm_B = R_BC.transpose() * loads.gravity_arm_B;
  const Vec3& J = s.g.principal;
  const double apart = std::min(J[1] - J[0], J[2] - J[1]);
  RC_PRE(apart > 1e-3);  // nearly equal axes of inertia cannot be distinguished at rounding
  for (const RotationScheme& scheme : second_order_schemes()) {
    const dynamics::Rotating a = carried(scheme, s, loads, 10);
    dynamics::Rotating b = carried(scheme, other, turned, 10);
    b.state.q_WB = b.state.q_WB * Eigen::Quaterniond(R_BC.transpose());
    const StateErrors e = state_errors(a.state, b.state);
    RC_ASSERT(*std::max_element(e.begin(), e.end()) <= same_motion * scale(s) / apart);
  }
}

/// Without load nothing depends on how space is turned.
RC_GTEST_PROP(EveryGyrostat, has_the_same_motion_in_another_space_frame, ()) {
  const Scene s = random_scene();
  const Eigen::Quaterniond turn(rotation_matrix());
  Scene other = s;
  other.state.q_WB = turn * s.state.q_WB;
  other.state.momentum_W = turn * s.state.momentum_W;
  for (const RotationScheme& scheme : second_order_schemes()) {
    const dynamics::Rotating a = carried(scheme, s, {}, 10);
    dynamics::Rotating b = carried(scheme, other, {}, 10);
    b.state.q_WB = turn.conjugate() * b.state.q_WB;
    b.state.momentum_W = turn.conjugate() * b.state.momentum_W;
    const StateErrors e = state_errors(a.state, b.state);
    RC_ASSERT(*std::max_element(e.begin(), e.end()) <= same_motion * scale(s));
  }
}

}  // namespace tdbd::battery::properties_test
