#include <fmt/format.h>

#include <algorithm>

#include "bit/areas/area_rules.hpp"
#include "bit/files/bit_file.hpp"
#include "calibration/case/calibration_case.hpp"
#include "core/config/config.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::calibration {
namespace {

using forces::LawField;

/// Records a mistake unless the start value, such as "18 deg", is inside the range: at a bound, a
/// coefficient could not change.
void check_start(Config& table, const Unknown& u) {
  const bool inside = u.start > u.range.lo && u.start < u.range.hi;
  if (!inside)
    table.problem("start", fmt::format("{:.6g}", u.start),
                  fmt::format("a value between {:.6g} and {:.6g}", u.range.lo, u.range.hi));
}

Range range_of(Config& table, const UnknownSettings& s, const LawField& field) {
  if (!table.has("range")) return field.range;
  const std::vector<double>& given = s.range;
  if (given.size() == 2 && given[0] < given[1] && given[0] >= field.range.lo &&
      given[1] <= field.range.hi)
    return Range::within(given[0], given[1]);
  table.problem("range", fmt::format("[{:.6g}]", fmt::join(given, ", ")),
                fmt::format("[lowest, highest], rising, within {:.6g} and {:.6g}", field.range.lo,
                            field.range.hi));
  return field.range;
}

/// A bit of the calibration. It has no parts if its file contains mistakes, which are recorded.
struct NamedBit {
  std::string name;
  bit::Bit bit;
};

std::vector<NamedBit> read_bits(Config& c, const std::vector<Tool>& tools) {
  std::vector<NamedBit> bits;
  for (const Tool& tool : tools) {
    if (tool.kind != ToolKind::bit || tool.bit_file.empty()) continue;
    try {
      bits.push_back({tool.name, bit::read_bit(tool.bit_file, {}, {}).bit});
    } catch (const InputError& e) {
      c.other_file(e.what());
    }
  }
  return bits;
}

/// Reads the coefficients that an area sets, and its unknowns.
CoefficientArea read_area(bit::AreaTable& table, int index, forces::Law law, AreaValues values,
                          std::vector<Unknown>& unknowns) {
  CoefficientArea area{table.rule.name, table.rule.selector, {}};
  Config given = table.config.table(values == AreaValues::truth ? "truth" : "fixed");
  Config fitted = table.config.table("unknowns");
  const std::vector<LawField> fields = forces::law_fields(law);
  refuse_strangers(given, fields, forces::law_name(law));
  if (values == AreaValues::fitted) refuse_strangers(fitted, fields, forces::law_name(law));
  for (const LawField& f : fields) {
    std::optional<double>& value = area.values.emplace_back();
    if (given.has(f.key)) value = given.read(simulation::key_of(f), std::nullopt);
    if (values == AreaValues::truth || !fitted.has(f.key)) continue;
    if (value)
      given.problem(f.key, "a value for what is fitted", "it here or in unknowns, not in both");
    unknowns.push_back(read_unknown(fitted.table(f.key), f));
    unknowns.back().key = fmt::format("areas.{}.{}", area.name, f.key);
    unknowns.back().area = index;
    value = unknowns.back().start;
  }
  if (given.given().empty() && fitted.given().empty())
    table.config.problem("", "no coefficient",
                         values == AreaValues::truth
                             ? "coefficients of the law in its table truth"
                             : "coefficients of the law in its tables unknowns or fixed");
  return area;
}

bool has_law(const bit::Part& part) {
  return part.cutter >= 0 && part.kind != bit::PartKind::cutter_body;
}

/// Returns the kinds of the parts in an area that use the law.
std::vector<bit::PartKind> kinds_of(const bit::AreaSelector& selector,
                                    const std::vector<NamedBit>& bits) {
  std::vector<bit::PartKind> kinds;
  for (const bit::PartKind kind : bit::part_kinds)
    if (std::ranges::any_of(bits, [&](const NamedBit& b) {
          return std::ranges::any_of(b.bit.parts, [&](const bit::Part& part) {
            return part.kind == kind && has_law(part) && bit::selects(selector, b.bit, part);
          });
        }))
      kinds.push_back(kind);
  return kinds;
}

/// Finds the kinds of the parts in each area. Records areas without parts as mistakes.
void find_kinds(bit::Areas& tables, const std::vector<NamedBit>& bits,
                std::vector<CoefficientArea>& areas) {
  std::string names;
  for (const NamedBit& b : bits) names += (names.empty() ? "" : ", ") + b.name;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    areas[i].kinds = kinds_of(areas[i].selector, bits);
    if (areas[i].kinds.empty() && bit::rank_of(areas[i].selector) > 0)
      tables.tables[i].config.problem(
          "", "criteria that no face, chamfer or cse of a cutter meets",
          names.empty() ? "bits, in [bits]" : "such a part of one of the bits: " + names);
  }
}

/// Returns the area that determines each field of each part: per field, then per part.
std::vector<std::vector<int>> decided_of(bit::Areas& areas, const bit::Bit& bit, forces::Law law,
                                         const AreaLaws& read,
                                         const std::vector<Unknown>& unknowns) {
  std::vector<std::vector<int>> decided;
  const std::vector<LawField> fields = forces::law_fields(law);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    std::vector<std::optional<double>> values(read.areas.size());
    std::vector<std::string> shown(read.areas.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = read.areas[i].values[k];
      if (values[i]) shown[i] = fmt::format("{:g}", *values[i]);
      for (std::size_t u = 0; u < unknowns.size(); ++u)
        if (unknowns[u].area == static_cast<int>(i) && law_key(unknowns[u]) == fields[k].key) {
          constexpr double beyond_any_value = 1e300;
          values[i] = beyond_any_value * (1.0 + 1e-3 * static_cast<double>(u));
          shown[i] = "an unknown";
        }
    }
    decided.push_back(bit::decide_or_report(areas, bit, fields[k].key, values, shown));
  }
  return decided;
}

int index_of_mix(const std::vector<int>& mix, std::vector<std::vector<int>>& mixes) {
  const auto it = std::ranges::find(mixes, mix);
  if (it != mixes.end()) return static_cast<int>(it - mixes.begin());
  mixes.push_back(mix);
  return static_cast<int>(mixes.size()) - 1;
}

std::string selector_toml(const bit::AreaSelector& s) {
  std::string text;
  const auto add_text = [&](const char* key, const std::optional<std::string>& value) {
    if (value) text += fmt::format("{} = {}\n", key, toml_string(*value));
  };
  const auto add_number = [&](const char* key, const std::optional<int>& value) {
    if (value) text += fmt::format("{} = {}\n", key, *value);
  };
  if (s.kind) add_text("kind", bit::kind_name(*s.kind));
  add_text("zone", s.zone);
  add_number("blade", s.blade);
  add_number("cone", s.cone);
  add_number("row", s.row);
  add_text("names", s.names);
  add_text("part", s.part);
  return text;
}

/// Whether another area that includes the kind, and therefore takes precedence, has these criteria
/// and sets the field.
bool is_given_by_another(const std::vector<CoefficientArea>& areas, const CoefficientArea& area,
                         const std::string& criteria, std::size_t field) {
  return !area.selector.kind && std::ranges::any_of(areas, [&](const CoefficientArea& other) {
    return other.selector.kind && other.values[field] && selector_toml(other.selector) == criteria;
  });
}

}  // namespace

Unknown read_unknown(Config table, const LawField& field) {
  Unknown u;
  u.key = u.coefficient = field.key;
  u.place = table.place("");
  UnknownSettings s;
  read_fields(table, s, field.unit);
  u.range = range_of(table, s, field);
  u.start = s.start;
  u.prior_sd = s.prior_sd;
  check_start(table, u);
  return u;
}

void refuse_strangers(Config& table, const std::vector<forces::LawField>& fields,
                      std::string_view law) {
  std::vector<std::string> names;
  names.reserve(fields.size());
  for (const LawField& f : fields) names.emplace_back(f.key);
  for (const std::string& given : table.given()) {
    if (std::ranges::find(names, given) != names.end()) continue;
    const auto near = nearest_name(given, names);
    table.problem(
        given, "no coefficient of " + std::string(law),
        near ? fmt::format("{}?", *near) : fmt::format("one of {}", fmt::join(names, ", ")));
  }
}

std::vector<Unknown> read_unknowns(Config& c, forces::Law& law) {
  Config unknowns = c.table("unknowns"), fixed = c.table("fixed");
  const std::vector<LawField> fields = forces::law_fields(law);
  refuse_strangers(unknowns, fields, forces::law_name(law));
  refuse_strangers(fixed, fields, forces::law_name(law));
  std::vector<Unknown> read;
  for (const LawField& f : fields) {
    if (unknowns.has(f.key)) {
      if (fixed.has(f.key))
        fixed.problem(f.key, "a value for what is fitted", "it here or in [unknowns], not in both");
      read.push_back(read_unknown(unknowns.table(f.key), f));
      *f.value = read.back().start;
    } else {
      *f.value = fixed.read(simulation::key_of(f), f.fallback);
    }
  }
  return read;
}

AreaLaws read_area_laws(Config& c, const forces::Law& law, const std::vector<Tool>& tools,
                        AreaValues values, std::vector<Unknown>& unknowns) {
  AreaLaws read;
  if (!c.has("areas")) return read;
  bit::Areas areas = bit::read_areas(c.table("areas"), bit::Bit{}, "the bits");
  for (std::size_t i = 0; i < areas.tables.size(); ++i)
    read.areas.push_back(read_area(areas.tables[i], static_cast<int>(i), law, values, unknowns));
  const std::vector<NamedBit> bits = read_bits(c, tools);
  find_kinds(areas, bits, read.areas);
  forces::Law copy = law;
  read.mixes.emplace_back(forces::law_fields(copy).size(), -1);
  for (const NamedBit& b : bits) {
    areas.of_parts = bit::rules_of_parts(b.bit, areas.rules);
    const std::vector<std::vector<int>> decided = decided_of(areas, b.bit, law, read, unknowns);
    std::vector<int>& of_part = read.mix_of_part[b.name];
    for (std::size_t p = 0; p < b.bit.parts.size(); ++p) {
      std::vector<int> mix;
      mix.reserve(decided.size());
      for (const std::vector<int>& of_field : decided) mix.push_back(of_field[p]);
      of_part.push_back(index_of_mix(mix, read.mixes));
    }
  }
  return read;
}

std::vector<int> mix_of_parts(const AreaLaws& areas, const std::string& bit) {
  const auto found = areas.mix_of_part.find(bit);
  return found == areas.mix_of_part.end() ? std::vector<int>{} : found->second;
}

std::vector<forces::Law> laws_of_mixes(const AreaLaws& areas, const forces::Law& whole) {
  std::vector<forces::Law> laws(std::max<std::size_t>(1, areas.mixes.size()), whole);
  for (std::size_t m = 1; m < laws.size(); ++m) {
    const std::vector<LawField> fields = forces::law_fields(laws[m]);
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (const int a = areas.mixes[m][k]; a >= 0) *fields[k].value = *areas.areas[at(a)].values[k];
  }
  return laws;
}

std::string areas_toml(const AreaLaws& areas, const forces::Law& law) {
  forces::Law copy = law;
  const std::vector<LawField> fields = forces::law_fields(copy);
  std::string text;
  for (const CoefficientArea& area : areas.areas)
    for (const bit::PartKind kind : area.kinds) {
      bit::AreaSelector selector = area.selector;
      selector.kind = kind;
      const std::string criteria = selector_toml(selector);
      std::string values;
      for (std::size_t k = 0; k < fields.size(); ++k)
        if (area.values[k] && forces::acts_on(fields[k], kind) &&
            !is_given_by_another(areas.areas, area, criteria, k))
          values += fmt::format("{} = {}{}\n", fields[k].key, *area.values[k],
                                fields[k].unit == "1" ? "" : fmt::format("  # {}", fields[k].unit));
      if (!values.empty())
        text += fmt::format("\n[forces.areas.{}-{}]\n{}{}", area.name, bit::kind_name(kind),
                            criteria, values);
    }
  return text;
}

}  // namespace tdbd::calibration
