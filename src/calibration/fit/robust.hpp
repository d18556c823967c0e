#pragma once

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"
#include "calibration/fit/fit.hpp"

namespace tdbd::calibration {

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
