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

/// Parts of bits that have coefficients of their own; the others have those of the law.
struct CoefficientArea {
  std::string name;
  bit::AreaSelector selector;
  /// In the order of the fields of the law: what the area gives (SI), of unknowns their starts.
  std::vector<std::optional<double>> values;
  std::vector<bit::PartKind> kinds = {};  ///< of its parts that follow the law
};

/// The areas of a calibration. A mix is a set of coefficients that parts have: for each field of the
/// law the area that decides it, or -1. Mix 0 is that of parts in no area.
struct AreaLaws {
  std::vector<CoefficientArea> areas;
  std::vector<std::vector<int>> mixes;
  std::map<std::string, std::vector<int>> mix_of_part;  ///< by bit
};

/// Where the values of areas are: [areas.NAME.fixed] and [areas.NAME.unknowns.KEY] of a calibration,
/// or [areas.NAME.truth] of a laboratory.
enum class AreaValues { fitted, truth };

/// Reads [areas.NAME]; which area decides a coefficient of a part is decided as in bit files
/// (bit/areas). Adds its unknowns. Notes as mistakes: those of bit::read_areas; criteria that no part
/// of a cutter of any of the bits meets; names of no coefficient; an area without any.
AreaLaws read_area_laws(Config& c, const forces::Law& law, const std::vector<Tool>& tools,
                        AreaValues values, std::vector<Unknown>& unknowns);

/// The mix of each part of a bit; empty: all have mix 0.
std::vector<int> mix_of_parts(const AreaLaws& areas, const std::string& bit);

/// The law of every mix; one at least. `whole`: of parts in no area.
std::vector<forces::Law> laws_of_mixes(const AreaLaws& areas, const forces::Law& whole);

/// The areas as tables [forces.areas.NAME-KIND] of a case, with these values: one for each kind of
/// part that follows the law, since other parts of the area have other laws. TOML.
std::string areas_toml(const AreaLaws& areas, const forces::Law& law);

}  // namespace tdbd::calibration
