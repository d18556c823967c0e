#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "core/pose.hpp"

namespace tdbd::simulation {

/// Motion of the bit in a step, from pose 0 to pose 1 relative to the rock.
struct Move {
  Pose X_WB0, X_WB1;
  double dt = 0.0;             ///< s
  double turn = 0.0;           ///< rad about the axis of the bit
  std::size_t revolution = 0;  ///< revolution of the step, from 0
};

/// Velocity of the bit relative to the rock. Frame W.
struct BitVelocity {
  Vec3 p_WB = Vec3::Zero();         ///< m, origin of the bit
  Vec3 v_W = Vec3::Zero();          ///< m/s, velocity of that origin
  Vec3 w_W = Vec3::Zero();          ///< rad/s
  std::vector<double> cone_speeds;  ///< rad/s, phi' about the Z axes of the cones
};

/// Velocity at the end of the screw motion of the step, with these speeds of the cones.
BitVelocity velocity_of(const Move& move, std::vector<double> cone_speeds);

/// Velocity of the point x_W of the bit, m/s, which belongs to this cone (-1: to the body).
Vec3 velocity_at(const bit::Bit& bit, const Pose& X_WB, const BitVelocity& motion, int cone,
                 const Vec3& x_W);

}  // namespace tdbd::simulation
