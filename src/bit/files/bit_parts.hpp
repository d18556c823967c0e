#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/update_direction.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Whether every part must have a density, as required for mass properties.
enum class Densities { as_given, required };

/// The parts that a bit file names, and their data.
struct PartsFromFiles {
  std::vector<Part> parts;
  std::vector<std::uint8_t> has_direction;   ///< 0: part of a cutter without direction or frame
  std::vector<Cone> cones;                   ///< with which parts turn
  std::vector<std::string> without_density;  ///< names of parts without a density
  std::vector<std::optional<Pose>> frames;   ///< of each part's cutter; empty: not known
};

/// Reads the parts of a bit from mesh files: the [[parts]] of a bit file. Thesis: 3.1.
///   name, kind            letters, digits, - and _, in folders: "cutter-1/face"; as in kind_name
///   file, unit            STL, OBJ, PLY or OFF; length of the file's unit, default 1 mm
///   cutting               default: all but the bit body
///   density               kg/m3; 0: counted in another part; none: the mass is unknown
///   position, rotation_vector  part frame in the bit frame; default: the bit frame. For a cutter's
///                         part without update_direction: the cutter's frame (mesh_cutters.hpp)
///   group                 parts with the same number share frame and update direction
///   update_direction      (x, 0, z) at azimuth 0. Default: eq. 4.2 for the parts of a cutter, from
///                         its frame (position and rotation_vector) if that is given, otherwise
///                         from the exposure profile; outwards for a gage pad; down for all others
/// Records every mistake at its line: files that are missing or unreadable, meshes that are open,
/// flipped or not manifold, two parts of one name, groups that disagree, no part that cuts,
/// unusual sizes (file_checks.hpp; not with unit_check = "off") and, if densities are required,
/// those that are missing.
PartsFromFiles read_parts(Config& file, DirectionRule directions, InsideRule inside,
                          Densities densities = Densities::as_given);

/// Sets the direction of parts without one from the exposure profile of all parts. Parts of one
/// group get the same direction.
void set_profile_directions(PartsFromFiles& read, DirectionRule directions, InsideRule inside);

}  // namespace tdbd::bit
