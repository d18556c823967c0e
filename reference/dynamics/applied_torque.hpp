#pragma once

#include "core/types.hpp"
#include "dynamics/loads.hpp"

namespace tdbd::reference {

/// The swing-twist angles of an attitude R = Swing Twist about space z, from the matrix alone. The
/// swing rotates ez to R ez along the shortest way; the twist is about ez. Undefined if R ez = -ez.
struct SwingTwist {
  double swing_x_W = 0.0, swing_y_W = 0.0;  ///< rad, the swing's rotation vector
  double twist = 0.0;                       ///< rad, unwrapped to the value nearest to `about`
};
SwingTwist swing_twist(const Mat3& R_WB, double about);

/// (x swing_x^2 + y swing_y^2 + z twist^2) / 2, J. `twist` includes full turns.
double spring_energy(const Vec3& stiffness_W, const Mat3& R_WB, double twist);

/// Minus the gradient of spring_energy over rotations in space, N m, by central differences of
/// order 8. It uses no formula of the torque and so is independent of the implementation under
/// test. Accurate to about 1e-13 of the energy unless the swing is close to pi.
Vec3 spring_torque(const Vec3& stiffness_W, const Mat3& R_WB, double twist);

/// Linear interpolation between the samples, constant outside them, N m.
Vec3 sampled_torque(const dynamics::SampledTorque& samples, double t);

/// All external torques on body and cones, except those that act on the cones alone, in the bit's
/// frame, N m. w_B: angular velocity, rad/s.
Vec3 applied_torque(const dynamics::Loads& loads, double t, const Mat3& R_WB, const Vec3& w_B,
                    double twist);

}  // namespace tdbd::reference
