#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/files/facet_file.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Reads the bodies of a file in file order: the named solids of a text STL; in other files the
/// pieces found by divide(), each with the pieces that it surrounds (nested_pieces), such as its
/// cavities. A body of an OBJ has the name of its group if all its facets are in one; the others
/// are named solid-1, solid-2, ... `unit` is the length of one file unit in metres. Polygons are
/// split into triangles (triangulate_polygon). Before a file without names of bodies is divided,
/// points at most `weld` (m) apart are merged (weld_points); nothing else is repaired. `warnings`
/// receives what was ignored. Throws InputError with path, line and reason.
std::vector<Solid> read_solids(const std::filesystem::path& path, double unit, double weld = 0.0,
                               std::vector<std::string>* warnings = nullptr);

/// Merges all bodies into one mesh. Bodies share no vertices.
TriangleMesh merged(const std::vector<Solid>& solids);

/// How bodies are written.
struct SolidFormat {
  std::optional<LengthUnit> unit = std::nullopt;  ///< as for write_mesh
  StlKind stl = StlKind::text;  ///< binary: without names, coordinates in single precision
};

/// Writes bodies, positions in m, in the format given by the extension: .stl with one solid per
/// body, .obj with one group per body, .ply and .off one after the other without names. Text and
/// PLY store coordinates with all digits. The file is written completely or not at all. Throws
/// RunError or InputError.
void write_solids(const std::filesystem::path& path, const std::vector<Solid>& solids,
                  const SolidFormat& format = {});

/// Like write_solids. A point that is also in the file `original`, which has the unit `unit`
/// (metres per file unit), is written with the digits it has there if both files have that unit.
void write_like(const std::filesystem::path& path, const std::vector<Solid>& solids,
                const SolidFormat& format, const std::filesystem::path& original, double unit);

}  // namespace tdbd::mesh
