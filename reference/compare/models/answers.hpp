#pragma once

#include "reference/compare/models/blanks.hpp"

/// Results of each model for a case: one function per model, in a file with its name.
namespace tdbd::reference {

Findings answer_of_tdbd(const Question& q);
/// For bits on strings, if the model has equations of motion.
Findings answer_of_free_langeveld(const Question& q);
Findings answer_of_free_hanson_hansen(const Question& q);
Findings answer_of_free_hanson_hansen_cones(const Question& q);  ///< for bits with cones

Findings answer_of_warren_sinor(const Question& q);
Findings answer_of_behr(const Question& q);
Findings answer_of_langeveld(const Question& q);
Findings answer_of_hanson_hansen(const Question& q);
Findings answer_of_hanson_hansen_cones(const Question& q);  ///< for bits with cones
Findings answer_of_glowka(const Question& q);
Findings answer_of_briggs(const Question& q);
Findings answer_of_sheppard_lesage(const Question& q);
Findings answer_of_ma_azar(const Question& q);
Findings answer_of_ma_zhou_deng(const Question& q);
Findings answer_of_huang_cawthorne_1(const Question& q);
Findings answer_of_huang_cawthorne_2(const Question& q);
Findings answer_of_winters(const Question& q);

}  // namespace tdbd::reference
