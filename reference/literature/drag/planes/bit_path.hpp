#pragma once

#include <functional>
#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// The pose of a bit that never tilts: the position of its nose tip in the hole's frame (z down,
/// the axis of the hole at x = y = 0), and the angle by which it has turned about z, unwrapped.
struct BitPlace {
  Vec3 p_WB = Vec3::Zero();  ///< m
  double angle = 0.0;        ///< rad
};

/// Rotates a vector from the bit's frame to W.
Vec3 turned(const BitPlace& place, const Vec3& v_B);

/// Interpolates linearly from one place to another. share: in [0, 1].
BitPlace between(const BitPlace& from, const BitPlace& to, double share);

/// A prescribed motion: the bit's place at a time, s.
using BitPath = std::function<BitPlace(double)>;

/// Rotation about the hole's axis: rotary speed (rad/s), advance (m per revolution).
BitPath steady_path(double rotary_speed, double advance);

/// Backward whirl without slip: the bit's gage rolls on the wall of a hole whose radius is larger
/// by `radius`. Derived; the sizes agree with hole diameter = d (1 + w/BWF) of US 8,640,791.
struct RollingWhirl {
  double bit_radius = 0.0;    ///< Rb, m
  double radius = 0.0;        ///< e = Rh - Rb, m, > 0
  double rotary_speed = 0.0;  ///< omega, rad/s

  double hole_radius() const { return bit_radius + radius; }                  ///< m
  double whirl_speed() const { return -rotary_speed * bit_radius / radius; }  ///< rad/s
  double lobes() const { return hole_radius() / radius; }                     ///< per turn
};

/// The centre moves around at whirl_speed. Advance in m per revolution.
BitPath whirl_path(const RollingWhirl& whirl, double advance);

/// Velocity (m/s) of a point of the bit at radius r (m), at the angle `delta` (rad) before the
/// point of contact: its component along the bit's own +azimuth, and its magnitude.
double forward_speed(const RollingWhirl& whirl, double r, double delta);
double speed(const RollingWhirl& whirl, double r, double delta);

/// Fraction of time in which a point at radius r <= Rb moves backwards: arccos(r/Rb)/pi.
double backward_share(const RollingWhirl& whirl, double r);

/// Mean speed of a point at radius r, m/s.
double mean_speed(const RollingWhirl& whirl, double r);

}  // namespace tdbd::reference
