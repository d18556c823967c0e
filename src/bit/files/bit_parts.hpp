#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/update_direction.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Whether every part must have a density: when mass properties are asked for.
enum class Densities { as_given, demanded };

struct PartsFromFiles {
  std::vector<Part> parts;
  std::vector<std::uint8_t> has_direction;   ///< 0: a cutter's, without direction and frame
  std::vector<Cone> cones;                   ///< that parts turn with
  std::vector<std::string> without_density;  ///< names of parts that the file gives none
};

/// The parts of a bit from mesh files: the [[parts]] of a bit file (3.1).
///   name, kind            letters, digits, - and _, in folders: "cutter-1/face"; as kind_name
///   file, unit            STL, OBJ, PLY or OFF; length of the file's unit, default 1 mm
///   cutting               default: all but the bit body
///   density               kg/m3; 0: counted elsewhere; none: the mass is not known
///   position, rotation_vector  part frame in the bit frame; default: the bit frame
///   group                 parts with the same number share frame and update direction
///   update_direction      (x, 0, z) at azimuth 0. Default: of eq. 4.2 for the parts of a cutter,
///                         from its frame (position and rotation_vector) if that is given, else
///                         from the exposure profile; outwards for a gage pad; down otherwise
/// Notes every mistake at its line: files that are missing or unreadable, meshes that are open,
/// flipped or not manifold, two parts of one name, groups that disagree, no part that cuts, sizes
/// that no bit has (unit_question.hpp; not with unit_check = "off"), and, if they are demanded,
/// densities that are missing.
PartsFromFiles read_parts(Config& file, DirectionRule directions, InsideRule inside,
                          Densities densities = Densities::as_given);

/// Gives the parts that have no direction yet that of the exposure profile of all parts; those of
/// one group together.
void direct_by_profile(PartsFromFiles& read, DirectionRule directions, InsideRule inside);

}  // namespace tdbd::bit
