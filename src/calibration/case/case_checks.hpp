#pragma once

#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "core/config/config.hpp"

namespace tdbd::calibration {

/// Records a mistake unless every name in fit_bits and predict_bits is a tool of the case with
/// records and occurs only once in both lists together.
void check_names(Config& calibration, const CalibrationCase& c);

/// Keeps the tools of fit_bits and predict_bits and their records, without the tests that are left
/// out. Finds the rocks that records name. Unknown tests and rocks are mistakes.
void choose_records(Config& calibration, const std::vector<std::string>& left_out,
                    CalibrationCase& c);

/// Finds faults of a calibration that do not depend on its bits: fewer readings than unknowns
/// without priors, a fitted record without a reading, a pressure share fitted at only one pressure,
/// A1 and A3 of hanson-hansen without torque, a groove deeper than the face of its cutter, and an
/// advance of more than 100 mm per revolution. Throws InputError that suggests remedies.
void check_calibration(const CalibrationCase& c);

}  // namespace tdbd::calibration
