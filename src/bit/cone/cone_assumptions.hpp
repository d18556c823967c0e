#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Quantifies, for a bit that rotates steadily about its axis, what the equations of motion neglect
/// about a cone. They assume that it is symmetric about its axis, with its centre of mass on it
/// (thesis 5.1).
struct ConeAssumptions {
  double cone_speed = 0.0;        ///< rad/s, relative to the bit
  double unbalance_force = 0.0;   ///< N, m e phi'^2
  double unbalance_share = 0.0;   ///< over the bit's weight
  double gravity_torque = 0.0;    ///< N m about the journal, upper bound: m g e
  double modulation_once = 0.0;   ///< amplitude at the cone's frequency, over the bit's axial
                                  ///< inertia
  double modulation_twice = 0.0;  ///< amplitude at twice the cone's frequency
  double frequency = 0.0;         ///< Hz, of the cone
  double torque_error = 0.0;      ///< N m, bound on what the cone's momentum equation neglects
  double torque_share = 0.0;      ///< torque_error over Ic phi'^2; 0 for a cone at rest
};

/// Computes the error of the assumptions about a cone that turns at cone_ratio times the bit's
/// speed (rad/s). The cone's share of the bit's axial inertia is constant except for amplitudes of
/// at most A1 and A2 at once and twice the cone's frequency, bit (11). From the kinetic energy
/// (W^2/2) I(phi) follows a torque that drives the cone and is neglected: (W^2/2) dI/dphi, at most
/// W^2 (A1/2 + A2), and the torque m g e of gravity, bit (12). First order in the asymmetry.
/// Bearing friction is not included because bearings are not modelled. Not in the thesis.
ConeAssumptions cone_assumptions(const Bit& bit, int cone, double bit_speed, double cone_ratio);

}  // namespace tdbd::bit
