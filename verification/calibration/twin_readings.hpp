#pragma once

#include "calibration/fit/problem.hpp"
#include "reference/calibration/dense_covariance.hpp"
#include "reference/calibration/variable_projection.hpp"

namespace tdbd::calibration {

/// The coefficients of a law of Hanson and Hansen as the twins have them.
reference::Coefficients twin_coefficients(const forces::Law& law);

/// A problem as the twins have it: its readings from the records, and their covariance computed
/// from the noise, in one matrix. Slopes are those at the problem's law.
reference::Readings twin_readings(const Problem& p, const Noise& noise);

/// d log load / d value of the problem's unknowns by the twin's loads, for these coefficients.
Eigen::MatrixXd twin_derivatives(const Problem& p, const forces::Law& law);

}  // namespace tdbd::calibration
