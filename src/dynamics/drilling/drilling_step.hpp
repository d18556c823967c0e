#pragma once

#include "dynamics/drilling/configuration.hpp"
#include "dynamics/drilling/drilling_system.hpp"
#include "dynamics/drilling/energy_ledger.hpp"
#include "dynamics/drilling/resisted_flow.hpp"

namespace tdbd::dynamics {

// Half steps of a bit that a wall resists. If the ring moves around its wall, the direction of
// contact changes from node to node. The geometries of the node and of the middle of the drift are
// then used for a quarter step each.

/// The two halves, h/2 each, before and after the drift of a step h.
enum class Half { opening, closing };

/// Factor on the cone torques of a wrench in one half: 0, 1 or 2.
double cone_share(ConeImpulse impulse, Half half);

/// Work data of half steps, reused so that later steps allocate nothing.
struct HalfWork {
  FlowWork flow;
  Eigen::VectorXd force, mean;
  DrillingState trial, halfway;
  DrillingVelocity mean_velocity;  ///< of trials
};

/// Inputs of a half step.
struct HalfStep {
  double h = 0.0;  ///< s, of the whole step
  Half half = Half::opening;
  const Configuration& node;  ///< its conservative forces act
  const Configuration&
      middle;  ///< of the drift that follows an opening half or precedes a closing one
  const Wrench& wrench;
  double cone_share = 1.0;  ///< scales the torques of the wrench on the cones
};

/// Flow of forces and resistances over h/2, (23). Writes the mean velocity to `mean` and the losses
/// to `ledger`, which is null for a trial.
void take_half_step(const DrillingSystem& system, const HalfStep& step, DrillingState& state,
                    EnergyLedger* ledger, HalfWork& work, DrillingVelocity& mean);

/// Predicts the configuration in the middle of the drift that follows an opening half from `state`.
/// Returns the configuration of the node if the drift does not converge or the wall does not
/// resist.
void find_middle(const DrillingSystem& system, double h, const Configuration& node,
                 const Wrench& wrench, const DrillingState& state, HalfWork& work,
                 Configuration& middle);

/// The complete state of a drilling bit: sufficient for a restart. Momenta and positions belong to
/// the same time if no step is open.
struct Drilling {
  DrillingState state;
  Wrench wrench;             ///< of the last cut; acts in the first half of the next step
  EnergyLedger ledger;       ///< since start_drilling
  string::ChainState chain;  ///< used if the string is a chain

  template <class Archive>
  void serialize(Archive& a) {
    a(state, wrench, ledger, chain);
  }
};

/// Work data of a step, reused so that steps allocate nothing after the first.
struct DrillingWork {
  Configuration at;  ///< of the positions of the state if no step is open
  /// Mean velocity over the opening and over the closing flow of the last step. A force F of the
  /// wrench did the work (h/2) F . v in that flow, exactly.
  DrillingVelocity opening, closing;
  DrillingState predicted, step_start;
  DrillingVelocity before;
  Configuration middle;       ///< in the middle of the last drift, predicted by its opening half
  Configuration next_middle;  ///< in the middle of the drift that velocity_after_kicks predicts
  HalfWork half;
  // For a chained string (chained_string.hpp).
  string::ChainWork chain;
  string::ChainState chain_start;
  string::TopCommand command;
  string::EndMotion end_before;  ///< at the start of the step
  Wrench chain_damper;           ///< on the bit, of the Kelvin-Voigt dampers of the last element
};

/// Starts a bit in the given state and computes its initial energy. If the bit touches rock, set
/// `wrench` of the result to the initial wrench.
Drilling start_drilling(const DrillingSystem& system, DrillingState state,
                        string::ChainState chain = {});

/// Prepares the next step after start_drilling or a restart. A restarted run is bitwise identical
/// to an uninterrupted one.
DrillingWork drilling_work(const DrillingSystem& system, const Drilling& d);

/// First half of a step of h (s): the flow of the last wrench, string, wall, gravity and all
/// resistances, then the drift. Afterwards positions and time are those at the end of the step,
/// where the rock must be cut. Throws RunError if an implicit drift does not converge; `d` is then
/// unchanged.
void open_step(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work);

/// State at the end of the step with momenta predicted from the last wrench. A force law that
/// depends on velocity is evaluated at this state. It excludes the impulses on the cones' own spins
/// if the wrench applies them at the end of the step. Stored in `work` until the next step.
const DrillingState& predicted(const DrillingSystem& system, double h, const Drilling& d,
                               DrillingWork& work);

/// The flows before the next drift. For an open step: its closing flow and the opening flow of the
/// next step. For a state between two steps: the opening flow.
enum class RemainingKicks { closing_and_opening, opening };

/// Velocity after these flows with this wrench at fixed positions, which is the velocity of the
/// next drift. Overwrites the state returned by predicted().
void velocity_after_kicks(const DrillingSystem& system, double h, const Drilling& d,
                          RemainingKicks kicks, const Wrench& wrench, DrillingWork& work,
                          DrillingVelocity& out);

/// Second half of a step: the flow of the new wrench, and the ledger.
void close_step(const DrillingSystem& system, double h, const Wrench& wrench, Drilling& d,
                DrillingWork& work);

}  // namespace tdbd::dynamics
