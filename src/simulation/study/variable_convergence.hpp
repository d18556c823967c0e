#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/observed_order.hpp"
#include "simulation/study/hole.hpp"
#include "simulation/study/state_variables.hpp"
#include "simulation/study/uncertainty.hpp"

namespace tdbd::simulation {

/// One value of each quantity, and the resulting end of the case.
struct ConvergenceLevel {
  std::vector<double> sizes;  ///< of the quantities, SI; for time.step the step as used
  long steps = 0;
  EndState end;
  std::optional<HoleDifference> moved;  ///< relative to the hole of the previous level
};

/// Convergence of one variable.
struct VariableConvergence {
  std::string name, units;
  double scale = 0.0;                    ///< largest magnitude over levels, for relative errors
  std::vector<double> differences = {};  ///< to the next level or to the reference; absolute
  ObservedOrder order = {};              ///< in the first quantity
  /// Only without a reference: uncertainty of the finest level, and extrapolated values, simulation
  /// (10). Extrapolated values are empty for attitudes, without an observed order, and for
  /// distances between surfaces.
  std::optional<Uncertainty> uncertainty = {};
  std::vector<double> extrapolated = {};
};

/// What the results of a study's levels are compared with.
struct Yardstick {
  std::optional<EndState> reference;  ///< none: the next level
  double nominal_order = 0.0;         ///< 0: unknown
};

/// Convergence of every variable at the end of the levels. For drilling without a reference also
/// surface_distance, the Hausdorff distance of the holes (scale: radius of the hole), and
/// volume_between (scale: removed volume). All levels must have the variables of the first level
/// and of the reference.
std::vector<VariableConvergence> observe(const std::vector<ConvergenceLevel>& levels,
                                         const Yardstick& yardstick);

}  // namespace tdbd::simulation
