#pragma once

#include "core/types.hpp"
#include "dynamics/loads.hpp"

namespace tdbd::reference {

/// The swing-twist angles of an attitude R = Swing Twist about space z, from the
/// matrix alone: the swing takes ez to R ez the shortest way, the twist is about ez. Undefined
/// where R ez = -ez.
struct SwingTwist {
  double swing_x_W = 0.0, swing_y_W = 0.0;  ///< rad, the swing's rotation vector
  double twist = 0.0;                       ///< rad, of the turns the one nearest to `about`
};
SwingTwist swing_twist(const Mat3& R_WB, double about);

/// (x swing_x^2 + y swing_y^2 + z twist^2) / 2, J. `twist` carries the winding.
double spring_energy(const Vec3& stiffness_W, const Mat3& R_WB, double twist);

/// Minus the gradient of spring_energy over rotations in space, N m, by central differences of
/// order 8: no formula of the torque, so none to share with anybody. Good to about 1e-13 of the
/// energy unless the swing comes near pi.
Vec3 spring_torque(const Vec3& stiffness_W, const Mat3& R_WB, double twist);

/// Linear between the samples, held outside, N m.
Vec3 sampled_torque(const dynamics::SampledTorque& samples, double t);

/// Everything from outside that acts on body and cones except what acts on the cones alone, in the
/// bit's frame, N m. w_B: angular velocity, rad/s.
Vec3 applied_torque(const dynamics::Loads& loads, double t, const Mat3& R_WB, const Vec3& w_B,
                    double twist);

}  // namespace tdbd::reference
