#pragma once

#include <string>

#include "bit/bit.hpp"
#include "bit/update_direction.hpp"

namespace tdbd::simulation {

/// Builds a bit from its file: a cutter table with defaults, meshing and gage pads (3.1, app. A),
/// or the meshes of its parts (bit_parts.hpp).
/// Throws InputError that lists every mistake of the file or of its table.
bit::Bit read_bit(const std::string& path, bit::DirectionRule directions, bit::InsideRule inside);

}  // namespace tdbd::simulation
