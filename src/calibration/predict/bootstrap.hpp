#pragma once

#include <cstdint>
#include <vector>

#include "calibration/fit/fit.hpp"

namespace tdbd::calibration {

/// Distribution of a coefficient over replicates.
struct BootstrapFigures {
  double mean = 0.0, se = 0.0, low = 0.0, high = 0.0;  ///< SI; percentiles for the interval level
};

struct Bootstrap {
  long replicates = 0, failed = 0;
  std::vector<BootstrapFigures> coefficients;  ///< in the order of the unknowns; may be empty
};

/// Parametric bootstrap: readings are drawn around the fitted loads, and prior centres around the
/// fitted values, with the covariance of the problem. Each replicate is fitted starting from the
/// values of the fit. The same seed gives the same numbers.
Bootstrap bootstrap(const Fit& fit, const Intervals& intervals);

/// Draws data around these values of the coefficients.
Data drawn_data(const Problem& problem, const Eigen::VectorXd& values, std::uint64_t seed);

}  // namespace tdbd::calibration
