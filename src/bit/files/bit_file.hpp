#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/files/bit_parts.hpp"
#include "bit/files/pdc_file.hpp"
#include "core/config/key_table.hpp"

namespace tdbd::bit {

/// A bit and its source files.
struct BitFile {
  Bit bit;
  std::vector<std::string> files;                 ///< the bit file and those that it names
  std::string fingerprint;                        ///< of their contents
  std::vector<std::string> without_density = {};  ///< parts from meshes whose mass is unknown
  std::vector<BitDoubt> doubts = {};  ///< values of the cutter table that contradict others,
                                      ///< and numbers without a unit that are unusual
};

/// Returns every table that a bit file may have, for `tdbd keys`.
std::vector<KeyTable> bit_tables();

/// Builds a bit from its file. The file contains a cutter table or a design with defaults, meshing,
/// gage pads (thesis 3.1, app. A) and blades (pdc_file.hpp); or the meshes of its parts
/// (bit_parts.hpp) or of the whole bit (solids_file.hpp); or roller cones (cone_file.hpp). If
/// densities are required, parts from meshes without one are a mistake. Throws InputError that
/// lists every mistake in the file and its table, or the cutters that reach beyond the file's
/// gage_diameter. `overrides` change keys of the bit file, "key=value"; `origin` is their source,
/// for messages.
BitFile read_bit(const std::string& path, DirectionRule directions, InsideRule inside,
                 Densities densities = Densities::as_given,
                 const std::vector<std::string>& overrides = {},
                 const std::string& origin = "bit.set");

}  // namespace tdbd::bit
