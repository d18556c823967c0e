#include "reference/compare/comparison.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "reference/compare/cpu_clock.hpp"

namespace tdbd::reference {
namespace {

void check_complete(const Answer& a) {
  for (std::size_t i = 0; i < quantity_count; ++i)
    if (const QuantityResult& s = a.findings.says[i]; s.value.has_value() == !s.reason.empty())
      throw RunError(fmt::format("{}: {}: neither a number nor a reason", a.model->title,
                                 quantity_texts()[i].name));
}

void take_weight(const Answer& a, Comparison& all) {
  if (all.weight > 0.0) return;
  if (const auto& weight = saying(a.findings, Quantity::weight).value; weight && *weight > 0.0) {
    all.weight = *weight;
    all.weight_from = a.model->title;
  }
}

}  // namespace

Findings findings_of(const Model& m, const Question& q) {
  const CpuClock clock;
  Findings f = is_free(q.asked) ? m.free(q) : m.answer(q);
  if (!is_free(q.asked))
    set_missing(f, {Quantity::rate_of_penetration, Quantity::whirl_radius},
                "given: the case moves the bit");
  if (f.cost.cpu == 0.0) f.cost.cpu = clock.seconds();
  return f;
}

Comparison compare(const CompareCase& c, const std::vector<const Model*>& chosen, Refusal refusal,
                   const std::function<void(const Model&)>& progress) {
  Comparison all;
  if (c.options.weight_on_bit) {
    all.weight = *c.options.weight_on_bit;
    all.weight_from = "the case";
  }
  for (const Model* m : chosen) {
    if (progress) progress(*m);
    try {
      all.answers.push_back({m, findings_of(*m, {c, all.weight})});
    } catch (const InputError& e) {
      if (refusal == Refusal::stops) throw;
      all.excluded_models.emplace_back(e.what());
      continue;
    }
    check_complete(all.answers.back());
    take_weight(all.answers.back(), all);
  }
  for (const Model& m : models())
    if (const std::string why = exclusion_reason(m, c); !why.empty())
      all.excluded_models.push_back(why);
  return all;
}

}  // namespace tdbd::reference
