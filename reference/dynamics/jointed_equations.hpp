#pragma once

#include <Eigen/Geometry>

#include "reference/dynamics/jointed_bodies.hpp"

namespace tdbd::reference {

/// Motion of one body in space: thirteen unknowns.
struct BodyMotion {
  Vec3 x_W;                 ///< m, centre
  Eigen::Quaterniond q_WB;  ///< attitude; not kept normalized, so attitude() normalizes it
  Vec3 v_W;                 ///< m/s
  Vec3 w_W;                 ///< rad/s
};

/// All bodies, the bit's first, and the cones' angles, which only serve to count full turns.
struct Assembly {
  std::vector<BodyMotion> motions;
  std::vector<double> cone_angles;  ///< rad
};

/// The bit's body and its cones, as rigid bodies in the bit's frame at cone angles 0.
std::vector<RigidBody> bodies(const JointedBit& bit);

Mat3 attitude(const BodyMotion& m);

/// R I R^T, kg m2.
Mat3 space_inertia(const RigidBody& b, const BodyMotion& m);

std::vector<double> unknowns(const Assembly& a);
Assembly assembly_of(std::span<const double> y, std::size_t cones);

/// Newton-Euler equations for each body, with multipliers for bearings and pin:
///   M a - G^T lambda = f,   G a = gamma.
RightHandSide jointed_equations(const JointedBit& bit);

}  // namespace tdbd::reference
