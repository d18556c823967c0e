#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// One body of a mesh file.
struct Solid {
  std::string name;
  TriangleMesh mesh;  ///< m
};

/// Reads the bodies of a file: the named solids of a text STL, the groups of an OBJ, in the order
/// of the file; where there are no names (binary STL, PLY, OFF, an OBJ without groups) the pieces
/// of divide(), called solid-1, solid-2, ... `unit` is metres per file unit. Polygons are cut into
/// fans; nothing is repaired: ask check_closed. Throws InputError with path, line and reason.
std::vector<Solid> read_solids(const std::filesystem::path& path, double unit);

/// Pieces of a mesh. Facets that close a solid one after the other are a piece as soon as it is
/// closed, so that solids which touch or share points stay apart if they were written one by one;
/// what never closes falls into pieces that share edges. Points are equal when their coordinates
/// are. Facets and points keep their order.
std::vector<TriangleMesh> divide(const TriangleMesh& m);

/// The triangles with each vertex replaced by the first one at the same place.
std::vector<Triangle> by_first_of_equals(const TriangleMesh& m);

/// These triangles with the vertices that they use, both in their order.
TriangleMesh submesh(const TriangleMesh& m, const std::vector<int>& triangles);

/// All bodies as one mesh, nothing shared.
TriangleMesh merged(const std::vector<Solid>& solids);

/// Writes bodies in m, in the format of the extension: .stl as text with a solid for each, .obj
/// with a group for each, .ply and .off one after the other without names. All keep every bit of
/// the coordinates. The file appears whole or not at all. Throws RunError, InputError.
void write_solids(const std::filesystem::path& path, const std::vector<Solid>& solids);

/// write_solids with positions in `unit` (m per file unit): points that are in the file `original`
/// of that unit keep its digits, whatever the unit is.
void write_in_unit_of(const std::filesystem::path& path, std::vector<Solid> solids,
                      const std::filesystem::path& original, double unit);

}  // namespace tdbd::mesh
