#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case_warning.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// Reads sections, survey and friction of the table [string], which it checks against each other.
/// `step`: s, for the default loss time. Notes mistakes in the file; appends warnings.
StringPlan read_string_plan(Config& whole, double step, std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
