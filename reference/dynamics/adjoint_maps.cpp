#include "reference/dynamics/adjoint_maps.hpp"

#include <Eigen/Geometry>
#include <stdexcept>

#include "reference/dynamics/applied_torque.hpp"

namespace tdbd::reference {
namespace {

Mat3 rotation_by(const Vec3& T) {
  const double angle = T.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, T / angle).toRotationMatrix()
                     : Mat3(Mat3::Identity());
}

void give_impulse(const dynamics::Loads& loads, const dynamics::Gyrostat& g, double h,
                  GyrostatState& s) {
  const Vec3 w_B = bit_angular_velocity(g, s);
  s.body_momentum_B += h * applied_torque(loads, s.time, s.R_WB, w_B, s.twist);
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    const dynamics::ConeLoad& load = loads.cones.at(k);
    s.body_momentum_B += h * load.external * g.cones[k].axis_B;
    s.cone_momenta[k] += h * (load.internal + load.external);
  }
}

/// h times the angular velocity for the momentum in the middle of the drift by T.
Vec3 turn_of_middle(const dynamics::Gyrostat& g, double h, const GyrostatState& s, const Vec3& T) {
  GyrostatState middle = s;
  middle.body_momentum_B = rotation_by(-0.5 * T) * s.body_momentum_B;
  return h * bit_angular_velocity(g, middle);
}

void drift(const dynamics::Gyrostat& g, double h, GyrostatState& s) {
  constexpr int most_rounds = 1000;
  constexpr double settled = 1e-16;  // relative to 1 rad
  Vec3 T = h * bit_angular_velocity(g, s);
  double change = 1.0;
  for (int i = 0; change > settled; ++i) {
    if (i == most_rounds) throw std::runtime_error("the drift does not settle");
    const Vec3 next = turn_of_middle(g, h, s, T);
    change = (next - T).norm();
    T = next;
  }
  s.R_WB = s.R_WB * rotation_by(T);
  s.body_momentum_B = rotation_by(-T) * s.body_momentum_B;
  for (std::size_t k = 0; k < g.cones.size(); ++k)
    s.cone_angles[k] += h * s.cone_momenta[k] / g.cones[k].axial_inertia - g.cones[k].axis_B.dot(T);
  s.twist = swing_twist(s.R_WB, s.twist).twist;
  s.time += h;
}

}  // namespace

GyrostatState impulse_first(const dynamics::Gyrostat& g, const dynamics::Loads& loads, double h,
                            const GyrostatState& s) {
  GyrostatState next = s;
  give_impulse(loads, g, h, next);
  drift(g, h, next);
  return next;
}

GyrostatState impulse_last(const dynamics::Gyrostat& g, const dynamics::Loads& loads, double h,
                           const GyrostatState& s) {
  GyrostatState next = s;
  drift(g, h, next);
  give_impulse(loads, g, h, next);
  return next;
}

}  // namespace tdbd::reference
