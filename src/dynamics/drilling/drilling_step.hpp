#pragma once

#include "dynamics/drilling/energy_ledger.hpp"
#include "dynamics/drilling/middle_split.hpp"
#include "dynamics/drilling/velocity.hpp"

namespace tdbd::dynamics {

/// A bit that drills, as a restart needs it. The momenta stand at the time of the positions
/// whenever no step is open.
struct Drilling {
  DrillingState state;
  Wrench wrench;             ///< of the last cut: opens the next step
  EnergyLedger ledger;       ///< since start_drilling
  string::ChainState chain;  ///< of a string on a chain
};

/// What a step keeps beside it, so that it allocates nothing once warm.
struct DrillingWork {
  Configuration at;  ///< of the state's positions, when no step is open
  /// Mean velocity over the opening and over the closing flow of the last step. A force F of the
  /// wrench at either end did the work (h/2) F . v there, exactly.
  DrillingVelocity opening, closing;
  DrillingState predicted, step_start;
  DrillingVelocity before;
  Configuration middle;       ///< in the middle of the last drift, as its opening half predicted it
  Configuration next_middle;  ///< and of the drift that velocity_after predicts
  HalfWork half;
  // Of a string on a chain (chained_string.hpp).
  string::ChainWork chain;
  string::ChainState chain_start;
  string::TopCommand command;
  string::EndMotion end_before;  ///< at the step's start
  Wrench chain_damper;           ///< on the bit, by Kelvin-Voigt's dampers of the last element
};

/// At rest with its energies. Give it the wrench of the start where the bit touches rock.
Drilling start_drilling(const DrillingSystem& system, DrillingState state,
                        string::ChainState chain = {});

/// Ready for the next step of what was just started, or saved between two steps: the motion goes
/// on to the same bits as without the interruption.
DrillingWork drilling_work(const DrillingSystem& system, const Drilling& d);

/// First half of a step of h (s): the flow of the last wrench, of string, wall and gravity and of
/// all that resists, then the drift. Positions and time are then those of the step's end: cut the
/// rock there.
/// Throws RunError when an implicit drift does not converge; `d` is then as it was before the step.
void open_step(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work);

/// The state at the step's end with the momenta that the last wrench predicts: what a force law
/// that depends on velocity is evaluated at. Without the impulses of the cones' own spins when the
/// wrench gives them at the step's end. Lives in `work` until the next step.
const DrillingState& predicted(const DrillingSystem& system, double h, const Drilling& d,
                               DrillingWork& work);

/// The flows between a state and the next drift: of an open step, its closing flow and the opening
/// one of the next step; of a state between two steps, the opening flow.
enum class KicksLeft { closing_and_opening, opening };

/// The velocity after these flows with this wrench, at positions that stand still: what the next
/// drift moves with. Overwrites the state that predicted() returned.
void velocity_after(const DrillingSystem& system, double h, const Drilling& d, KicksLeft kicks,
                    const Wrench& wrench, DrillingWork& work, DrillingVelocity& out);

/// Second half: the flow of the new wrench, and the ledger.
void close_step(const DrillingSystem& system, double h, const Wrench& wrench, Drilling& d,
                DrillingWork& work);

}  // namespace tdbd::dynamics
