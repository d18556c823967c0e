#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/observed_order.hpp"
#include "simulation/study/levels.hpp"

namespace tdbd::simulation {

/// Basis of an estimate of the numerical uncertainty.
enum class UncertaintyBasis {
  exact,           ///< all differences are rounding; no uncertainty
  observed_order,  ///< observed order, limited to that of the method
  slope,           ///< median slope of scattered differences, and the largest of them
  range            ///< no convergence: three times the largest difference between levels
};

/// Numerical uncertainty of the finest level, simulation (9) to (12).
struct Uncertainty {
  UncertaintyBasis basis = UncertaintyBasis::range;
  double order = 0.0;   ///< order with which the error is assumed to decrease; 0 if none is used
  double factor = 0.0;  ///< safety factor
  double error = 0.0;   ///< estimated distance of the finest level from the limit, (9)
  double value = 0.0;   ///< factor * error: intended to bound the error in 95 of 100 cases
};

/// Computes the uncertainty from the differences between successive levels and their observed
/// order: the grid convergence index (Roache 1994; ASME V&V 20-2009) if the differences decrease,
/// otherwise the range of the levels (Eca and Hoekstra 2014). `sizes` are those of all levels, one
/// more than `differences`. `nominal` is the order of the method, 0 if unknown. `range` is the
/// largest distance between two levels.
Uncertainty uncertainty_of(const ObservedOrder& observed, std::span<const double> sizes,
                           std::span<const double> differences, double nominal, double range);

/// "observed order", "slope of all differences", "range of the levels", "exact".
const char* name_of(UncertaintyBasis basis);

/// One value of each quantity, and the resulting end of the case.
struct ConvergenceLevel {
  std::vector<double> sizes;  ///< of the quantities, SI; for time.step the step as used
  long steps = 0;
  EndState end;
  std::optional<HoleDifference> moved;  ///< relative to the hole of the previous level
  long evaluations = 0;                 ///< torque evaluations, for a rotation
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
