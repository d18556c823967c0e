#pragma once

#include <span>
#include <string>

#include "core/observed_order.hpp"

namespace tdbd::simulation {

/// What an estimate of the numerical uncertainty rests on.
enum class UncertaintyBasis {
  exact,           ///< all differences are rounding: none
  observed_order,  ///< the order that was observed, at most the method's
  slope,           ///< the median slope of differences that scatter, and the largest beside it
  range            ///< no convergence: three times the largest difference between levels
};

/// Numerical uncertainty of the finest level, simulation (9) to (12).
struct Uncertainty {
  UncertaintyBasis basis = UncertaintyBasis::range;
  double order = 0.0;   ///< that the error is taken to fall with; 0 where no order is used
  double factor = 0.0;  ///< of safety
  double error = 0.0;   ///< estimate of the finest level's distance from the limit, (9)
  double value = 0.0;   ///< factor * error: meant to hold the true distance in 95 of 100 cases
};

/// Of the differences between neighbouring levels and their observed order: the grid convergence
/// index (Roache 1994; ASME V&V 20-2009) where they fall, the range of the levels (Eca and
/// Hoekstra 2014) where they do not. `sizes`: of all levels, one more than `differences`.
/// `nominal`: order of the method, 0: not known. `range`: the largest distance between two levels.
Uncertainty uncertainty_of(const ObservedOrder& observed, std::span<const double> sizes,
                           std::span<const double> differences, double nominal, double range);

/// "observed order", "slope of all differences", "range of the levels", "exact".
const char* name_of(UncertaintyBasis basis);

}  // namespace tdbd::simulation
