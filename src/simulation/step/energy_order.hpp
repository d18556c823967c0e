#pragma once

#include "dynamics/drilling/residual_order.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The observed order of the residual of a run's own ledger of energy (ours; dynamics (17)), and
/// the window that it was observed in.
struct EnergyOrder {
  dynamics::ResidualOrder residual;
  double from = 0.0, window = 0.0;  ///< s: when the window begins, how long it is
};

/// When the order is observed, in steps since the motion's beginning.
struct EnergyOrderPlan {
  long at = -1;        ///< the window begins after so many steps; -1: not at all
  std::string reason;  ///< why not
};

/// The window begins with the steps that count in means (output.means_from), at a maintenance, or
/// as late as it fits into the run.
EnergyOrderPlan plan_energy_order(const Case& c);

/// Drills the window that follows `s` again, on copies, at the step h of the case, h/2 and h/4,
/// maintenance at the same times. The run itself is not touched. No order where the bit loses
/// contact in it, or a finer level fails.
EnergyOrder observe_energy_order(const Case& c, const Simulation& s);

}  // namespace tdbd::simulation
