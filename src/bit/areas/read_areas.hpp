#pragma once

#include <span>
#include <string>
#include <vector>

#include "bit/areas/area_rules.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// An area of a file and its table, from which the caller reads the properties.
struct AreaTable {
  AreaRule rule;
  Config config;
};

/// The areas of a file, sorted by name, and the parts that they select.
struct Areas {
  std::vector<AreaTable> tables;
  std::vector<AreaRule> rules;  ///< of the tables
  RulesOfParts of_parts;        ///< without the rules that have a mistake
};

/// Reads the tables [areas.NAME] in `areas` (AreaSelector). Records as mistakes, at the area's place:
/// a name that contains anything but letters, digits, - and _; no criterion; criteria that no part
/// of the bit meets. `where`: the name of the bit in messages ("bit-b of cases/bits/bit-b.toml").
/// Nothing is checked for a bit without parts, whose mistakes are recorded elsewhere.
Areas read_areas(Config areas, const Bit& bit, const std::string& where);

/// The indices of the parts that a rule selects, in ascending order.
std::vector<int> parts_of_rule(const Areas& areas, int rule);

/// Decides which area defines a property of each part (decide). If two areas disagree, records a
/// mistake at `key` of the later one that names the place of the other. `values`, `shown`: per
/// area, the value and its text.
std::vector<int> decide_or_report(Areas& areas, const Bit& bit, std::string_view key,
                                  std::span<const std::optional<double>> values,
                                  const std::vector<std::string>& shown);

}  // namespace tdbd::bit
