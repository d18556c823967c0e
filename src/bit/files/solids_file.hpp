#pragma once

#include "bit/files/bit_parts.hpp"
#include "bit/update_direction.hpp"
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
///                    carries forces (mesh_cutters.hpp). The mesh is not moved
///     update_direction   as in [[parts]]; default: from the cutter's frame if that is given,
///                    otherwise from the exposure profile for the parts of a cutter
///   [[solids.cones]] journals of cones whose solids turn (solid_cones.hpp)
/// Records every mistake at its line: files that cannot be read, solids that enclose no volume,
/// solids without a kind, rules that match no solid, two parts of one name, no part that cuts, an
/// unusual size (unit_question.hpp; not with unit_check = "off") and, if densities are
/// required, those that are missing.
PartsFromFiles read_solid_parts(Config& file, DirectionRule directions, InsideRule inside,
                                Densities densities = Densities::as_given);

}  // namespace tdbd::bit
