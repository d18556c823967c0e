#pragma once

#include "reference/compare/models/blanks.hpp"

/// What each model says about a case: one function a model, in a file of its name.
namespace tdbd::reference {

Findings answer_of_tdbd(const Question& q);
Findings answer_of_warren_sinor(const Question& q);
Findings answer_of_behr(const Question& q);
Findings answer_of_langeveld(const Question& q);
Findings answer_of_hanson_hansen(const Question& q);

}  // namespace tdbd::reference
