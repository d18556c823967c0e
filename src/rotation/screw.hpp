#pragma once

#include "core/types.hpp"

namespace tdbd::rotation {

/// The skew-symmetric matrix of a: skew(a) b = a x b.
Mat3 skew(const Vec3& a);

/// Rotation by |v| (rad) about v (Rodrigues formula; series near zero). rotation (1); thesis: 5.1.
Mat3 exp(const Vec3& v);

/// Rotation vector of R with an angle in [0, pi], rad: rotation (2), computed by quaternion,
/// accurate near 0 and pi.
Vec3 log(const Mat3& R);

/// Velocity of a bit relative to the rock, in the bit's frame. If constant, it is a screw motion.
/// Steady drilling is angular_B = (0, 0, w), linear_B = (0, 0, v), with pitch v / w along the z
/// axis of the bit.
struct Twist {
  Vec3 angular_B = Vec3::Zero();  ///< rad/s
  Vec3 linear_B = Vec3::Zero();   ///< m/s, of the origin of the bit

  template <class Archive>
  void serialize(Archive& a) {
    a(angular_B, linear_B);
  }
};

/// Velocity of the bit's point x_B, m/s: linear + angular x x.
inline Vec3 velocity_B(const Twist& twist, const Vec3& x_B) {
  return twist.linear_B + twist.angular_B.cross(x_B);
}

/// Pose of the bit's frame after a time s (s) of this screw motion, relative to its current pose;
/// rotation (4): X = exp(s twist), R = exp(s skew(angular)), p = integral of exp(t skew(angular))
/// linear dt.
Pose carried(const Twist& twist, double s);

/// The screw motion from one pose to another in the time dt (s); rotation (5): X_WB1 = X_WB0
/// carried(twist, dt), exactly: angular dt = log(R_WB0' R_WB1), linear dt = J^-1 R_WB0' (p_WB1 -
/// p_WB0), J = integral of exp(t skew(angular dt)) dt from 0 to 1. For rotations below 3 rad.
Twist twist_from(const Pose& X_WB0, const Pose& X_WB1, double dt);

}  // namespace tdbd::rotation
