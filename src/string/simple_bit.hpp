#pragma once

#include <vector>

#include "string/chain.hpp"

namespace tdbd::string {

/// Interaction of the rock with a bit that has no geometry.
enum class BitLaw {
  none,          ///< off bottom
  fixed,         ///< cannot move
  two_level,     ///< Coulomb friction about the axis
  regenerative,  ///< cuts what the preceding blade has left, with friction at its wear flats
  load           ///< constant weight and torque
};

/// A bit at the end of a chain, for runs without rock. Mass, inertia and weight include the last
/// cell of the chain.
struct SimpleBit {
  BitLaw law = BitLaw::none;
  Directions directions = Directions::both;           ///< of the chain
  double mass = 0.0;                                  ///< kg
  double inertia = 0.0;                               ///< kg m2
  double gravity_force = 0.0;                         ///< along the hole, N
  double axial_damping = 0.0;                         ///< relative to a fixed point, N s/m
  double torsional_damping = 0.0;                     ///< relative to a fixed point, N m s/rad
  double weight = 0.0;                                ///< constant part of the weight on bit, N
  double torque = 0.0;                                ///< constant part of the torque on bit, N m
  double resting_torque = 0.0, sliding_torque = 0.0;  ///< two_level, N m
  double force_per_depth = 0.0;                       ///< regenerative: per depth of cut, all
                                                      ///< blades together, N/m
  double torque_per_depth = 0.0;                      ///< N
  double contact_force = 0.0;  ///< on the wear flats while the bit advances, N
  double contact_lever = 0.0;  ///< ratio of torque to that force, m
  double pitch = 0.0;          ///< angle between blades, rad
};

/// Work and losses at the bit, J.
struct BitLedger {
  double gravity = 0.0;   ///< work of the weight
  double cut = 0.0;       ///< loss by cutting and constant loads
  double friction = 0.0;  ///< loss by contact
  double damping = 0.0;
  double loss = 0.0;  ///< loss in the Kelvin-Voigt damper of the last element, at the bit
};

/// State of the bit, sufficient for a restart.
struct BitState {
  double displacement = 0.0, velocity = 0.0, angle = 0.0, rotary_speed = 0.0;
  double depth = 0.0;    ///< depth of cut per blade, m
  double contact = 0.0;  ///< mean share of contact_force in the last flow
  std::vector<double> past_angle, past_displacement;  ///< surface cut, by angle, rad, m
  long oldest = 0;  ///< index of the last point that the next blade has passed
  BitLedger ledger;
};

/// Creates a bit with this mass (kg), inertia (kg m2) and weight along the hole (N), off bottom at
/// the end of a chain. Half of the last element is included.
SimpleBit bit_below(const Chain& chain, double mass, double inertia, double weight);

/// Sets the cutting history of a bit that has cut `depth` (m) per blade.
void start_cut(const SimpleBit& bit, double depth, BitState& state);

/// Flow over `time` under the load of the last element. `damper` is the part of the load from
/// Kelvin-Voigt dampers. `set_speed` is that of the top, for Directions::axial.
void flow_bit(const SimpleBit& bit, double time, const EndLoad& load, const EndLoad& damper,
              double set_speed, BitState& state);

/// Drifts the bit and updates the depth of cut.
void drift_bit(const SimpleBit& bit, double h, BitState& state);

inline EndMotion motion_of(const BitState& s) {
  return {s.displacement, s.angle, s.velocity, s.rotary_speed};
}

/// Current weight (N) and torque (N m) on bit. For a fixed bit these are the reactions to the load
/// of the last element.
EndLoad bit_load(const SimpleBit& bit, const BitState& state, const EndLoad& string);

/// Kinetic energy, J.
double stored_energy(const SimpleBit& bit, const BitState& state);

/// A chain with its bit.
struct BitOnChain {
  ChainState chain;
  BitState bit;
};

/// One step of chain and bit: string (9).
void step_bit_on_chain(const Chain& chain, const SimpleBit& bit, double h,
                       const TopCommand& command, BitOnChain& state, ChainWork& work);

/// Stored energy plus losses minus work done on the system, J; constant if the step were exact.
double energy_balance(const Chain& chain, const SimpleBit& bit, const BitOnChain& state);

}  // namespace tdbd::string
