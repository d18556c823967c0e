#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Whether a field holds measures, or names by number such as parts, which need half the bytes.
enum class FieldValues { numbers, whole_numbers };

/// A number at every vertex or every triangle. The name includes the unit: "depth_m".
struct Field {
  std::string name;
  std::vector<double> values;
  FieldValues kind = FieldValues::numbers;
};

/// Writes `m` (positions in m) with its fields as VTK XML PolyData for ParaView, appended raw binary: exact doubles,
/// 32-bit indices and whole numbers, little-endian; nothing is copied whole on the way. Throws RunError if a field has
/// the wrong length or the file cannot be written; no partial file is left.
void write_vtp(const std::filesystem::path& path, const TriangleMesh& m,
               const std::vector<Field>& point_data, const std::vector<Field>& cell_data);

/// Writes a ParaView collection: (time in s, file relative to the collection). Throws RunError.
void write_pvd(const std::filesystem::path& path,
               const std::vector<std::pair<double, std::string>>& frames);

}  // namespace tdbd::mesh
