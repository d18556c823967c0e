#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/fit/fit.hpp"

namespace tdbd::calibration {

/// What a law is wrong by beyond noise, relative, of each load: leave-one-bit-out.
struct Discrepancy {
  Loads value{};
  std::string reason;  ///< why it is not known; empty if it is
};

/// One load of one record, predicted. N or N m.
struct PredictedLoad {
  double mean = 0.0;
  double se = 0.0;               ///< of the mean, from the coefficients alone
  double low = 0.0, high = 0.0;  ///< interval of a reading: coefficients, discrepancy and noise
};

struct Prediction {
  Record record;
  std::array<PredictedLoad, 2> loads;
};

/// The loads of a record, calibration (6). Intervals are those of the logarithm.
Prediction predict(const Fit& fit, const Sample& sample, const Record& record, const Noise& noise,
                   const Discrepancy& discrepancy, double level);

/// rms and 95th percentile of |computed/measured - 1| over all readings of a load; nothing where
/// nothing was read.
struct PredictionError {
  double rms = 0.0, p95 = 0.0;
  long readings = 0;
};
std::array<PredictionError, 2> errors_of(const std::vector<Prediction>& predictions);

/// Fits without each of the fitted tools in turn and predicts it: the excess of the mean squared
/// error over what coefficients and noise explain. Unknown with one tool, or where a fit without a
/// tool is not identifiable.
Discrepancy leave_one_tool_out(const CalibrationCase& c, const CutStore& cuts,
                               const std::vector<Record>& fitted);

/// Where the predicted records lie outside of what was fitted: mean back rake, cutter diameter,
/// thickness of the cut, pressure; one text each. Empty: inside.
std::vector<std::string> extrapolations(const std::vector<Sample>& fitted,
                                        const std::vector<Sample>& predicted);

}  // namespace tdbd::calibration
