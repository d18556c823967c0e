#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/error.hpp"
#include "reference/compare/comparison.hpp"

/// Runs one model on a case of cases/compare and reads its findings.
namespace tdbd::reference::model_runs {

inline CompareCase compare_case(const std::string& name,
                                const std::vector<std::string>& overrides) {
  return read_compare_case(TDBD_SOURCE_DIR "/cases/compare/" + name + ".toml", overrides);
}

/// Each quantity has a value or a reason; no part has two values of one quantity.
inline void expect_complete(const Findings& f, const std::string& model) {
  for (std::size_t i = 0; i < quantity_count; ++i)
    EXPECT_NE(f.says[i].value.has_value(), !f.says[i].reason.empty())
        << model << ": " << quantity_texts()[i].name;
  std::set<std::tuple<std::string, PartQuantity>> named;
  for (const PartFinding& p : f.parts)
    EXPECT_TRUE(named.insert({p.part, p.quantity}).second)
        << model << ": " << p.part << " twice, " << text_of(p.quantity).name;
}

inline Findings run(const CompareCase& c, const std::string& model, double weight) {
  Findings f = findings_of(*chosen_models(c, {model}).front(), {c, weight});
  expect_complete(f, model);
  return f;
}

/// The message with which a model rejects the case.
inline std::string refusal(const CompareCase& c, const std::string& model, double weight) {
  try {
    run(c, model, weight);
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

inline double value(const Findings& f, Quantity q) { return saying(f, q).value.value(); }

/// The values of its parts of a level, in their order.
inline std::vector<double> of_parts(const Findings& f, PartQuantity q, PartLevel level) {
  std::vector<double> values;
  for (const PartFinding& p : f.parts)
    if (p.quantity == q && level_of(p) == level) values.push_back(p.value);
  return values;
}

inline double sum_of_parts(const Findings& f, PartQuantity q, PartLevel level) {
  double sum = 0.0;
  for (const double v : of_parts(f, q, level)) sum += v;
  return sum;
}

}  // namespace tdbd::reference::model_runs
