#pragma once

#include "dynamics/drilling/drilling_system.hpp"
#include "dynamics/drilling/resisted_flow.hpp"

/// Half steps of a bit that a wall resists. If the ring moves around its wall, the direction of
/// contact changes from node to node. The geometries of the node and of the middle of the drift are
/// then used for a quarter step each.
namespace tdbd::dynamics {

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

}  // namespace tdbd::dynamics
