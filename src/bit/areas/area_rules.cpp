#include "bit/areas/area_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/text.hpp"

namespace tdbd::bit {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool is_of_gage_row(const Bit& bit, const Part& part) {
  if (part.cone < 0 || part.row < 0) return false;
  const std::vector<ToothRow>& rows = bit.cones[at(part.cone)].layout.rows;
  return at(part.row) < rows.size() && rows[at(part.row)].place == RowPlace::gage;
}

/// Whether a criterion is absent or equal to the part's own value.
template <class T>
bool meets(const std::optional<T>& criterion, const T& own) {
  return !criterion || *criterion == own;
}

/// Adds a pair of rules unless it is already there.
void add_disagreement(int first, int second, int part, std::vector<Disagreement>& all) {
  const auto same = [&](const Disagreement& d) { return d.first == first && d.second == second; };
  if (std::ranges::none_of(all, same)) all.push_back({first, second, part});
}

}  // namespace

std::string zone_of(const Bit& bit, const Part& part) {
  if (part.cutter >= 0) return bit.cutters[at(part.cutter)].zone;
  return part.kind == PartKind::gage_pad || is_of_gage_row(bit, part) ? "gage" : "";
}

bool selects(const AreaSelector& s, const Bit& bit, const Part& part) {
  if (!meets(s.kind, part.kind) || !meets(s.cone, part.cone + 1) || !meets(s.row, part.row + 1))
    return false;
  if (s.blade && (part.cutter < 0 || bit.cutters[at(part.cutter)].blade != *s.blade)) return false;
  if (s.zone && (s.zone->empty() || zone_of(bit, part) != *s.zone)) return false;
  return meets(s.part, part.name) && (!s.names || fits(*s.names, part.name));
}

int rank_of(const AreaSelector& s) {
  int rank = 0, weight = 1;
  for (const bool given :
       {s.kind.has_value(), s.zone.has_value(), s.blade.has_value(), s.cone.has_value(),
        s.row.has_value(), s.names.has_value(), s.part.has_value()}) {
    rank += given ? weight : 0;
    weight *= 2;
  }
  return rank;
}

RulesOfParts rules_of_parts(const Bit& bit, std::span<const AreaRule> rules) {
  std::vector<int> by_rank(rules.size());
  for (std::size_t i = 0; i < rules.size(); ++i) by_rank[i] = static_cast<int>(i);
  std::ranges::stable_sort(by_rank, {}, [&](int i) { return rank_of(rules[at(i)].selector); });
  RulesOfParts of_parts(bit.parts.size());
  for (std::size_t p = 0; p < bit.parts.size(); ++p)
    for (const int i : by_rank)
      if (selects(rules[at(i)].selector, bit, bit.parts[p])) of_parts[p].push_back(i);
  return of_parts;
}

Decision decide(const RulesOfParts& of_parts, std::span<const AreaRule> rules,
                std::span<const std::optional<double>> values) {
  Decision d;
  d.rule.assign(of_parts.size(), -1);
  for (std::size_t p = 0; p < of_parts.size(); ++p) {
    int& best = d.rule[p];
    for (const int i : of_parts[p]) {
      if (!values[at(i)]) continue;
      const bool ties =
          best >= 0 && rank_of(rules[at(i)].selector) == rank_of(rules[at(best)].selector);
      if (!ties) best = i;
    }
    for (const int i : of_parts[p])
      if (values[at(i)] && rank_of(rules[at(i)].selector) == rank_of(rules[at(best)].selector) &&
          *values[at(i)] != *values[at(best)])
        add_disagreement(best, i, static_cast<int>(p), d.disagreements);
  }
  return d;
}

namespace {

bool is_area_name(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
}

/// Formats a selector: "kind = tooth, zone = nose".
std::string in_words(const AreaSelector& s) {
  std::string words;
  const auto add = [&words](std::string_view key, const std::string& value) {
    words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", key, value);
  };
  if (s.kind) add("kind", kind_name(*s.kind));
  if (s.zone) add("zone", '"' + *s.zone + '"');
  if (s.blade) add("blade", std::to_string(*s.blade));
  if (s.cone) add("cone", std::to_string(*s.cone));
  if (s.row) add("row", std::to_string(*s.row));
  if (s.names) add("names", '"' + *s.names + '"');
  if (s.part) add("part", '"' + *s.part + '"');
  return words;
}

/// Joins up to ten values with commas.
std::string joined(const std::set<std::string>& values) {
  constexpr std::size_t most = 10;
  std::string text;
  std::size_t count = 0;
  for (const std::string& value : values) {
    if (++count > most) return text + ", ...";
    text += (text.empty() ? "" : ", ") + value;
  }
  return text;
}

std::vector<std::string> part_names(const Bit& bit) {
  std::vector<std::string> names;
  names.reserve(bit.parts.size());
  for (const Part& part : bit.parts) names.push_back(part.name);
  return names;
}

/// The values that the bit has for the most specific criterion that no part meets on its own. If
/// there is no such criterion, the criteria contradict one another.
std::string expected_of(const AreaSelector& s, const Bit& bit) {
  const auto none = [&](const AreaSelector& only) {
    return std::ranges::none_of(bit.parts,
                                [&](const Part& part) { return selects(only, bit, part); });
  };
  std::set<std::string> kinds, zones, blades;
  for (const Part& part : bit.parts) {
    kinds.insert(kind_name(part.kind));
    if (const std::string zone = zone_of(bit, part); !zone.empty()) zones.insert(zone);
    if (part.cutter >= 0)
      blades.insert(std::to_string(bit.cutters[static_cast<std::size_t>(part.cutter)].blade));
  }
  if (s.part && none({.part = s.part})) {
    const auto nearest = nearest_name(*s.part, part_names(bit));
    return nearest ? *nearest : "the name of a part, as bit.json lists them";
  }
  if (s.names && none({.names = s.names})) return "a pattern of part names, as bit.json lists them";
  if (s.row && none({.row = s.row})) return "a row of a cone of the bit";
  if (s.cone && none({.cone = s.cone}))
    return bit.cones.empty() ? "no cone: the bit has none"
                             : fmt::format("at most {}", bit.cones.size());
  if (s.blade && none({.blade = s.blade}))
    return blades.empty() ? "no blade: the bit has none" : "one of its blades: " + joined(blades);
  if (s.zone && none({.zone = s.zone}))
    return zones.empty() ? "no zone: the bit has none" : "one of its zones: " + joined(zones);
  if (s.kind && none({.kind = s.kind})) return "one of its kinds of part: " + joined(kinds);
  return "criteria that one part meets together";
}

void check_selector(Config& c, const AreaSelector& s, const Bit& bit, const std::string& where) {
  if (rank_of(s) == 0) {
    c.problem("", "no parts selected",
              "at least one of kind, zone, blade, cone, row, names and part");
    return;
  }
  if (bit.parts.empty() ||
      std::ranges::any_of(bit.parts, [&](const Part& part) { return selects(s, bit, part); }))
    return;
  c.problem("", fmt::format("{}, which no part of {} meets", in_words(s), where),
            expected_of(s, bit));
}

}  // namespace

Areas read_areas(Config areas, const Bit& bit, const std::string& where) {
  Areas read;
  std::set<int> wrong;
  for (const std::string& name : areas.given()) {
    if (!is_area_name(name)) {
      areas.problem("", fmt::format("an area named \"{}\"", name),
                    "names of letters, digits, - and _");
      continue;
    }
    const std::size_t before = areas.problem_count();
    Config c = areas.table(name);
    AreaTable table{{name, c.place(""), {}}, c};
    read_fields(c, table.rule.selector);
    if (c.problem_count() == before) check_selector(c, table.rule.selector, bit, where);
    if (c.problem_count() != before) wrong.insert(static_cast<int>(read.rules.size()));
    read.rules.push_back(table.rule);
    read.tables.push_back(std::move(table));
  }
  read.of_parts = rules_of_parts(bit, read.rules);
  for (std::vector<int>& rules : read.of_parts)
    std::erase_if(rules, [&](int rule) { return wrong.contains(rule); });
  return read;
}

std::vector<int> parts_of_rule(const Areas& areas, int rule) {
  std::vector<int> parts;
  for (std::size_t p = 0; p < areas.of_parts.size(); ++p)
    if (std::ranges::find(areas.of_parts[p], rule) != areas.of_parts[p].end())
      parts.push_back(static_cast<int>(p));
  return parts;
}

std::vector<int> decide_or_report(Areas& areas, const Bit& bit, std::string_view key,
                                  std::span<const std::optional<double>> values,
                                  const std::vector<std::string>& shown) {
  const Decision decision = decide(areas.of_parts, areas.rules, values);
  for (const Disagreement& d : decision.disagreements) {
    const auto first = static_cast<std::size_t>(d.first),
               second = static_cast<std::size_t>(d.second);
    areas.tables[second].config.problem(
        key,
        fmt::format("{} for {}", shown[second], bit.parts[static_cast<std::size_t>(d.part)].name),
        fmt::format(
            "{}, as {} gives with the same criteria, or a more particular area that decides",
            shown[first], areas.rules[first].place));
  }
  return decision.rule;
}

}  // namespace tdbd::bit
