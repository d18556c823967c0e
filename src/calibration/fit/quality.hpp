#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"
#include "calibration/fit/fit.hpp"
#include "calibration/fit/problem.hpp"

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

/// Sensitivity of the readings alone, without priors, to the unknowns: singular values of the
/// whitened derivatives with respect to relative changes of the unknowns, calibration (5).
struct Identifiability {
  std::vector<double> singular_values;    ///< decreasing: noise deviations per unit change
  std::vector<double> weakest_direction;  ///< unit vector, relative changes, smallest effect
};

Identifiability identifiability_at(const Problem& problem, const Eigen::VectorXd& values);

/// The weakest direction as text: "A2 +100 %, A4 -62 %: this changes all readings together by 0.3
/// times their noise".
std::string in_words(const Problem& problem, const Identifiability& found);

/// Checks a problem before it is fitted. Throws InputError with advice if an unknown affects no
/// part of the bits, or if a direction affects neither readings nor priors: its singular value is
/// below this share of the largest.
inline constexpr double unseen = 1e-7;
void require_identifiable(const Problem& problem);

/// Residuals up to this number of standard deviations have full weight in a robust fit. With normal
/// errors, its variance is 5 % above that of least squares (Huber 1964).
inline constexpr double huber_limit = 1.345;

/// The weights of a robust fit count as settled when no coefficient changes by more than this share
/// of its standard error.
inline constexpr double settled_weights = 1e-4;

/// At most so many fits with new weights are made. They converge linearly, so some need hundreds.
inline constexpr int most_reweightings = 1000;

/// Fits a problem of a case with the loss of the case. Loss::huber repeats the fit: a reading that is
/// d > huber_limit standard deviations away gets its own deviation multiplied by
/// sqrt(d/huber_limit), which is iteratively reweighted least squares for the loss of Huber. The
/// result contains the problem with its original deviations, so that chi2, objectives and residuals
/// are those of the readings as they are; the covariance is that of the last weights. Throws RunError
/// if a fit does not converge, or the weights do not settle. Calibration (3); not in the thesis.
Fit fit_with_loss(const CalibrationCase& c, const CutStore& cuts, const Problem& problem);

}  // namespace tdbd::calibration
