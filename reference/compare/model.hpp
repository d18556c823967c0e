#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/compare/compare_case.hpp"
#include "reference/compare/findings.hpp"

namespace tdbd::reference {

/// The kinds of bits that a model can handle.
enum class SupportedBits { drag_bits, roller_bits, both };

/// Input of a model.
struct Question {
  const CompareCase& asked;
  double weight = 0.0;  ///< N, the reference weight; 0: not known
};

/// A model of thesis chapter 2, or TDBD.
struct Model {
  std::string_view name;       ///< "warren-sinor"
  std::string_view title;      ///< "Warren and Sinor"
  std::string_view reference;  ///< its number in the references of the thesis
  SupportedBits knows = SupportedBits::both;
  Findings (*answer)(const Question&) = nullptr;
  Findings (*free)(const Question&) = nullptr;  ///< for a bit on a string; null: motion is input
  std::string_view own_law = {};                ///< law of faces besides "detournay"
};

/// All models: TDBD first, whose weight is the reference weight, then those of drag bits.
std::span<const Model> models();

/// The reason why a model has no results for this bit; empty if it has results.
std::string exclusion_reason(const Model& model, const CompareCase& c);

/// The models in a list of names; "all": those that can handle the bit. Throws InputError for an
/// unknown name, or for a model that cannot handle the bit, with its name and what it requires.
std::vector<const Model*> chosen_models(const CompareCase& c,
                                        const std::vector<std::string>& names);

}  // namespace tdbd::reference
