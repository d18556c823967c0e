#pragma once

#include "reference/compare/models/blanks.hpp"

/// Results of each model for a case: one function per model, in a file with its name.
namespace tdbd::reference {

Findings run_tdbd_model(const Question& q);
/// For bits on strings, if the model has equations of motion.
Findings run_free_langeveld_model(const Question& q);
Findings run_free_hanson_hansen_model(const Question& q);
Findings run_free_hanson_hansen_cones_model(const Question& q);  ///< for bits with cones

Findings run_warren_sinor_model(const Question& q);
Findings run_behr_model(const Question& q);
Findings run_langeveld_model(const Question& q);
Findings run_hanson_hansen_model(const Question& q);
Findings run_hanson_hansen_cones_model(const Question& q);  ///< for bits with cones
Findings run_glowka_model(const Question& q);
Findings run_briggs_model(const Question& q);
Findings run_sheppard_lesage_model(const Question& q);
Findings run_ma_azar_model(const Question& q);
Findings run_ma_zhou_deng_model(const Question& q);
Findings run_huang_cawthorne_1_model(const Question& q);
Findings run_huang_cawthorne_2_model(const Question& q);
Findings run_winters_model(const Question& q);

}  // namespace tdbd::reference
