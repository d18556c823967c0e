#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Properties that a bit file defines for a solid: one of its [[solids.rules]], or all matching
/// rules combined.
struct SolidRule {
  std::string match;
  std::optional<std::string> name;
  std::optional<PartKind> kind;
  std::optional<bool> cutting, rubs;
  std::optional<double> density;  ///< kg/m3
  std::optional<int> group;
  std::optional<Pose> X_BC;                ///< frame of the solid's cutter
  std::optional<Vec3> update_direction_B;  ///< unit
};

/// Reads the rules of [solids], in the order of the file. Mistakes are recorded in `solids`.
std::vector<SolidRule> read_rules(Config& solids);

/// Combines all rules that match `name`. Later ones override earlier ones key by key.
SolidRule rule_for(const std::vector<SolidRule>& rules, const std::string& name);

/// Returns the kind that follows from a name like those of designed bits: cutter-3/face, /land,
/// /chamfer, /cse, /body; gage-pad-2; bit-body; cone-1/body; cone-1/row-2/tooth-3; leg-1;
/// leg-1/insert-2. Nothing for any other name.
std::optional<PartKind> kind_of_name(const std::string& name);

}  // namespace tdbd::bit
