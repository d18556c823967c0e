#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The parts that an area consists of: those that meet every criterion that is given. The criteria
/// are listed from the general to the particular. Thesis: chapter 3, behaviour by area.
struct AreaSelector {
  std::optional<PartKind> kind = {};
  std::optional<std::string> zone = {};   ///< zone_of
  std::optional<int> blade = {};          ///< Cutter::blade, of the parts of a cutter
  std::optional<int> cone = {};           ///< K of "cone-K/..."
  std::optional<int> row = {};            ///< J of "cone-K/row-J/tooth-I"
  std::optional<std::string> names = {};  ///< pattern of the part's name (core/wildcard.hpp)
  std::optional<std::string> part = {};   ///< the name of a single part
};

/// An area that gives properties to its parts.
struct AreaRule {
  std::string name;   ///< NAME of [areas.NAME]
  std::string place;  ///< "FILE:LINE: areas.NAME", for messages
  AreaSelector selector;
};

/// The zone of a part: the label of its cutter ("cone", "nose", "shoulder", "gage", or that of the
/// table's own column); "gage" of gage pads and of the teeth of gage rows; empty of all others.
std::string zone_of(const Bit& bit, const Part& part);

bool selects(const AreaSelector& selector, const Bit& bit, const Part& part);

/// How particular an area is. Of two areas, the one with the most particular criterion that the
/// other lacks has the greater rank; areas of equal rank have the same criteria.
int rank_of(const AreaSelector& selector);

/// Per part of the bit, the indices of the rules that select it, by rising rank; rules of equal rank
/// in their order.
using RulesOfParts = std::vector<std::vector<int>>;
RulesOfParts rules_of_parts(const Bit& bit, std::span<const AreaRule> rules);

/// Two rules of equal rank that give a part different values of one property, where no rule of
/// greater rank gives it.
struct Disagreement {
  int first = 0, second = 0;  ///< indices of rules
  int part = 0;               ///< the first part of the bit on which they disagree
};

/// Which rules decide one property.
struct Decision {
  std::vector<int> rule;                    ///< per part; -1: no rule gives the property
  std::vector<Disagreement> disagreements;  ///< each pair of rules once
};

/// Decides one property of all parts: of the rules that select a part and give the property, the
/// one of the greatest rank; of equal ranks the first. `values`: per rule; none: the rule does not
/// give the property. Values are compared by ==.
Decision decide(const RulesOfParts& of_parts, std::span<const AreaRule> rules,
                std::span<const std::optional<double>> values);

}  // namespace tdbd::bit
