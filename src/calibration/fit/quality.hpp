#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "calibration/fit/fit.hpp"

namespace tdbd::calibration {

/// Probability that a calibration is reported as a misfit although law and noise are right.
inline constexpr double false_alarm = 0.01;

/// A reading of a fit.
struct FittedReading {
  std::size_t record = 0;  ///< index into Problem::records
  std::size_t load = axial;
  double ratio = 1.0;  ///< computed over measured load
  /// log(ratio) over the standard deviation of the reading: its own noise, that of the rate, and
  /// that of the test.
  double deviations = 0.0;
  /// The same for the difference from what the law and the other readings of the test predict, over
  /// its standard deviation. Equal to `deviations` if readings are independent.
  double deviations_in_test = 0.0;
};

/// How well a fit describes its readings, calibration (7).
struct FitQuality {
  double statistic = 0.0;          ///< chi2 of the readings and of the priors
  long degrees_of_freedom = 0;     ///< readings and priors minus coefficients inside their ranges
  double p_value = 1.0;            ///< probability of a larger statistic; 1 without freedom
  double threshold = false_alarm;  ///< the fit is rejected below this p_value
  std::vector<FittedReading> readings;  ///< in the order of the problem

  /// Whether the law fits; empty without degrees of freedom, because any law would then fit.
  std::optional<bool> fits() const {
    if (degrees_of_freedom <= 0) return std::nullopt;
    return p_value >= threshold;
  }
};

/// Tests whether the law fits the readings. The statistic of a fit that is right has a chi2
/// distribution if the noise is normal, as large as the case states, and so small that the law is
/// linear over it. `fits`: number of fits of one calibration, which share its false alarms.
FitQuality quality_of(const Fit& fit, std::size_t fits = 1);

/// The readings that fit worst, the worst first: those more than `limit` standard deviations away
/// in either measure, at most `most`.
std::vector<FittedReading> worst_readings(const FitQuality& quality, double limit,
                                          std::size_t most);

/// Number of readings within `limit` standard deviations.
long readings_within(const FitQuality& quality, double limit);

}  // namespace tdbd::calibration
