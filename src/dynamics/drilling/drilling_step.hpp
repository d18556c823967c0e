#pragma once

#include "dynamics/drilling/energy_ledger.hpp"
#include "dynamics/drilling/velocity.hpp"

namespace tdbd::dynamics {

/// A bit that drills: its state, what cutting did to it last, where its energy went. The momenta
/// stand at the time of the positions whenever no step is open.
struct Drilling {
  DrillingState state;
  Wrench wrench;        ///< of the last cut: opens the next step
  EnergyLedger ledger;  ///< since start_drilling
  /// Mean velocity over the opening and over the closing kick of the last step. A force F of the
  /// wrench at either end did the work (h/2) F . v there, exactly.
  DrillingVelocity opening, closing;
  Configuration at;  ///< of the state's positions

  // Room for what a step keeps meanwhile, so that it allocates nothing once warm.
  DrillingState predicted, step_start;
  DrillingVelocity before;
};

/// At rest with its energies. Give it the wrench of the start where the bit touches rock.
Drilling start_drilling(const DrillingSystem& system, DrillingState state);

/// Goes on from what was saved between two steps, to the same bits as without the interruption.
Drilling resume_drilling(const DrillingSystem& system, DrillingState state, Wrench wrench,
                         const EnergyLedger& ledger);

/// First half of a step of h (s): damping, the kick of the last wrench and of string, wall and
/// gravity, the drift. Positions and time are then those of the step's end: cut the rock there.
/// Throws RunError when a drift that solves is too long; the state is then that before the step.
void open_step(const DrillingSystem& system, double h, Drilling& d);

/// The state of the step's end with the momenta that the last wrench predicts: what a force law
/// that depends on velocity is evaluated at. Lives in d until the next step.
const DrillingState& predicted(const DrillingSystem& system, double h, Drilling& d);

/// Second half: the kick of the new wrench, damping, the ledger.
void close_step(const DrillingSystem& system, double h, const Wrench& wrench, Drilling& d);

}  // namespace tdbd::dynamics
