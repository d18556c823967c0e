#pragma once

#include <functional>
#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// Where a bit that never tilts is: the place of its nose tip in the hole's frame (z down, the axis
/// of the hole at x = y = 0), and the angle by which it has turned about z, not reduced by turns.
struct BitPlace {
  Vec3 p_WB = Vec3::Zero();  ///< m
  double angle = 0.0;        ///< rad
};

/// A vector of the bit's frame in W.
Vec3 turned(const BitPlace& place, const Vec3& v_B);

/// On the straight way from one place to another; share: 0 to 1.
BitPlace between(const BitPlace& from, const BitPlace& to, double share);

/// A prescribed motion: the bit's place at a time, s.
using BitPath = std::function<BitPlace(double)>;

/// Turning about the hole's axis: rotary speed (rad/s), advance (m per revolution).
BitPath steady_path(double rotary_speed, double advance);

/// Backward whirl without slip: the bit's gage rolls on the wall of a hole that is larger by
/// `radius` all round. Derived; the sizes agree with hole diameter = d (1 + w/BWF) of US 8,640,791.
struct RollingWhirl {
  double bit_radius = 0.0;    ///< Rb, m
  double radius = 0.0;        ///< e = Rh - Rb, m, > 0
  double rotary_speed = 0.0;  ///< omega, rad/s

  double hole_radius() const { return bit_radius + radius; }                  ///< m
  double whirl_speed() const { return -rotary_speed * bit_radius / radius; }  ///< rad/s
  double lobes() const { return hole_radius() / radius; }                     ///< a turn
};

/// The centre goes round at whirl_speed; advance in m per revolution.
BitPath whirl_path(const RollingWhirl& whirl, double advance);

/// Velocity (m/s) of a point of the bit at radius r (m), with `delta` (rad) from it to the point of
/// contact: its share along the bit's own +azimuth, and its size.
double forward_speed(const RollingWhirl& whirl, double r, double delta);
double speed(const RollingWhirl& whirl, double r, double delta);

/// Share of time in which a point at radius r <= Rb moves backwards: arccos(r/Rb)/pi.
double backward_share(const RollingWhirl& whirl, double r);

/// Mean speed of a point at radius r, m/s.
double mean_speed(const RollingWhirl& whirl, double r);

}  // namespace tdbd::reference
