#pragma once

#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "core/config/config.hpp"

namespace tdbd::calibration {

/// Every name of fit_bits and predict_bits is a tool of the case and has records, once, and no
/// name is in both.
void check_names(Config& calibration, const CalibrationCase& c);

/// Keeps the tools of fit_bits and predict_bits and their records without the tests that are left
/// out; the rocks that records name must be known. Unknown tests and rocks are mistakes.
void choose_records(Config& calibration, const std::vector<std::string>& left_out,
                    CalibrationCase& c);

/// What makes a calibration senseless whatever the bits are: fewer readings than unknowns without
/// priors, a fitted record without a reading, a share of pressure fitted at one pressure, A1 and A3
/// of hanson-hansen without torque. Throws InputError with what would help.
void check_calibration(const CalibrationCase& c);

}  // namespace tdbd::calibration
