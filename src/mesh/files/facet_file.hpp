#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/files/length_unit.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// The content of a mesh file: points, polygons, and the solid of a text STL or the group of an OBJ
/// to which each polygon belongs. Solids are bodies; groups only name facets. Points are in the unit
/// of the file. Those of a text file that states a decimal unit are in m, converted digit by digit
/// (decimal_number).
struct FacetFile {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> polygons;
  std::vector<std::string> names;  ///< of solids or groups in file order, UTF-8; names that are not
                                   ///< are taken for Latin-1; empty for PLY and OFF
  std::vector<int> body;           ///< index into names per polygon; empty without names
  enum class Names { bodies, groups };
  Names names_are = Names::bodies;
  std::optional<LengthUnit> unit = std::nullopt;  ///< stated by the header
  enum class Points { in_file_unit, in_m };
  Points points_are = Points::in_file_unit;
  std::vector<std::string> warnings = {};  ///< what was ignored, with the path of the file
};

/// Reads STL (binary or text), OBJ, PLY or OFF, as given by the extension in upper or lower case.
/// Text may begin with a byte-order mark of UTF-8; lines end with LF, CRLF or CR. Checks that every
/// index refers to a point; triangulated() checks the coordinates. Equal points within one STL
/// solid are merged. Memory is allocated for the content, not for the counts in the header. Throws
/// InputError with the path, the line of a text file, and the reason.
FacetFile read_facets(const std::filesystem::path& path);

/// A file is binary if its length matches the number of facets in its header, even if it begins
/// with "solid": some binary files do. Otherwise it is text if it begins with "solid" and has no
/// zero byte near its start, and binary if it is longer than its header states.
enum class StlKind { text, binary };

/// Whether a file begins with "solid" in upper or lower case, after blanks or a byte-order mark.
bool begins_with_solid(std::string_view bytes);

/// Throws InputError if the bytes are neither a binary nor a text STL.
StlKind stl_kind(std::string_view bytes, const std::string& path);

/// Reads an STL file of kind `binary`. Bytes after the last facet produce a warning. Throws
/// InputError if a coordinate is not finite.
FacetFile read_binary_stl(std::string_view bytes, const std::string& path);

/// Reads a text STL with any number of solids, whose names may state one unit. `path` is used in
/// error messages. Coordinates of text files are multiplied by 10^power.
FacetFile read_text_stl(std::string_view text, const std::string& path, int power = 0);

/// Reads v and f of an OBJ file; g and o name the facets that follow. A backslash at the end of a
/// line continues it. Colours, normals, textures, materials, lines and free-form surfaces are
/// ignored; unknown statements are errors.
FacetFile read_obj(std::string_view text, const std::string& path, int power = 0);

/// Reads a PLY file, text or binary of either byte order: x, y and z of `vertex`, and the list
/// vertex_indices (or vertex_index) of `face`. Everything else is ignored, even if it is no number.
/// Throws InputError for triangle strips.
FacetFile read_ply(std::string_view bytes, const std::string& path);

/// Reads a text OFF file. Its keyword may be missing or joined to the counts. Colours, normals and
/// textures are ignored. Vertices and facets start a new line each, or, if there are not enough
/// lines, follow each other without regard to line ends.
FacetFile read_off(std::string_view text, const std::string& path, int power = 0);

/// Largest permitted coordinate of a mesh, m: larger than any rock, and small enough that products
/// of six coordinates do not overflow.
inline constexpr double largest_coordinate = 1e6;

/// Splits the polygons into triangles (triangulate_polygon); positions in m. If given,
/// body_of_triangle receives the body of every triangle. Throws InputError with `path` if a
/// coordinate exceeds largest_coordinate, or if the file states a unit other than `unit`.
TriangleMesh triangulated(const FacetFile& file, const std::filesystem::path& path, double unit,
                          std::vector<int>* body_of_triangle = nullptr);

/// The extension in lower case, for example ".stl".
std::string lower_extension(const std::filesystem::path& path);

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
