#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "calibration/fit/fit.hpp"
#include "core/random.hpp"

namespace tdbd::calibration {

/// A standard normal random number by the Box-Muller method; the second number of each pair is
/// discarded.
inline double normal(Random& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * random.uniform());
}

/// Relative model error of each load, beyond noise, from leave-one-bit-out fits.
struct Discrepancy {
  Loads value{};
  std::string reason;  ///< why it is unknown; empty if it is known
};

/// Prediction of one load of one record, N or N m.
struct PredictedLoad {
  double mean = 0.0;
  double se = 0.0;               ///< of the mean, from the coefficients only
  double low = 0.0, high = 0.0;  ///< interval of a reading: coefficients, discrepancy and noise
  /// log(computed/measured) over the standard deviation of a reading about the mean; of a fitted
  /// record over that of the noise. Empty without a reading.
  std::optional<double> standardised = std::nullopt;
};

struct Prediction {
  Record record;
  std::array<PredictedLoad, 2> loads;
};

/// Predicts the loads of a record, calibration (6). Intervals are computed for the logarithm.
Prediction predict(const Fit& fit, const Sample& sample, const Record& record, const Noise& noise,
                   const Discrepancy& discrepancy, double level);

/// rms, 95th percentile and largest value of |computed/measured - 1| over all readings of a load;
/// zero without readings.
struct PredictionError {
  double rms = 0.0, p95 = 0.0, largest = 0.0;
  long readings = 0;
  long within_two = 0;  ///< readings within two standard deviations of their prediction
};
/// Fewer readings have no 95th percentile that differs from the largest value.
inline constexpr long least_for_p95 = 20;
std::array<PredictionError, 2> errors_of(const std::vector<Prediction>& predictions);

/// For each fitted tool, fits without it and predicts it. The discrepancy is the excess of the mean
/// squared error over that explained by coefficients and noise. Unknown with only one tool, or if a
/// fit without a tool is not identifiable.
Discrepancy leave_one_tool_out(const CalibrationCase& c, const CutStore& cuts,
                               const std::vector<Record>& fitted);

/// Describes where the predicted records are outside the range of the fitted ones: mean back rake,
/// cutter diameter, thickness of the cut, pressure; one text each. Empty if all are inside.
std::vector<std::string> extrapolations(const std::vector<Sample>& fitted,
                                        const std::vector<Sample>& predicted);

/// Distribution of a coefficient over replicates.
struct BootstrapSummary {
  double mean = 0.0, se = 0.0, low = 0.0, high = 0.0;  ///< SI; percentiles for the interval level
};

struct Bootstrap {
  long replicates = 0, failed = 0;
  std::vector<BootstrapSummary> coefficients;  ///< in the order of the unknowns; may be empty
};

/// Parametric bootstrap: readings are drawn around the fitted loads, and prior centres around the
/// fitted values, with the covariance of the problem. Each replicate is fitted starting from the
/// values of the fit. The same seed gives the same numbers.
Bootstrap bootstrap(const Fit& fit, const Intervals& intervals);

/// Draws data around these values of the coefficients.
Data drawn_data(const Problem& problem, const Eigen::VectorXd& values, std::uint64_t seed);

}  // namespace tdbd::calibration
