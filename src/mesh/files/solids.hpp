#pragma once

#include <filesystem>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Reads the bodies of a file in file order: the named solids of a text STL or the groups of an
/// OBJ. Files without names (binary STL, PLY, OFF, an OBJ without groups) are split by divide();
/// the pieces are named solid-1, solid-2, ... `unit` is the length of one file unit in metres.
/// Polygons are split into fans; nothing is repaired. Throws InputError with path, line and reason.
std::vector<Solid> read_solids(const std::filesystem::path& path, double unit);

/// Merges all bodies into one mesh. Bodies share no vertices.
TriangleMesh merged(const std::vector<Solid>& solids);

/// Writes bodies, positions in m, in the format given by the extension: .stl as text with one solid
/// per body, .obj with one group per body, .ply and .off one after the other without names.
/// Coordinates are written with full double precision. The file is written completely or not at
/// all. Throws RunError or InputError.
void write_solids(const std::filesystem::path& path, const std::vector<Solid>& solids);

/// Like write_solids, with positions in `unit` (metres per file unit). A point that is also in the
/// file `original`, which has the same unit, is written with the digits it has there.
void write_in_unit_of(const std::filesystem::path& path, std::vector<Solid> solids,
                      const std::filesystem::path& original, double unit);

}  // namespace tdbd::mesh
