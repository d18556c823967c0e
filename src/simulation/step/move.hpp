#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "core/pose.hpp"

namespace tdbd::simulation {

/// What the bit did in a step: from pose 0 to pose 1 over the rock.
struct Move {
  Pose X_WB0, X_WB1;
  double dt = 0.0;             ///< s
  double turn = 0.0;           ///< rad about the bit's axis
  std::size_t revolution = 0;  ///< that the step is in, from 0
};

/// How the bit moves over the rock at an instant. Frame W.
struct BitVelocity {
  Vec3 p_WB = Vec3::Zero();         ///< m, the bit's origin
  Vec3 v_W = Vec3::Zero();          ///< m/s, of that origin
  Vec3 w_W = Vec3::Zero();          ///< rad/s
  std::vector<double> cone_speeds;  ///< rad/s, phi' about the cones' Z
};

/// Velocity at the end of the screw motion that makes the move, cones turning at these speeds.
BitVelocity velocity_of(const Move& move, std::vector<double> cone_speeds);

/// Velocity of the bit's point x_W, m/s, which turns with this cone (-1: with the body).
Vec3 velocity_at(const bit::Bit& bit, const Pose& X_WB, const BitVelocity& motion, int cone,
                 const Vec3& x_W);

}  // namespace tdbd::simulation
