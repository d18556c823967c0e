#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "calibration/result/calibrate.hpp"

namespace tdbd::calibration {

/// What `tdbd calibrate` prints: coefficients with intervals, whether the law fits and otherwise
/// the readings that fit worst, the least determined direction, the errors of predicted bits, and
/// the assumptions of the intervals. A fit takes at most 14 lines and one per coefficient.
std::string answer_text(const CalibrationCase& c, const Calibration& found);

/// The assumptions under which intervals of coefficients and predictions hold, one sentence each.
std::vector<std::string> assumptions_of(const FittedSet& set);

/// The warning of a law that does not fit the readings, with the row that fits worst; empty if the
/// law fits.
std::string misfit_warning(const FittedSet& set, const Records& records);

/// The keys of calibration.json about the quality of a fit:
///   fits                              true or false; null without degrees of freedom
///   fit_test                          statistic, degrees_of_freedom, reduced_chi2, p_value,
///                                     rejected_below, false_alarm_probability
///   readings_within_2_deviations      of `readings`
///   worst_readings                    more than 2 deviations away, at most 5: line of the record,
///                                     test, tool, load, measured, computed, deviations,
///                                     deviations_in_test
///   intervals_assume                  assumptions_of
nlohmann::ordered_json quality_json(const FittedSet& set, ToolKind kind);

/// The errors of predictions as keys WHAT_LOAD_rms, _largest, _p95 (null below 20 readings),
/// _readings and _within_2_deviations.
nlohmann::ordered_json errors_json(const std::vector<Prediction>& predictions,
                                   const std::string& what, ToolKind kind);

}  // namespace tdbd::calibration
