#pragma once

#include <filesystem>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Reads the bodies of a file in its order: the named solids of a text STL, the groups of an OBJ; where there are no
/// names (binary STL, PLY, OFF, an OBJ without groups), the pieces of divide(), called solid-1, solid-2, ... `unit` is
/// metres per file unit. Polygons are cut into fans; nothing is repaired. Throws InputError with path, line and reason.
std::vector<Solid> read_solids(const std::filesystem::path& path, double unit);

/// All bodies as one mesh that shares no vertices between them.
TriangleMesh merged(const std::vector<Solid>& solids);

/// Writes bodies in m, in the format of the extension: .stl as text with a solid for each, .obj
/// with a group for each, .ply and .off one after the other without names. All keep every bit of
/// the coordinates. The file appears complete or not at all. Throws RunError, InputError.
void write_solids(const std::filesystem::path& path, const std::vector<Solid>& solids);

/// write_solids with positions in `unit` (m per file unit). Points that are in the file `original`, in the same unit,
/// keep its digits.
void write_in_unit_of(const std::filesystem::path& path, std::vector<Solid> solids,
                      const std::filesystem::path& original, double unit);

}  // namespace tdbd::mesh
