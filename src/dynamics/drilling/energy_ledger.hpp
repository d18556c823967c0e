#pragma once

#include "dynamics/drilling/configuration.hpp"

namespace tdbd::dynamics {

/// What is stored at one instant, J.
struct StoredEnergy {
  double translation = 0.0;  ///< M |c'|^2 / 2
  double rotation = 0.0;     ///< W . It W / 2
  double cones = 0.0;        ///< sum_k pi_k^2 / (2 Ic_k): the cones about their axes, in space
  double rock = 0.0;         ///< kinetic
  double string = 0.0;       ///< elastic
  double wall = 0.0;
  double rock_mount = 0.0;
  double chain = 0.0;  ///< of a chained string, without the springs at the bit
};
StoredEnergy stored_energy(const DrillingSystem& system, const Configuration& at,
                           const DrillingState& state);
double total(const StoredEnergy& e);

/// Where energy went since the start, J. What is taken by dampers and frictions is the exact change
/// of kinetic energy, as is the work of the cutting wrench: impulse times the mean of the
/// velocities before and after. The work of the top is its mean force times its way.
struct EnergyLedger {
  double start = 0.0;     ///< stored at the start
  double top = 0.0;       ///< done by the top on the string
  double gravity = 0.0;   ///< done by gravity
  double cut_bit = 0.0;   ///< done by the cutting wrench on the bit: negative while it drills
  double cut_rock = 0.0;  ///< and on the rock's motion
  double damped_string = 0.0;
  double damped_bearings = 0.0;
  double damped_rock = 0.0;
  double wall_loss = 0.0;      ///< what the wall does not give back
  double wall_friction = 0.0;  ///< turned to heat along it
  // Of a chained string (string::ChainLedger).
  double chain_gravity = 0.0;   ///< done by gravity on it
  double chain_friction = 0.0;  ///< taken by friction in the hole
  double chain_damping = 0.0;   ///< by the mud
  double chain_loss = 0.0;      ///< by Kelvin-Voigt's dampers
  double top_damping = 0.0;     ///< by the damper of a top drive
};

/// Taken by all that resists, J.
double lost(const EnergyLedger& ledger);

/// Stored now and lost less stored at the start and put in, J: dynamics (17); zero if the step
/// were exact. What is left comes from how springs, a moving top and rotation are stepped: it is of
/// second order and bounded.
double residual(const StoredEnergy& now, const EnergyLedger& ledger);

/// What there was to begin with and what went in and out at the top, by gravity and at the cut, each
/// by its size, J: the scale of the rounding in a ledger.
double throughput(const EnergyLedger& ledger);

}  // namespace tdbd::dynamics
