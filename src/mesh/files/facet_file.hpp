#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// The content of a mesh file in its own unit: points, polygons over them, and the named body (a solid of a text STL, a
/// group of an OBJ) of each polygon.
struct FacetFile {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> polygons;
  std::vector<std::string> names;  ///< of bodies, in the order of the file; none in PLY and OFF
  std::vector<int> body;           ///< per polygon: into names; empty without names
};

/// Reads STL (binary or text), OBJ, PLY or OFF, by the extension in upper or lower case, and checks that every
/// coordinate is finite and every index refers to a point. Equal points of one STL solid become one. Memory is taken
/// for what the file holds, not for what its header announces. Throws InputError with the path, the line of a text
/// file, and the reason.
FacetFile read_facets(const std::filesystem::path& path);

/// A file is binary if its length matches the number of facets that a binary header gives; some begin with "solid" too.
enum class StlKind { text, binary };

/// Throws InputError where the bytes are neither.
StlKind stl_kind(std::string_view bytes, const std::string& path);

/// Binary STL of that kind. Throws InputError for coordinates that are not finite.
FacetFile read_binary_stl(std::string_view bytes, const std::string& path);

/// Text STL with any number of solids. `path` is for messages.
FacetFile read_text_stl(std::istream& in, const std::string& path);

/// OBJ: v and f, bodies by g or o; colours, normals, textures and materials are ignored.
FacetFile read_obj(std::istream& in, const std::string& path);

/// PLY, text or binary of either byte order: x, y and z of `vertex`, and the list vertex_indices (or vertex_index) of
/// `face`; everything else is ignored.
FacetFile read_ply(std::string_view bytes, const std::string& path);

/// Text OFF, also with colours, normals or textures, which are ignored; a vertex and a facet begin a line each.
FacetFile read_off(std::string_view text, const std::string& path);

/// The largest coordinate of a mesh, in m: larger than any rock, and small enough that products of six stay numbers.
inline constexpr double largest_coordinate = 1e6;

/// The polygons as fans of triangles about their first corners, positions in m. If given, body_of_triangle receives the
/// body of every triangle. Throws InputError with `path` for a coordinate beyond largest_coordinate.
TriangleMesh triangulated(const FacetFile& file, const std::filesystem::path& path, double unit,
                          std::vector<int>* body_of_triangle = nullptr);

/// The extension in lower case, as ".stl".
std::string lower_extension(const std::filesystem::path& path);

}  // namespace tdbd::mesh
