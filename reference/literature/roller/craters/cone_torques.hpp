#pragma once

#include <vector>

#include "reference/literature/roller/teeth/ma_azar.hpp"

namespace tdbd::reference {

/// When the speed in a tooth's friction is known: at the step's beginning, as recursions that take the last
/// forces have it, or at its end, linear in the cone's own speed. The first is unstable when a step of
/// friction turns the cone more than slip does: dt > 2 Ic v/(mu F rho2). Ours.
enum class SlipTime { beginning, end };

/// Friction of teeth, and of bearings. Reconstructed: without a force along the slip nothing turns a cone.
struct SlidingOptions {
  double friction = 0.3;       ///< mu of tooth and rock
  double slip_speed = 10e-3;   ///< m/s: below it the friction fades as v/sqrt(v2 + slip_speed2)
  double bearing = 0.0;        ///< N m, against the cone's turning
  double bearing_speed = 0.1;  ///< rad/s, below which it fades likewise
  SlipTime slip = SlipTime::end;
};

/// What the rock does to a bit, along the axes of space.
struct RollerLoads {
  Vec3 force = Vec3::Zero();  ///< N, on the bit
  double torque = 0.0;        ///< N m, that turns the bit against it, about +z
};

/// A cone's torque about its journal: pull - drag w at the cone speed w (rad/s).
struct ConeTorque {
  double pull = 0.0;  ///< N m, on the cone
  double drag = 0.0;  ///< N m s
};

/// Forces of the teeth, vertical ones (N, upwards on the bit) and what friction adds against their
/// horizontal slip, summed over the bit and over every cone. `teeth_W` is of place_teeth with the bit at
/// depth 0; `turn`: of the bit, rad. `cones`: as many as the bit has.
RollerLoads teeth_loads(const RollerBit& bit, double turn, const std::vector<ToothState>& teeth_W,
                        const std::vector<double>& vertical, const std::vector<double>& cone_speeds,
                        const SlidingOptions& options, std::vector<ConeTorque>& cones);

/// The torque that moves a cone from its speed w through a step, N m.
double torque_of_step(const ConeTorque& torque, double speed, double inertia, double step,
                      const SlidingOptions& options);

}  // namespace tdbd::reference
