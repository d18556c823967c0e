#pragma once

#include "dynamics/drilling/configuration.hpp"

namespace tdbd::dynamics {

/// Stored energy at one instant, J.
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

/// Work and losses since the start, J. The losses of dampers and friction are the exact change of
/// kinetic energy, and so is the work of the cutting wrench: impulse times the mean of the
/// velocities before and after. The work of the top is its mean force times its displacement.
struct EnergyLedger {
  double start = 0.0;     ///< stored at the start
  double top = 0.0;       ///< work of the top on the string
  double gravity = 0.0;   ///< work of gravity
  double cut_bit = 0.0;   ///< work of the cutting wrench on the bit: negative while it drills
  double cut_rock = 0.0;  ///< work of the cutting wrench on the moving rock
  double damped_string = 0.0;
  double damped_bearings = 0.0;
  double damped_rock = 0.0;
  double wall_loss = 0.0;      ///< loss of the inelastic wall
  double wall_friction = 0.0;  ///< loss by friction along the wall
  // For a chained string (string::ChainLedger).
  double chain_gravity = 0.0;   ///< work of gravity on the chain
  double chain_friction = 0.0;  ///< loss by friction in the hole
  double chain_damping = 0.0;   ///< loss in the mud
  double chain_loss = 0.0;      ///< loss in the Kelvin-Voigt dampers
  double top_damping = 0.0;     ///< loss in the damper of a top drive

  template <class Archive>
  void serialize(Archive& a) {
    a(start, top, gravity, cut_bit, cut_rock, damped_string, damped_bearings, damped_rock,
      wall_loss, wall_friction, chain_gravity, chain_friction, chain_damping, chain_loss,
      top_damping);
  }
};

/// Sum of all losses, J.
double lost(const EnergyLedger& ledger);

/// Energy stored now plus losses, minus energy stored at the start and work done on the system, J:
/// dynamics (17). It would be zero if the step were exact. It results from the time integration of
/// springs, a moving top and rotation, is of second order and bounded.
double residual(const StoredEnergy& now, const EnergyLedger& ledger);

/// Sum of the magnitudes of the initial energy and of the work of the top, gravity and cutting, J.
/// It is the scale for rounding errors of the ledger.
double throughput(const EnergyLedger& ledger);

}  // namespace tdbd::dynamics
