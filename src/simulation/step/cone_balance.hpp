#pragma once

#include "dynamics/drilling/drilling_system.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::simulation {

/// Torque about a cone's Z of the laws' forces on its parts, N m, at this motion of the bit.
double cone_torque(const ForcePlan& plan, const bit::Bit& bit, int cone, const Pose& X_WB,
                   const BitVelocity& motion, double dt, const std::vector<CutOfPart>& cuts);

/// Spins phi' that the cones have at the end of a step, rad/s, simulation (5) (ours). A cone is
/// light and friction on its teeth stiff: an explicit impulse would throw its slip from one side to
/// the other in every step, 100 rad/s in a millisecond on bit R. So its own momentum takes the
/// whole impulse of the step at the spin that it leads to,
///   pi_k = pi_k* + h T_k(phi_k'),   pi_k = Ic_k (phi_k' + s_k . W)
/// (first order in this one variable; everything else keeps the step's order). T_k falls with
/// phi_k', so that the root is bracketed by phi* and phi* + h T_k(phi*)/Ic_k; it is found to a
/// relative 1e-12. `before`: the state before those impulses, which `motion` is the velocity of.
/// Throws RunError if a search does not end.
std::vector<double> balanced_spins(const ForcePlan& plan, const bit::Bit& bit,
                                   const dynamics::DrillingSystem& system,
                                   const dynamics::DrillingState& before, const Pose& X_WB,
                                   double dt, BitVelocity motion,
                                   const std::vector<CutOfPart>& cuts);

}  // namespace tdbd::simulation
