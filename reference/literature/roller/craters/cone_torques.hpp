#pragma once

#include <vector>

#include "reference/literature/roller/teeth/ma_azar.hpp"

namespace tdbd::reference {

/// Which speed determines a tooth's friction: that at the beginning of the step, as in recursions
/// that use the last forces, or that at its end, linear in the cone's own speed. The first is
/// unstable if friction in a step changes the cone's speed by more than the slip: dt > 2 Ic v/(mu F
/// rho2). Not in the thesis.
enum class SlipTime { beginning, end };

/// Friction of teeth and bearings. Reconstructed: without a force along the slip, nothing turns a
/// cone.
struct SlidingOptions {
  double friction = 0.3;       ///< mu of tooth and rock
  double slip_speed = 10e-3;   ///< m/s: below it friction decreases as v/sqrt(v2 + slip_speed2)
  double bearing = 0.0;        ///< N m, against the rotation of the cone
  double bearing_speed = 0.1;  ///< rad/s, below which it decreases in the same way
  SlipTime slip = SlipTime::end;
};

/// Loads of the rock on a bit, in the axes of space.
struct RollerLoads {
  Vec3 force = Vec3::Zero();  ///< N, on the bit
  double torque = 0.0;        ///< N m about +z, required from the drive
};

/// A cone's torque about its journal: pull - drag w at the cone speed w (rad/s).
struct ConeTorque {
  double pull = 0.0;  ///< N m, on the cone
  double drag = 0.0;  ///< N m s
};

/// Computes the forces of the teeth, summed over the bit and over every cone: the given vertical
/// forces (N, upwards on the bit) and friction against the horizontal slip. `teeth_W`: from
/// place_teeth with the bit at depth 0. `turn`: of the bit, rad. `cones`: one per cone of the bit.
RollerLoads teeth_loads(const RollerBit& bit, double turn, const std::vector<ToothState>& teeth_W,
                        const std::vector<double>& vertical, const std::vector<double>& cone_speeds,
                        const SlidingOptions& options, std::vector<ConeTorque>& cones);

/// The torque that accelerates a cone from its speed w through a step, N m.
double torque_of_step(const ConeTorque& torque, double speed, double inertia, double step,
                      const SlidingOptions& options);

}  // namespace tdbd::reference
