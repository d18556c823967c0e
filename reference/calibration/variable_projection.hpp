#pragma once

#include <array>
#include <optional>

#include "reference/calibration/hanson_hansen_loads.hpp"

namespace tdbd::reference {

/// Readings of loads, and what is known beforehand of the coefficients.
struct Readings {
  std::vector<std::vector<forces::PartCut>> records;  ///< cuts of each record
  std::vector<std::pair<std::size_t, int>> places;    ///< record, and 0: weight, 1: torque
  Eigen::VectorXd log_loads;
  Eigen::MatrixXd covariance;  ///< of the logarithms
};

/// Ends of the two coefficients that are searched.
struct SearchRange {
  double A3_lo = 0.0, A3_hi = 1.0;        ///< rad
  double share_lo = 0.0, share_hi = 2.0;  ///< of pressure_share
};

/// Normal priors: centre and deviation of each coefficient, in the order A1, A2, A3, A4, A5, A6,
/// pressure_share; none where the deviation is missing.
struct Prior {
  double centre = 0.0;
  std::optional<double> sd;
};
using SevenPriors = std::array<Prior, 7>;

/// Where the search ended.
struct Projected {
  Coefficients coefficients;
  double objective = 0.0;
};

/// The slow twin of the calibration's fit: variable projection. For fixed A3 and pressure_share the
/// loads are linear in the factors, and least squares of the logarithms is solved by linearising
/// again and again, with factors that may not be negative. A3 and pressure_share are searched:
/// first on a grid, then by one golden section inside the other. No derivative with respect to
/// them, no free variables, no trust region.
Projected variable_projection(const Readings& readings, const Coefficients& start,
                              const SearchRange& range, const SevenPriors& priors = {});

}  // namespace tdbd::reference
