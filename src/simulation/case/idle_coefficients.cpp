#include "simulation/case/idle_coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

namespace tdbd::simulation {
namespace {

using bit::PartKind;

bool has_part(const bit::Bit& bit, PartKind kind) {
  return std::ranges::any_of(bit.parts, [&](const bit::Part& p) { return p.kind == kind; });
}

std::string words(const std::vector<PartKind>& kinds, std::string_view between) {
  std::string all;
  for (const PartKind kind : kinds)
    all += fmt::format("{}{}", all.empty() ? "" : between, bit::kind_words(kind));
  return all;
}

/// Those of the kinds on which the coefficient acts.
std::vector<PartKind> where(const forces::LawField& field, std::span<const PartKind> kinds) {
  std::vector<PartKind> found;
  std::ranges::copy_if(kinds, std::back_inserter(found),
                       [&](PartKind kind) { return forces::acts_on(field, kind); });
  return found;
}

/// Why no part feels it; empty: one does.
std::string reason(const forces::LawField& field, const LawTable& t, const bit::Bit& bit) {
  const std::vector<PartKind> kinds = where(field, t.followers);
  if (std::ranges::any_of(kinds, [&](PartKind kind) { return has_part(bit, kind); })) return {};
  if (!kinds.empty()) return fmt::format("it has no {}", words(kinds, " or "));
  return fmt::format("another law for {}", words(where(field, bit::part_kinds), ", "));
}

/// The value that the coefficient has when the table does not give it; none: it is required.
std::optional<double> usual_value(LawTable& t, std::size_t coefficient) {
  if (t.fit) return *forces::law_fields(*t.fit)[coefficient].value;
  return forces::law_fields(t.law)[coefficient].fallback;
}

}  // namespace

std::vector<CaseWarning> idle_coefficients(const Config& table, LawTable t, const bit::Bit& bit) {
  std::vector<CaseWarning> warnings;
  const std::vector<forces::LawField> fields = forces::law_fields(t.law);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::optional<double> usual = usual_value(t, k);
    if (!table.has(fields[k].key) || !usual || *fields[k].value == *usual) continue;
    const std::string why = reason(fields[k], t, bit);
    if (!why.empty())
      warnings.push_back({table.place(fields[k].key), fmt::format("{}.{}", t.name, fields[k].key),
                          fmt::format("acts on no part of {} ({}); leave it out", bit.name, why)});
  }
  return warnings;
}

}  // namespace tdbd::simulation
