#include "simulation/case/case_areas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "bit/areas/read_areas.hpp"
#include "simulation/case/force_keys.hpp"
#include "simulation/case/idle_coefficients.hpp"
#include "simulation/case/read_law.hpp"

namespace tdbd::simulation {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// What an area gives.
struct GivenLaw {
  std::optional<forces::Law> law;              ///< none: coefficients alone
  std::optional<forces::Law> fit;              ///< of the key `coefficients`
  std::map<std::string, double> coefficients;  ///< SI; of a law all
};

double diameter_of(const bit::Bit& bit, const bit::Part& part) {
  return part.cutter < 0 ? 0.0 : bit.cutters[at(part.cutter)].diameter;
}

/// A law must know the kinds of all parts of its area.
void require_known(Config& c, const bit::Bit& bit, const std::vector<int>& parts,
                   const forces::Law& law, const std::string& where) {
  for (const int p : parts) {
    const bit::Part& part = bit.parts[at(p)];
    const std::string wrong = forces::law_problem(law, part.kind, diameter_of(bit, part));
    if (wrong.empty()) continue;
    return c.problem(force_keys::area_law,
                     fmt::format("\"{}\" for {} of {}", forces::law_name(law), part.name, where),
                     fmt::format("a law for a {}, or criteria without it: {}",
                                 bit::kind_words(part.kind), wrong));
  }
}

/// The laws of areas that name one.
std::vector<GivenLaw> read_named_laws(bit::Areas& areas, const bit::Bit& bit,
                                      const std::string& where) {
  std::vector<GivenLaw> given(areas.tables.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    Config& c = areas.tables[i].config;
    if (!c.has(force_keys::area_law) && !c.has(force_keys::coefficients)) continue;
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

/// The area whose law each part has; -1: the law of its kind holds.
std::vector<int> decide_laws(bit::Areas& areas, const bit::Bit& bit,
                             const std::vector<GivenLaw>& given) {
  std::vector<std::optional<double>> values(given.size());
  std::vector<std::string> shown(given.size());
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i].law) {
      values[i] = static_cast<double>(given[i].law->index());
      shown[i] = fmt::format("\"{}\"", forces::law_name(*given[i].law));
    }
  return bit::decide_or_report(areas, bit, force_keys::area_law, values, shown);
}

/// The parts of an area without a law on whose laws its coefficients act: a more particular area
/// with a law replaces them.
std::vector<int> changed_parts(const bit::Areas& areas, int area,
                               const std::vector<int>& law_area) {
  std::vector<int> parts = bit::parts_of_rule(areas, area);
  const int rank = bit::rank_of(areas.rules[at(area)].selector);
  std::erase_if(parts, [&](int p) {
    return law_area[at(p)] >= 0 && bit::rank_of(areas.rules[at(law_area[at(p)])].selector) > rank;
  });
  return parts;
}

/// Reads coefficients whose law is not known because of another mistake: they are no unknown keys.
void read_unchecked(Config& c) {
  for (const std::string_view name : forces::law_names()) {
    forces::Law law = forces::law_named(name);
    for (const forces::LawField& f : forces::law_fields(law))
      if (c.has(f.key)) c.word(f.key, std::nullopt);
  }
}

/// The coefficients of an area that names no law.
void read_changes(Config& c, const std::vector<int>& parts, const ForcePlan& plan,
                  GivenLaw& given) {
  std::set<std::string> names;
  for (const int p : parts) names.insert(std::string(forces::law_name(plan.part_laws[at(p)])));
  if (names.size() != 1) read_unchecked(c);
  if (names.size() > 1) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return c.problem(force_keys::area_law, fmt::format("none, and parts of several laws: {}", all),
                     "a law, or criteria that select parts of one law");
  }
  if (names.empty())
    return c.problem("", "coefficients of parts whose laws all come from more particular areas",
                     "a law, or the coefficients in those areas");
  forces::Law law = plan.part_laws[at(parts.front())];
  for (const forces::LawField& f : forces::law_fields(law))
    if (c.has(f.key))
      given.coefficients[std::string(f.key)] = c.read(force_keys::key_of(f), std::nullopt);
  if (given.coefficients.empty())
    c.problem("", "neither a law nor a coefficient of the law of its parts, " + *names.begin(),
              "law, coefficients, or a coefficient");
}

/// Every coefficient of every part that an area gives, from the area that decides.
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

void read_force_areas(Config& forces, const bit::Bit& bit, const std::string& where,
                      ForcePlan& plan, std::vector<CaseWarning>& warnings) {
  if (!forces.has(force_keys::areas.name)) return;
  bit::Areas areas = bit::read_areas(forces.table(force_keys::areas.name), bit, where);
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
