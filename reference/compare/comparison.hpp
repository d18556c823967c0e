#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/compare/model.hpp"

namespace tdbd::reference {

/// One model and what it said.
struct Answer {
  const Model* model = nullptr;
  Findings findings;
};

/// What all chosen models say about one case, in the order of models().
struct Comparison {
  std::vector<Answer> answers;
  double weight = 0.0;                 ///< N, the reference weight; 0: none was found
  std::string weight_from;             ///< the case, or the model that gave it
  std::vector<std::string> not_asked;  ///< why other models have nothing to say
};

/// What one model says, with its CPU time. Throws InputError that begins with its name.
Findings findings_of(const Model& m, const Question& q);

/// What becomes of a model that refuses the case: the comparison stops, or goes on without it.
enum class Refusal { stops, is_noted };

/// Asks the models, one after the other, each measured by the CPU time of this process. The first
/// that says a weight gives the reference weight, unless the case does.
/// `progress` is told each model's title before it runs. A refusal is an InputError that begins with the model's name.
/// Throws RunError naming a model that leaves
/// a quantity without a number and without a reason.
Comparison compare(const CompareCase& c, const std::vector<const Model*>& chosen, Refusal refusal,
                   const std::function<void(const Model&)>& progress);

}  // namespace tdbd::reference
