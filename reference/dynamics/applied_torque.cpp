#include "reference/dynamics/applied_torque.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace tdbd::reference {
namespace {

/// Returns the torque in the frame of the bit; it may be given in either frame.
Vec3 in_bit_frame(dynamics::TorqueFrame frame, const Mat3& R_WB, const Vec3& torque) {
  return frame == dynamics::TorqueFrame::body ? torque : Vec3(R_WB.transpose() * torque);
}

/// dV/d(angle) for a rotation of the attitude by `angle` about a space axis. With a step of 0.02
/// rad, the remainder h^8/630 V'''''''''  and the rounding 1e-16/h are both below 1e-13.
double slope(const Vec3& stiffness_W, const Mat3& R_WB, double twist, const Vec3& axis_W) {
  constexpr double h = 0.02;
  constexpr double weights[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  double sum = 0.0;
  for (int i = 1; i <= 4; ++i) {
    const Mat3 forth = Eigen::AngleAxisd(i * h, axis_W) * R_WB;
    const Mat3 back = Eigen::AngleAxisd(-i * h, axis_W) * R_WB;
    sum += weights[i - 1] *
           (spring_energy(stiffness_W, forth, twist) - spring_energy(stiffness_W, back, twist));
  }
  return sum / h;
}

}  // namespace

SwingTwist swing_twist(const Mat3& R_WB, double about) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double wrapped = std::atan2(R_WB(1, 0) - R_WB(0, 1), R_WB(0, 0) + R_WB(1, 1));
  SwingTwist angles;
  angles.twist = wrapped + turn * std::round((about - wrapped) / turn);
  const Vec3 n_W = R_WB.col(2);
  const double sine = std::hypot(n_W.x(), n_W.y());
  if (sine == 0.0) return angles;
  const double angle = std::atan2(sine, n_W.z());
  angles.swing_x_W = -angle * n_W.y() / sine;
  angles.swing_y_W = angle * n_W.x() / sine;
  return angles;
}

double spring_energy(const Vec3& stiffness_W, const Mat3& R_WB, double twist) {
  const SwingTwist a = swing_twist(R_WB, twist);
  return 0.5 * (stiffness_W.x() * a.swing_x_W * a.swing_x_W +
                stiffness_W.y() * a.swing_y_W * a.swing_y_W + stiffness_W.z() * a.twist * a.twist);
}

Vec3 spring_torque(const Vec3& stiffness_W, const Mat3& R_WB, double twist) {
  if (stiffness_W.isZero(0.0)) return Vec3::Zero();
  return {-slope(stiffness_W, R_WB, twist, Vec3::UnitX()),
          -slope(stiffness_W, R_WB, twist, Vec3::UnitY()),
          -slope(stiffness_W, R_WB, twist, Vec3::UnitZ())};
}

Vec3 sampled_torque(const dynamics::SampledTorque& samples, double t) {
  if (samples.times.empty()) return Vec3::Zero();
  if (t <= samples.times.front()) return samples.torques.front();
  for (std::size_t i = 0; i + 1 < samples.times.size(); ++i) {
    const double left = samples.times[i], right = samples.times[i + 1];
    if (t <= right)
      return samples.torques[i] +
             (t - left) / (right - left) * (samples.torques[i + 1] - samples.torques[i]);
  }
  return samples.torques.back();
}

Vec3 applied_torque(const dynamics::Loads& loads, double t, const Mat3& R_WB, const Vec3& w_B,
                    double twist) {
  const Vec3 damping_W = -loads.damping_W.cwiseProduct(R_WB * w_B);
  const Vec3 spring_W = spring_torque(loads.stiffness_W, R_WB, twist);
  Vec3 torque_B =
      loads.body_torque_B + R_WB.transpose() * (loads.space_torque_W + damping_W + spring_W);
  // The force of V = m ez . r at the arm e is -m ez (bit frame: R^T ez); its moment is e x force.
  const Vec3 force_B = -loads.gravity_moment * R_WB.row(2).transpose();
  torque_B += loads.gravity_arm_B.cross(force_B);
  for (const dynamics::HarmonicTorque& h : loads.harmonics)
    torque_B +=
        in_bit_frame(h.frame, R_WB, h.amplitude * std::cos(h.angular_frequency * t + h.phase));
  for (const dynamics::SampledTorque& s : loads.samples)
    torque_B += in_bit_frame(s.frame, R_WB, sampled_torque(s, t));
  return torque_B;
}

}  // namespace tdbd::reference
