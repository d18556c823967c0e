#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/report/area_report.hpp"

namespace tdbd::bit {

/// A vector as a JSON array, [x, y, z].
nlohmann::ordered_json vector_json(const Vec3& v);

/// Writes bit.json: the cutters and cones as placed, and the properties of every part
/// (properties_json), for figures. SI, units in the keys. `laws`: per part, of a run with forces.
/// Throws RunError if it cannot be written.
void write_bit_files(const std::filesystem::path& folder, const Bit& bit,
                     std::span<const PartLaw> laws = {});

/// Writes all parts in space at a pose as a VTK file, with part number, kind and cutter as cell
/// data, and the cone if the bit has cones. Throws RunError if it cannot be written.
void write_bit_vtp(const std::filesystem::path& path, const Bit& bit, const Pose& X_WB);

/// Returns all parts in space at a pose as one mesh. part_of_triangle (if given) receives part
/// numbers.
mesh::TriangleMesh merged_mesh(const Bit& bit, const Pose& X_WB,
                               std::vector<int>* part_of_triangle);

}  // namespace tdbd::bit
