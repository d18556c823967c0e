#pragma once

#include <array>
#include <optional>

#include "reference/calibration/hanson_hansen_loads.hpp"

namespace tdbd::reference {

/// Readings of loads and their covariance.
struct Readings {
  std::vector<std::vector<forces::PartCut>> records;  ///< cuts of each record
  std::vector<std::pair<std::size_t, int>> places;    ///< record, and 0: weight, 1: torque
  Eigen::VectorXd log_loads;
  Eigen::MatrixXd covariance;  ///< of the logarithms
};

/// Bounds of the two coefficients that are searched.
struct SearchRange {
  double A3_lo = 0.0, A3_hi = 1.0;        ///< rad
  double share_lo = 0.0, share_hi = 2.0;  ///< of pressure_share
};

/// Normal priors: centre and standard deviation of each coefficient, in the order A1, A2, A3, A4,
/// A5, A6, pressure_share. No prior if the deviation is missing.
struct Prior {
  double centre = 0.0;
  std::optional<double> sd;
};
using SevenPriors = std::array<Prior, 7>;

/// The result of the search.
struct Projected {
  Coefficients coefficients;
  double objective = 0.0;
};

/// Slow twin of the calibration's fit: variable projection. For fixed A3 and pressure_share the
/// loads are linear in the factors, and least squares of the logarithms are solved by repeated
/// linearization, with nonnegative factors. A3 and pressure_share are searched on a grid, then by
/// nested golden-section searches. Uses no derivatives with respect to them, no free variables and
/// no trust region.
Projected variable_projection(const Readings& readings, const Coefficients& start,
                              const SearchRange& range, const SevenPriors& priors = {});

}  // namespace tdbd::reference
