#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Whether a field contains real values, or integers such as part numbers, which take half the
/// bytes.
enum class FieldValues { numbers, whole_numbers };

/// One value at every vertex or every triangle. The name includes the unit: "depth_m".
struct Field {
  std::string name;
  std::vector<double> values;
  FieldValues kind = FieldValues::numbers;
};

/// Writes `m` (positions in m) with its fields as VTK XML PolyData for ParaView. The data are
/// appended raw binary, little-endian: doubles, 32-bit indices and 32-bit integers. Arrays are not
/// copied as a whole. Throws RunError if a field has the wrong length or the file cannot be
/// written; no partial file is left.
void write_vtp(const std::filesystem::path& path, const TriangleMesh& m,
               const std::vector<Field>& point_data, const std::vector<Field>& cell_data);

/// Writes a ParaView collection. Each frame is a time in s and a file name relative to the
/// collection. Throws RunError.
void write_pvd(const std::filesystem::path& path,
               const std::vector<std::pair<double, std::string>>& frames);

}  // namespace tdbd::mesh
