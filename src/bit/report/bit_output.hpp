#pragma once

#include <filesystem>
#include <string>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// bit.json: the cutters and cones as placed, for figures. SI, units in the keys.
void write_bit_files(const std::filesystem::path& folder, const Bit& bit);

/// All parts in space at a pose, with part number, kind and cutter as cell data, and the cone if
/// the bit has any.
void write_bit_vtp(const std::filesystem::path& path, const Bit& bit, const Pose& X_WB);

/// All parts in the bit frame as one mesh; part_of_triangle (if given) receives part numbers.
mesh::TriangleMesh merged_mesh(const Bit& bit, const Pose& X_WB,
                               std::vector<int>* part_of_triangle);

}  // namespace tdbd::bit
