#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/result/summary.hpp"

// The answer of a run for a reader: what `tdbd run` prints.

namespace tdbd::simulation {

/// Units of printed answers.
enum class AnswerUnits {
  metric,  ///< kN, kN m, m/h, mm, MPa, cm3
  field,   ///< lbf, ft lbf, ft/h, in, psi, in3
};

/// A value and, if it is known and not negligible, the half-width of its interval: "30.010 +-
/// 0.011", "139.4". The half-width has two significant digits and the value as many decimals, at
/// most six significant digits; without a half-width it has four.
std::string with_half_width(double value, std::optional<double> half_width = {});

/// Returns "a volume" of m3 in these units: "123.4 cm3".
std::string volume_text(double volume, AnswerUnits units);

/// Returns the answer of a run, a line for each: weight on bit and the set one, torque, rate,
/// specific energy, imbalance, diagnosis. Half-widths are those of 95 % confidence intervals of the
/// means over time (SamplingUncertainty). A run without forces or without means has one line, which
/// states why.
std::vector<std::string> answer_lines(const RunSummary& summary, AnswerUnits units);

}  // namespace tdbd::simulation
