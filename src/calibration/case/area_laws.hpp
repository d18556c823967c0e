#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bit/areas/area_rules.hpp"
#include "core/config/config.hpp"
#include "forces/law.hpp"

namespace tdbd::calibration {

struct Tool;
struct Unknown;

/// An area: parts of bits with coefficients of their own. The other parts have those of the law.
struct CoefficientArea {
  std::string name;
  bit::AreaSelector selector;
  /// In the order of the fields of the law: the values that the area sets (SI); for unknowns their
  /// start values.
  std::vector<std::optional<double>> values;
  std::vector<bit::PartKind> kinds = {};  ///< of its parts that use the law
};

/// The areas of a calibration. A mix is a set of coefficients that parts share: for each field of
/// the law the index of the area that determines it, or -1. Mix 0 is that of parts in no area.
struct AreaLaws {
  std::vector<CoefficientArea> areas;
  std::vector<std::vector<int>> mixes;
  std::map<std::string, std::vector<int>> mix_of_part;  ///< by bit
};

/// The tables with the values of areas: [areas.NAME.fixed] and [areas.NAME.unknowns.KEY] of a
/// calibration, or [areas.NAME.truth] of a laboratory.
enum class AreaValues { fitted, truth };

/// Reads [areas.NAME] and adds the unknowns of areas. If several areas set a coefficient of a part,
/// the same rule decides as in bit files (bit/areas). Records as mistakes: those of
/// bit::read_areas, criteria that match no cutter part of any bit, names that are not coefficients,
/// and areas without coefficients.
AreaLaws read_area_laws(Config& c, const forces::Law& law, const std::vector<Tool>& tools,
                        AreaValues values, std::vector<Unknown>& unknowns);

/// Returns the mix of each part of a bit. Empty if every part has mix 0.
std::vector<int> mix_of_parts(const AreaLaws& areas, const std::string& bit);

/// Returns the law of every mix, at least one. `whole`: the law of parts in no area.
std::vector<forces::Law> laws_of_mixes(const AreaLaws& areas, const forces::Law& whole);

/// Returns the areas with these values as TOML tables [forces.areas.NAME-KIND] of a case. Each kind
/// of part that uses the law has its own table, because the other parts of the area have other
/// laws.
std::string areas_toml(const AreaLaws& areas, const forces::Law& law);

}  // namespace tdbd::calibration
