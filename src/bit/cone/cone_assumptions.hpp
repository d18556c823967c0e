#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// What the equations of motion leave out about a cone (formulation 4: symmetric about its axis,
/// its centre on it), as numbers at a steady turn of the bit about its axis.
struct ConeAssumptions {
  double cone_speed = 0.0;        ///< rad/s, against the bit
  double unbalance_force = 0.0;   ///< N, m e phi'^2
  double unbalance_share = 0.0;   ///< of the bit's weight
  double gravity_torque = 0.0;    ///< N m about the journal, at most: m g e
  double modulation_once = 0.0;   ///< amplitude at the cone's frequency, of the bit's axial inertia
  double modulation_twice = 0.0;  ///< amplitude at twice the cone's frequency
  double frequency = 0.0;         ///< Hz, of the cone
  double torque_error = 0.0;      ///< N m, bound of what the cone's momentum equation leaves out
  double torque_share = 0.0;      ///< torque_error over Ic phi'^2; 0 for a cone at rest
};

/// Of a cone that turns at cone_ratio times the bit's speed (rad/s). With a the angle between
/// journal and bit axis, e the centre's distance from the journal, J = hypot(Ixz, Iyz) of the
/// centre and c the journal's part of the centre, the cone's share of the bit's axial inertia is
/// constant but for at most
///   A1 = 2 J |sin a cos a| + 2 m e |c|,   A2 = (It1 - It2 + m e^2)/2 sin^2 a
/// at once and twice the cone's frequency; |c| is the length of c's horizontal part, projected
/// along the journal. From T = (w^2/2) I(phi) follows the torque that drives the cone and is
/// missing: (w^2/2) dI/dphi, at most w^2 (A1/2 + A2), and gravity's m g e (gravity_torque). First
/// order in the asymmetry. Bearings without friction are not judged: no bearing is drawn.
ConeAssumptions cone_assumptions(const Bit& bit, int cone, double bit_speed, double cone_ratio);

}  // namespace tdbd::bit
