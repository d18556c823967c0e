
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "bit/areas/area_rules.hpp"
#include "simulation/case/force_settings.hpp"

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

/// Returns those of the kinds on which the coefficient acts.
std::vector<PartKind> where(const forces::LawField& field, std::span<const PartKind> kinds) {
  std::vector<PartKind> found;
  std::ranges::copy_if(kinds, std::back_inserter(found),
                       [&](PartKind kind) { return forces::acts_on(field, kind); });
  return found;
}

/// Why the coefficient acts on no part; empty if it acts on one.
std::string reason(const forces::LawField& field, const LawTable& t, const bit::Bit& bit) {
  const std::vector<PartKind> kinds = where(field, t.followers);
  if (std::ranges::any_of(kinds, [&](PartKind kind) { return has_part(bit, kind); })) return {};
  if (!kinds.empty()) return fmt::format("it has no {}", words(kinds, " or "));
  return fmt::format("another law for {}", words(where(field, bit::part_kinds), ", "));
}

/// The value of the coefficient if the table does not give it; empty if it is required.
std::optional<double> usual_value(LawTable& t, std::size_t coefficient) {
  if (t.fit) return *forces::law_fields(*t.fit)[coefficient].value;
  return forces::law_fields(t.law)[coefficient].fallback;
}

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The law or the coefficients that an area defines.
struct GivenLaw {
  std::optional<forces::Law> law;              ///< empty: only coefficients
  std::optional<forces::Law> fit;              ///< of the key `coefficients`
  std::map<std::string, double> coefficients;  ///< SI; all of a law
};

double diameter_of(const bit::Bit& bit, const bit::Part& part) {
  return part.cutter < 0 ? 0.0 : bit.cutters[at(part.cutter)].diameter;
}

/// Records a mistake if the law does not know the kind of a part of its area.
void require_known(Config& c, const bit::Bit& bit, const std::vector<int>& parts,
                   const forces::Law& law, const std::string& where) {
  for (const int p : parts) {
    const bit::Part& part = bit.parts[at(p)];
    const std::string wrong = forces::law_problem(law, part.kind, diameter_of(bit, part));
    if (wrong.empty()) continue;
    return c.problem("law",
                     fmt::format("\"{}\" for {} of {}", forces::law_name(law), part.name, where),
                     fmt::format("a law for a {}, or criteria without it: {}",
                                 bit::kind_words(part.kind), wrong));
  }
}

/// Reads the laws of areas that name one.
std::vector<GivenLaw> read_named_laws(bit::Areas& areas, const bit::Bit& bit,
                                      const std::string& where) {
  std::vector<GivenLaw> given(areas.tables.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    Config& c = areas.tables[i].config;
    if (!c.has("law") && !c.has("coefficients")) continue;
    const std::size_t before = c.problem_count();
    given[i].fit = read_fit(c);
    given[i].law = read_law(c, "");
    for (const forces::LawField& f : forces::law_fields(*given[i].law))
      given[i].coefficients[std::string(f.key)] = *f.value;
    if (c.problem_count() == before)
      require_known(c, bit, bit::parts_of_rule(areas, static_cast<int>(i)), *given[i].law, where);
  }
  return given;
}

/// Returns the area whose law each part has; -1: the law of its kind.
std::vector<int> decide_laws(bit::Areas& areas, const bit::Bit& bit,
                             const std::vector<GivenLaw>& given) {
  std::vector<std::optional<double>> values(given.size());
  std::vector<std::string> shown(given.size());
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i].law) {
      values[i] = static_cast<double>(given[i].law->index());
      shown[i] = fmt::format("\"{}\"", forces::law_name(*given[i].law));
    }
  return bit::decide_or_report(areas, bit, "law", values, shown);
}

/// Returns the parts of an area without a law on whose laws its coefficients act. The law of a more
/// specific area replaces them.
std::vector<int> changed_parts(const bit::Areas& areas, int area,
                               const std::vector<int>& law_area) {
  std::vector<int> parts = bit::parts_of_rule(areas, area);
  const int rank = bit::rank_of(areas.rules[at(area)].selector);
  std::erase_if(parts, [&](int p) {
    return law_area[at(p)] >= 0 && bit::rank_of(areas.rules[at(law_area[at(p)])].selector) > rank;
  });
  return parts;
}

/// Reads coefficients whose law is unknown because of another mistake, so that they are not
/// reported as unknown keys.
void read_unchecked(Config& c) {
  for (const std::string_view name : forces::law_names()) {
    forces::Law law = forces::law_named(name);
    for (const forces::LawField& f : forces::law_fields(law))
      if (c.has(f.key)) c.word(f.key, std::nullopt);
  }
}

/// Reads the coefficients of an area that names no law.
void read_changes(Config& c, const std::vector<int>& parts, const ForcePlan& plan,
                  GivenLaw& given) {
  std::set<std::string> names;
  for (const int p : parts) names.insert(std::string(forces::law_name(plan.part_laws[at(p)])));
  if (names.size() != 1) read_unchecked(c);
  if (names.size() > 1) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return c.problem("law", fmt::format("none, and parts of several laws: {}", all),
                     "a law, or criteria that select parts of one law");
  }
  if (names.empty())
    return c.problem("", "coefficients of parts whose laws all come from more specific areas",
                     "a law, or the coefficients in those areas");
  forces::Law law = plan.part_laws[at(parts.front())];
  for (const forces::LawField& f : forces::law_fields(law))
    if (c.has(f.key)) given.coefficients[std::string(f.key)] = c.read(key_of(f), std::nullopt);
  if (given.coefficients.empty())
    c.problem("", "neither a law nor a coefficient of the law of its parts, " + *names.begin(),
              "law, coefficients, or a coefficient");
}

/// Sets every coefficient that an area defines for a part, from the area that decides.
void apply_coefficients(bit::Areas& areas, const bit::Bit& bit, const std::vector<GivenLaw>& given,
                        ForcePlan& plan) {
  std::set<std::string> keys;
  for (const GivenLaw& g : given)
    for (const auto& [key, value] : g.coefficients) keys.insert(key);
  for (const std::string& key : keys) {
    std::vector<std::optional<double>> values(given.size());
    std::vector<std::string> shown(given.size());
    for (std::size_t i = 0; i < given.size(); ++i)
      if (const auto found = given[i].coefficients.find(key);
          found != given[i].coefficients.end()) {
        values[i] = found->second;
        shown[i] = fmt::format("{:g}", found->second);
      }
    const std::vector<int> decided = bit::decide_or_report(areas, bit, key, values, shown);
    for (std::size_t p = 0; p < decided.size(); ++p)
      for (const forces::LawField& f : forces::law_fields(plan.part_laws[p]))
        if (decided[p] >= 0 && f.key == key) *f.value = *values[at(decided[p])];
  }
}

std::vector<bit::PartKind> kinds_of(const bit::Bit& bit, const std::vector<int>& parts) {
  std::vector<bit::PartKind> kinds;
  for (const int p : parts) {
    const bit::PartKind kind = bit.parts[at(p)].kind;
    if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
  }
  return kinds;
}

void warn_of_idle(const bit::Areas& areas, const bit::Bit& bit, const std::vector<GivenLaw>& given,
                  std::vector<CaseWarning>& warnings) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i].law) continue;
    const LawTable table{"forces.areas." + areas.rules[i].name, *given[i].law, given[i].fit,
                         kinds_of(bit, bit::parts_of_rule(areas, static_cast<int>(i)))};
    std::ranges::copy(idle_coefficients(areas.tables[i].config, table, bit),
                      std::back_inserter(warnings));
  }
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

void read_force_areas(Config& forces, const bit::Bit& bit, const std::string& where,
                      ForcePlan& plan, std::vector<CaseWarning>& warnings) {
  if (!forces.has("areas")) return;
  bit::Areas areas = bit::read_areas(forces.table("areas"), bit, where);
  if (areas.rules.empty()) return;
  for (const bit::Part& part : bit.parts) plan.part_laws.push_back(law_of(plan, part.kind));
  const std::size_t before = forces.problem_count();
  std::vector<GivenLaw> given = read_named_laws(areas, bit, where);
  const std::vector<int> law_area = decide_laws(areas, bit, given);
  for (std::size_t p = 0; p < law_area.size(); ++p)
    if (law_area[p] >= 0) plan.part_laws[p] = *given[at(law_area[p])].law;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const int area = static_cast<int>(i);
    if (given[i].law) continue;
    if (bit::parts_of_rule(areas, area).empty()) {
      read_unchecked(areas.tables[i].config);
      continue;
    }
    read_changes(areas.tables[i].config, changed_parts(areas, area, law_area), plan, given[i]);
  }
  if (forces.problem_count() == before) apply_coefficients(areas, bit, given, plan);
  for (const std::vector<int>& rules : areas.of_parts) {
    std::vector<std::string>& names = plan.part_areas.emplace_back();
    for (const int rule : rules) names.push_back(areas.rules[at(rule)].name);
  }
  if (forces.problem_count() == 0) warn_of_idle(areas, bit, given, warnings);
}

}  // namespace tdbd::simulation
