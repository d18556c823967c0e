#pragma once

#include <cstdint>
#include <vector>

#include "calibration/fit/fit.hpp"

namespace tdbd::calibration {

/// Spread of the coefficients over replicates.
struct BootstrapFigures {
  double mean = 0.0, se = 0.0, low = 0.0, high = 0.0;  ///< SI; percentiles of the interval's level
};

struct Bootstrap {
  long replicates = 0, failed = 0;
  std::vector<BootstrapFigures> coefficients;  ///< in the order of the unknowns; none: not made
};

/// Parametric bootstrap: readings drawn around the fitted loads, and prior centres around the
/// fitted values, with the problem's own covariance; each replicate is fitted from the fit's values. The
/// same seed gives the same numbers.
Bootstrap bootstrap(const Fit& fit, const Intervals& intervals);

/// Data drawn around these values of the coefficients.
Data drawn_data(const Problem& problem, const Eigen::VectorXd& values, std::uint64_t seed);

}  // namespace tdbd::calibration
