#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/compare/compare_case.hpp"
#include "reference/compare/findings.hpp"

namespace tdbd::reference {

/// The bits that a model knows.
enum class Knows { drag_bits, roller_bits, both };

/// What is asked of a model beside the case.
struct Question {
  const CompareCase& asked;
  double weight = 0.0;  ///< N, the reference weight; 0: not known
};

/// A model of chapter 2, or ours.
struct Model {
  std::string_view name;       ///< "warren-sinor"
  std::string_view title;      ///< "Warren and Sinor"
  std::string_view reference;  ///< its number in the thesis
  Knows knows = Knows::both;
  Findings (*answer)(const Question&) = nullptr;
  Findings (*free)(const Question&) = nullptr;  ///< of a bit on a string; none: its motion is input
  std::string_view own_law = {};                ///< of faces, which it knows beside "detournay"
};

/// All models: ours first, which gives the others their weight, then those of drag bits.
std::span<const Model> models();

/// Why a model has nothing to say about this bit; empty: it has.
std::string why_not(const Model& model, const CompareCase& c);

/// The models of a list of names; "all": those that know the bit. Throws InputError for a name that
/// no model has, or a model that does not know the bit, with its name and what it needs.
std::vector<const Model*> chosen_models(const CompareCase& c,
                                        const std::vector<std::string>& names);

}  // namespace tdbd::reference
