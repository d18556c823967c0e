#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
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
/// coordinate is finite and every index refers to a point. Equal points of one STL solid become one. Throws InputError with the path, the line of a text file, and the reason.
FacetFile read_facets(const std::filesystem::path& path);

/// Text STL with any number of solids. `path` is for messages.
FacetFile read_text_stl(std::istream& in, const std::string& path);

/// OBJ: v and f, bodies by g or o; colours, normals, textures and materials are ignored.
FacetFile read_obj(std::istream& in, const std::string& path);

/// The polygons as fans of triangles about their first corners, positions in m. If given,
/// body_of_triangle receives the body of every triangle.
TriangleMesh triangulated(const FacetFile& file, double unit,
                          std::vector<int>* body_of_triangle = nullptr);

/// The extension in lower case, as ".stl".
std::string lower_extension(const std::filesystem::path& path);

}  // namespace tdbd::mesh
