#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/files/length_unit.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Reads STL (binary or text), OBJ, PLY or OFF. The extension, in upper or lower case, selects the
/// format. `unit` is the length of one file unit in metres: 1e-3 for a file in millimetres.
/// Polygons are split into triangles (triangulate_polygon); equal points of an STL file become one
/// vertex. Nothing else is repaired; check_closed reports the defects. `warnings` receives what was
/// ignored. Throws InputError with path and reason, also if the header of the file states another
/// unit.
TriangleMesh read_mesh(const std::filesystem::path& path, double unit,
                       std::vector<std::string>* warnings = nullptr);

/// Writes `m` in the format given by the extension: .stl and .ply are binary (single and double
/// precision), .obj and .off are text with all digits. Coordinates are in `unit`, which the header
/// states; without one they are the positions as they are, and the header states no unit. A text
/// file in a decimal unit reads back bitwise identical. The file is written completely or not at
/// all. Throws RunError if it cannot be written, InputError for an unknown extension.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& m,
                const std::optional<LengthUnit>& unit = std::nullopt);

}  // namespace tdbd::mesh
