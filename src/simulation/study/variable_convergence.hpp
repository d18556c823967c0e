#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/observed_order.hpp"
#include "simulation/study/hole.hpp"
#include "simulation/study/state_variables.hpp"
#include "simulation/study/uncertainty.hpp"

namespace tdbd::simulation {

/// One value of each quantity, and what the case came to with them.
struct ConvergenceLevel {
  std::vector<double> sizes;  ///< of the quantities, SI; for time.step the step that was used
  long steps = 0;
  EndState end;
  std::optional<HoleDifference> moved;  ///< from the hole of the level before
};

/// How one variable converges.
struct VariableConvergence {
  std::string name, units;
  double scale = 0.0;                    ///< largest size over levels: errors are relative to it
  std::vector<double> differences = {};  ///< to the next level or to the reference; absolute
  ObservedOrder order = {};              ///< over the first quantity
  /// Not against a reference: of the finest level, and its values beyond it, simulation (10); none
  /// for attitudes, where no order was observed, and for distances between surfaces.
  std::optional<Uncertainty> uncertainty = {};
  std::vector<double> extrapolated = {};
};

/// What the errors of a study's levels are measured against.
struct Yardstick {
  std::optional<EndState> reference;  ///< none: the next level
  double nominal_order = 0.0;         ///< 0: not known
};

/// Every variable of the levels' ends; of drilling without a reference also surface_distance, the
/// Hausdorff distance of the holes (scale: the hole's radius), and volume_between them (scale: the
/// removed volume). All levels have the variables of the first, and those of the reference.
std::vector<VariableConvergence> observe(const std::vector<ConvergenceLevel>& levels,
                                         const Yardstick& yardstick);

}  // namespace tdbd::simulation
