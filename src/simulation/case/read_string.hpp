#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case_warning.hpp"
#include "string/section.hpp"
#include "string/side_force.hpp"
#include "string/survey.hpp"

namespace tdbd::simulation {

/// What a string is made of and where it lies.
struct StringPlan {
  std::vector<string::Section> sections;
  string::Survey survey;
  std::vector<string::FrictionBelow> friction;          ///< by depth, downward
  double threshold = 0.0;                               ///< m/s
  double axial_damping = 0.0, torsional_damping = 0.0;  ///< 1/s
  double axial_loss_time = 0.0;                         ///< s
  double torsional_loss_time = 0.0;                     ///< s
  double hole_diameter = 0.0;                           ///< m; 0: not given
};

/// Reads sections, survey and friction of the table [string], which it checks against each other.
/// `step`: s, for the default loss time. Notes mistakes in the file; appends warnings.
StringPlan read_string_plan(Config& whole, double step, std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
