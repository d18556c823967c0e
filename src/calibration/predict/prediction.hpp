#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/fit/fit.hpp"

namespace tdbd::calibration {

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
};

struct Prediction {
  Record record;
  std::array<PredictedLoad, 2> loads;
};

/// Predicts the loads of a record, calibration (6). Intervals are computed for the logarithm.
Prediction predict(const Fit& fit, const Sample& sample, const Record& record, const Noise& noise,
                   const Discrepancy& discrepancy, double level);

/// rms and 95th percentile of |computed/measured - 1| over all readings of a load; zero without
/// readings.
struct PredictionError {
  double rms = 0.0, p95 = 0.0;
  long readings = 0;
};
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

}  // namespace tdbd::calibration
