#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "core/config/field.hpp"

namespace tdbd::bit {

/// Which parts an area may select: those of cones too, or only those of cutters.
enum class Selectable { all, of_cutters };

/// Selects the parts of an area: those that meet every given criterion. The criteria are listed
/// from the most general to the most specific. Thesis: chapter 3, behaviour by area.
struct AreaSelector {
  std::optional<PartKind> kind = {};
  std::optional<std::string> zone = {};   ///< see zone_of
  std::optional<int> blade = {};          ///< Cutter::blade of the part's cutter
  std::optional<int> cone = {};           ///< K of "cone-K/..."
  std::optional<int> row = {};            ///< J of "cone-K/row-J/tooth-I"
  std::optional<std::string> names = {};  ///< pattern of the part's name (core/wildcard.hpp)
  std::optional<std::string> part = {};   ///< name of a single part

  void visit(FieldVisitor& v, Selectable parts = Selectable::all) {
    std::string name_of_kind = kind ? kind_name(*kind) : "";
    v.name(name_of_kind, {.name = "kind",
                          .names = &part_kind_names,
                          .need = Need::optional,
                          .computed_default = "any",
                          .meaning = "the parts of this kind"});
    if (!name_of_kind.empty()) kind = part_kind_named(name_of_kind);
    v(zone, {.name = "zone",
             .computed_default = "any",
             .meaning = "the parts of cutters with this label (cone, nose, shoulder, gage, or that "
                        "of the table); gage: also gage pads and the teeth of gage rows"});
    v(blade, {.name = "blade",
              .computed_default = "any",
              .hi = std::numeric_limits<int>::max(),
              .meaning = "the parts of the cutters on this blade"});
    if (parts == Selectable::all) {
      v(cone, {.name = "cone",
               .computed_default = "any",
               .lo = 1,
               .hi = std::numeric_limits<int>::max() - 1,
               .meaning = "the parts of cone-K"});
      v(row, {.name = "row",
              .computed_default = "any",
              .lo = 1,
              .hi = std::numeric_limits<int>::max() - 1,
              .meaning = "the teeth of row-J, of every cone"});
    }
    v(names,
      {.name = "names",
       .computed_default = "any",
       .meaning = "the parts whose names match: * stands for any text, ? for any character"});
    v(part, {.name = "part", .computed_default = "any", .meaning = "the part of this name"});
  }
};

/// The criteria for parts of cutters alone.
struct CutterAreaSelector {
  AreaSelector selector;

  void visit(FieldVisitor& v) { selector.visit(v, Selectable::of_cutters); }
};

/// An area that defines properties of its parts.
struct AreaRule {
  std::string name;   ///< NAME of [areas.NAME]
  std::string place;  ///< "FILE:LINE: areas.NAME", for messages
  AreaSelector selector;
};

/// The zone of a part: the label of its cutter ("cone", "nose", "shoulder", "gage", or that in the
/// table's own column); "gage" for gage pads and the teeth of gage rows; empty for all others.
std::string zone_of(const Bit& bit, const Part& part);

bool selects(const AreaSelector& selector, const Bit& bit, const Part& part);

/// How specific an area is. Of two areas, the one with the most specific criterion that the other
/// lacks has the higher rank. Areas of equal rank have the same criteria.
int rank_of(const AreaSelector& selector);

/// Per part of the bit, the indices of the rules that select it, in ascending rank. Rules of equal
/// rank keep their order.
using RulesOfParts = std::vector<std::vector<int>>;
RulesOfParts rules_of_parts(const Bit& bit, std::span<const AreaRule> rules);

/// Two rules of equal rank that give a part different values of one property, while no rule of
/// higher rank gives it.
struct Disagreement {
  int first = 0, second = 0;  ///< indices of rules
  int part = 0;               ///< the first part of the bit for which they disagree
};

/// The rules that decide one property.
struct Decision {
  std::vector<int> rule;                    ///< per part; -1: no rule defines the property
  std::vector<Disagreement> disagreements;  ///< each pair of rules once
};

/// Decides one property of all parts. Of the rules that select a part and define the property, the
/// one with the highest rank decides; of equal ranks the first. `values`: per rule; empty if the
/// rule does not define the property. Values are compared with ==.
Decision decide(const RulesOfParts& of_parts, std::span<const AreaRule> rules,
                std::span<const std::optional<double>> values);

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
