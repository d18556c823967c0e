#pragma once

#include <vector>

#include "string/chain.hpp"

namespace tdbd::string {

/// What the rock does to a bit that has no shape.
enum class BitLaw {
  none,          ///< off bottom
  fixed,         ///< it cannot move
  two_level,     ///< Coulomb friction about the axis
  regenerative,  ///< cuts what the blade ahead has left, with friction below its wear flats
  load           ///< constant weight and torque
};

/// A bit at the end of a chain, for runs without rock. Mass, inertia and weight are those of the
/// chain's last cell and of the bit together.
struct SimpleBit {
  BitLaw law = BitLaw::none;
  Directions directions = Directions::both;           ///< of the chain
  double mass = 0.0;                                  ///< kg
  double inertia = 0.0;                               ///< kg m2
  double gravity_force = 0.0;                         ///< along the hole, N
  double axial_damping = 0.0;                         ///< to rest, N s/m
  double torsional_damping = 0.0;                     ///< to rest, N m s/rad
  double weight = 0.0;                                ///< constant part of the weight on bit, N
  double torque = 0.0;                                ///< constant part of the torque on bit, N m
  double resting_torque = 0.0, sliding_torque = 0.0;  ///< two_level, N m
  double force_per_depth = 0.0;                       ///< regenerative: of a cut of all blades, N/m
  double torque_per_depth = 0.0;                      ///< N
  double contact_force = 0.0;  ///< that wear flats bear where the bit advances, N
  double contact_lever = 0.0;  ///< torque over that force, m
  double pitch = 0.0;          ///< angle between blades, rad
};

/// Where energy went at the bit, J.
struct BitLedger {
  double gravity = 0.0;   ///< done by the weight
  double cut = 0.0;       ///< taken by cutting and constant loads
  double friction = 0.0;  ///< taken by contact
  double damping = 0.0;
  double loss = 0.0;  ///< taken by the last element's Kelvin-Voigt damper at the bit
};

/// What a restart needs of the bit.
struct BitState {
  double displacement = 0.0, velocity = 0.0, angle = 0.0, rotary_speed = 0.0;
  double depth = 0.0;    ///< of cut per blade, m
  double contact = 0.0;  ///< mean share of contact_force in the last flow
  std::vector<double> past_angle, past_displacement;  ///< what the blade cut, by angle, rad, m
  long oldest = 0;  ///< index of the last point that the next blade has passed
  BitLedger ledger;
};

/// A bit of this mass (kg), inertia (kg m2) and weight along the hole (N) off bottom at the end of a
/// chain, with the half element beside it.
SimpleBit bit_below(const Chain& chain, double mass, double inertia, double weight);

/// Makes the past of a bit that has cut `depth` (m) per blade.
void start_cut(const SimpleBit& bit, double depth, BitState& state);

/// Flow over a time under the last element's load; `damper`: the part of it that Kelvin-Voigt's
/// dampers have. `set_speed`: of the top, for Directions::axial.
void flow_bit(const SimpleBit& bit, double time, const EndLoad& load, const EndLoad& damper,
              double set_speed, BitState& state);

/// The bit's drift, and the depth of cut where that leads.
void drift_bit(const SimpleBit& bit, double h, BitState& state);

inline EndMotion motion_of(const BitState& s) {
  return {s.displacement, s.angle, s.velocity, s.rotary_speed};
}

/// Weight (N) and torque (N m) on bit now; of a bit that stands, what holds the last element's load.
EndLoad bit_load(const SimpleBit& bit, const BitState& state, const EndLoad& string);

/// Kinetic energy, J.
double stored_energy(const SimpleBit& bit, const BitState& state);

/// A chain with its bit.
struct BitOnChain {
  ChainState chain;
  BitState bit;
};

/// One step of both: string (9).
void step_bit_on_chain(const Chain& chain, const SimpleBit& bit, double h,
                       const TopCommand& command, BitOnChain& state, ChainWork& work);

/// Stored and lost less put in, J; constant if the step were exact.
double energy_balance(const Chain& chain, const SimpleBit& bit, const BitOnChain& state);

}  // namespace tdbd::string
