#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/files/bit_parts.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Reads the parts of a whole bit in one mesh file: the [solids] of a bit file. Thesis: 3.1, 3.3.
///   file, unit       STL, OBJ, PLY or OFF in the bit's frame; the file's unit, default 1 mm.
///                    Every named solid or group is a part; without names, every piece is one,
///                    called solid-1, solid-2, ... in the file's order (mesh/files/solids.hpp)
///   [[solids.rules]] for the solids that they match, later ones overriding earlier ones:
///     match          a name, * for any text, ? for any character
///     name           of the part; default: the solid's
///     kind           default: derived from names like those that `tdbd bit` writes
///     cutting        default: all but the bit body and cones
///     density        kg/m3; 0: counted in another part; none: the mass is unknown
///     group          default: the solids cutter-N/... are one group
///     cutter_position, cutter_rotation_vector   frame of the solid's cutter in the bit frame: sets
///                    the update direction (eq. 4.2), and makes the solids a cutter whose face
///                    carries forces (bit_parts.hpp). The mesh is not moved
///     update_direction   as in [[parts]]; default: from the cutter's frame if that is given,
///                    otherwise from the exposure profile for the parts of a cutter
///   [[solids.cones]] journals of cones whose solids turn (read_solid_cones)
/// Records every mistake at its line: files that cannot be read, solids that enclose no volume,
/// solids without a kind, rules that match no solid, two parts of one name, no part that cuts, an
/// unusual size (file_checks.hpp; not with unit_check = "off") and, if densities are required,
/// those that are missing.
PartsFromFiles read_solid_parts(Config& file, DirectionRule directions, InsideRule inside,
                                Densities densities = Densities::as_given);

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
  CutterLabels labels;                     ///< of the solid's cutter
};

/// Reads the rules of [solids], in the order of the file. Mistakes are recorded in `solids`.
std::vector<SolidRule> read_rules(Config& solids);

/// Combines all rules that match `name`. Later ones override earlier ones key by key.
SolidRule rule_for(const std::vector<SolidRule>& rules, const std::string& name);

/// Returns the kind that follows from a name like those of designed bits: cutter-3/face, /land,
/// /chamfer, /cse, /body; gage-pad-2; bit-body; cone-1/body; cone-1/row-2/tooth-3; leg-1;
/// leg-1/insert-2. Nothing for any other name.
std::optional<PartKind> kind_of_name(const std::string& name);

/// Reads the journals of cones whose solids are in a mesh file at the cone angle 0:
/// [[solids.cones]].
///   name       "cone-1"; the solids cone-1/... turn with it
///   azimuth, journal_angle, offset, skew, apex, foot_height    as in ConeLayout
///   rolling_ratio                                              Cone::rolling_ratio
/// Their shells and rows are the solids themselves, so gaps between cones are not checked.
std::vector<Cone> read_solid_cones(Config& solids);

/// Index of the cone to which a part belongs according to its name, or -1.
int cone_of(const std::vector<Cone>& cones, const std::string& part);

/// The [[solids.cones]] table of a cone; values read back exactly.
std::string cone_text_of(const Cone& cone);

}  // namespace tdbd::bit
