#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <vector>

#include "mesh/files/facet_file.hpp"
#include "mesh/files/length_unit.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Converts positions to the coordinates of a file.
struct FileCoordinates {
  /// The unit of the file, which its header states. Without it the positions are written as they
  /// are, and the header states none.
  std::optional<LengthUnit> unit = std::nullopt;
  /// Positions, m, whose coordinates in the file are known: those of the file they were read from.
  std::map<std::array<double, 3>, Vec3> known = {};

  /// The coordinates of a position, in the unit of the file.
  Vec3 value(const Vec3& x) const;

  /// "X Y Z": decimal numbers that read back to the same position in a decimal unit.
  std::string text(const Vec3& x) const;
};

// Writers of the formats without doubles. Facet normals are computed from the positions. `text`
// formats store all digits; binary STL rounds coordinates to single precision.

/// Writes one solid per body.
void write_text_stl(std::ostream& out, const std::vector<Solid>& solids, const FileCoordinates& c);

/// Writes all bodies one after the other; the format has no names.
void write_binary_stl(std::ostream& out, const std::vector<Solid>& solids,
                      const FileCoordinates& c);

/// Writes one group per body; a body without a name has no group.
void write_obj(std::ostream& out, const std::vector<Solid>& solids, const FileCoordinates& c);

/// Writes all bodies one after the other; the format has no names.
void write_off(std::ostream& out, const std::vector<Solid>& solids, const FileCoordinates& c);

/// Writes a file in the format given by its extension, completely or not at all. Throws RunError if
/// it cannot be written, InputError for an unknown extension.
void write_bodies(const std::filesystem::path& path, const std::vector<Solid>& solids,
                  const FileCoordinates& c, StlKind stl);

/// The mesh with coordinates in the unit of the file, rounded to single precision like those of a
/// binary STL, and with points that became equal merged.
TriangleMesh in_single_precision(const TriangleMesh& m, const FileCoordinates& c);

}  // namespace tdbd::mesh
