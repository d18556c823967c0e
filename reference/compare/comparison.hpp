#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/compare/model.hpp"

namespace tdbd::reference {

/// One model and its results.
struct Answer {
  const Model* model = nullptr;
  Findings findings;
};

/// The results of all chosen models for one case, in the order of models().
struct Comparison {
  std::vector<Answer> answers;
  double weight = 0.0;                       ///< N, the reference weight; 0: none was found
  std::string weight_from;                   ///< the case, or the model that computed it
  std::vector<std::string> excluded_models;  ///< reasons why other models have no results
};

/// Runs one model and measures its CPU time. Throws InputError that begins with the model's name.
Findings findings_of(const Model& m, const Question& q);

/// What happens if a model refuses the case: the comparison stops, or continues without it.
enum class Refusal { stops, is_noted };

/// Runs the models one after the other and measures each by the CPU time of this process. If the
/// case does not define the reference weight, it is that of the first model that computes a weight.
/// `progress` is called with each model before it runs. A refusal is an InputError that begins with
/// the model's name. Throws RunError naming the model if a quantity has neither a value nor a
/// reason.
Comparison compare(const CompareCase& c, const std::vector<const Model*>& chosen, Refusal refusal,
                   const std::function<void(const Model&)>& progress);

}  // namespace tdbd::reference
