#include "reference/dynamics/closed_forms.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace tdbd::reference {
namespace {

/// The rotation by |v| about v.
Mat3 turn(const Vec3& v) {
  const double angle = v.norm();
  return angle > 0.0 ? Mat3(Eigen::AngleAxisd(angle, v / angle)) : Mat3(Mat3::Identity());
}

Mat3 turn_z(double angle) { return Mat3(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

}  // namespace

Turning free_symmetric_body(const SymmetricBody& body, const Turning& start, double t) {
  const Vec3 momentum_B(body.transverse * start.w_B.x(), body.transverse * start.w_B.y(),
                        body.axial * start.w_B.z() + body.cone_momentum);
  const Vec3 momentum_W = start.R_WB * momentum_B;
  const double lambda = start.w_B.z() - momentum_B.z() / body.transverse;
  return {turn(t / body.transverse * momentum_W) * start.R_WB * turn_z(t * lambda),
          turn_z(-t * lambda) * start.w_B};
}

std::vector<double> steady_precession_rates(const SymmetricBody& top, double gravity_moment,
                                            double tilt, double axial_rate) {
  const double a = top.transverse * std::cos(tilt);
  const double axial_momentum = top.axial * axial_rate + top.cone_momentum;
  const double discriminant = axial_momentum * axial_momentum - 4.0 * a * gravity_moment;
  if (discriminant < 0.0) return {};
  // Avoids cancellation: the product of the roots is gravity_moment / a.
  const double q = 0.5 * (axial_momentum + std::copysign(std::sqrt(discriminant), axial_momentum));
  if (std::abs(a) < 1e-15 * top.transverse) return {gravity_moment / q};
  return {gravity_moment / q, q / a};
}

Turning steady_precession(double tilt, double axial_rate, double rate, double t) {
  const double spin = axial_rate - rate * std::cos(tilt);
  const Mat3 tilted = turn_z(rate * t) * Mat3(Eigen::AngleAxisd(tilt, Vec3::UnitX()));
  const Mat3 R_WB = tilted * turn_z(spin * t);
  return {R_WB, R_WB.transpose() * (rate * Vec3::UnitZ() + spin * tilted.col(2))};
}

AxialMotion constant_axial_torque(const AxialBody& body, const AxialMotion& start, double t) {
  const double acceleration = (body.torque - body.cone_torque) / body.inertia;
  const double cone_acceleration = body.cone_torque / body.cone_inertia - acceleration;
  return {start.angle + start.rate * t + 0.5 * acceleration * t * t, start.rate + acceleration * t,
          start.cone_angle + start.cone_rate * t + 0.5 * cone_acceleration * t * t,
          start.cone_rate + cone_acceleration * t};
}

}  // namespace tdbd::reference
