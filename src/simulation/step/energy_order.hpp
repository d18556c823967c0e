#pragma once

#include "dynamics/drilling/energy_ledger.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The observed order of the residual of the energy ledger of a run (dynamics (17)), and the window
/// in which it was observed. An addition of TDBD [+].
struct EnergyOrder {
  dynamics::ResidualOrder residual;
  double from = 0.0, window = 0.0;  ///< s: start and length of the window

  template <class Archive>
  void serialize(Archive& a) {
    a(residual, from, window);
  }
};

/// When the order is observed, in steps since the start of the motion.
struct EnergyOrderPlan {
  long at = -1;        ///< step at which the window starts; -1: never
  std::string reason;  ///< why it is never observed
};

/// The window starts with the first step that is included in means (output.means_from), at a
/// maintenance, or as late as it fits into the run.
EnergyOrderPlan plan_energy_order(const Case& c);

/// Recomputes the window that follows `s` on copies, with the step h of the case, h/2 and h/4, and
/// with maintenance at the same times. The run itself is not changed. There is no order if the bit
/// loses contact in the window or a finer level fails.
EnergyOrder observe_energy_order(const Case& c, const Simulation& s);

}  // namespace tdbd::simulation
