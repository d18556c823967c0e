#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/files/file_checks.hpp"
#include "bit/update_direction.hpp"
#include "core/config/config.hpp"
#include "core/config/field.hpp"

namespace tdbd::bit {

/// Whether every part must have a density, as required for mass properties.
enum class Densities { as_given, required };

/// What a cutter table gives and meshes do not show, of a face in [[parts]] or [[solids.rules]].
/// The cutter of the face receives these values (add_cutters).
struct CutterLabels {
  std::optional<int> blade;
  std::optional<std::string> zone;
  std::optional<double> under_exposure, wear;

  void visit(FieldVisitor& v) {
    v(blade, {.name = "blade",
              .computed_default = "none",
              .hi = std::numeric_limits<int>::max(),
              .meaning = "of a face with its cutter's frame: the blade that carries the cutter"});
    v(zone, {.name = "zone",
             .computed_default = "none",
             .meaning = "of such a face: cone, nose, shoulder or gage, or another label"});
    v(under_exposure,
      {.name = "under_exposure",
       .unit = "m",
       .computed_default = "0",
       .range = bit_length_or_none,
       .meaning = "of such a face: distance of the tip from the profile into the bit"});
    v(wear, {.name = "wear",
             .unit = "m",
             .computed_default = "0",
             .range = bit_length_or_none,
             .meaning = "of such a face: height of the flat that the mesh already has"});
  }
};

/// The parts that a bit file names, and their data.
struct PartsFromFiles {
  std::vector<Part> parts;
  std::vector<std::uint8_t> has_direction;   ///< 0: part of a cutter without direction or frame
  std::vector<Cone> cones;                   ///< with which parts turn
  std::vector<std::string> without_density;  ///< names of parts without a density
  std::vector<std::optional<Pose>> frames;   ///< of each part's cutter; empty: not known
  std::vector<CutterLabels> labels;          ///< of each part
};

/// Reads the parts of a bit from mesh files: the [[parts]] of a bit file. Thesis: 3.1.
///   name, kind            letters, digits, - and _, in folders: "cutter-1/face"; as in kind_name
///   file, unit            STL, OBJ, PLY or OFF; length of the file's unit, default 1 mm
///   cutting               default: all but the bit body
///   density               kg/m3; 0: counted in another part; none: the mass is unknown
///   position, rotation_vector  part frame in the bit frame; default: the bit frame. For a cutter's
///                         part without update_direction: the cutter's frame (mesh_cutters.hpp)
///   group                 parts with the same number share frame and update direction
///   blade, zone, under_exposure, wear  of the cutter of a face (CutterLabels)
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
