#pragma once

#include "dynamics/drilling/drilling_system.hpp"
#include "dynamics/drilling/resisted_flow.hpp"

/// Half steps of a bit that a wall resists. A ring that runs around its wall turns the contact from
/// node to node; both geometries, of the node and of the middle of the drift, get a quarter step.
namespace tdbd::dynamics {

/// The two halves of a step h that enclose the drift, h/2 each.
enum class Half { opening, closing };

/// Share of h/2 over which a wrench's cone torques act in a half.
double cone_share(ConeImpulse impulse, Half half);

/// What half steps keep: no allocation once warm.
struct HalfWork {
  FlowWork flow;
  Eigen::VectorXd force, mean;
  DrillingState trial, halfway;
  DrillingVelocity mean_velocity;  ///< of trials
};

/// What acts over a half step.
struct HalfStep {
  double h = 0.0;  ///< s, of the whole step
  Half half = Half::opening;
  const Configuration& node;  ///< whose conservative forces act
  const Configuration&
      middle;  ///< of the drift that follows an opening half or precedes a closing one
  const Wrench& wrench;
  double cone_share = 1.0;  ///< scales the wrench's torques on cones
};

/// Forces and all that resists over h/2, (23). Writes the mean velocity to `mean`, and losses
/// to the ledger; a trial has none (null).
void take_half_step(const DrillingSystem& system, const HalfStep& step, DrillingState& state,
                    EnergyLedger* ledger, HalfWork& work, DrillingVelocity& mean);

/// Predicts the configuration in the middle of the drift that follows an opening half from `state`.
/// Returns the node's where a drift does not converge, and where no part of the wall resists.
void find_middle(const DrillingSystem& system, double h, const Configuration& node,
                 const Wrench& wrench, const DrillingState& state, HalfWork& work,
                 Configuration& middle);

}  // namespace tdbd::dynamics
