#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

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

}  // namespace tdbd::bit
