#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// What a mesh file holds, in its own unit, before it is a mesh: points, polygons over them, and
/// the named body (a solid of a text STL, a group of an OBJ) that each polygon belongs to.
struct FacetFile {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> polygons;
  std::vector<std::string> names;  ///< of bodies, in the order of the file; none in PLY and OFF
  std::vector<int> body;           ///< per polygon: into names; empty without names
};

/// Reads STL (binary or text), OBJ, PLY or OFF, told apart by the extension in any case, and checks
/// that every coordinate is a finite number and every index names a point. Equal points of one STL
/// solid are one point. Throws InputError with path, line where there are lines, and reason.
FacetFile read_facets(const std::filesystem::path& path);

/// Text STL with any number of solids. `path` is for messages.
FacetFile read_text_stl(std::istream& in, const std::string& path);

/// OBJ: v and f, bodies by g or o; colours, normals, textures and materials are passed over.
FacetFile read_obj(std::istream& in, const std::string& path);

/// Polygons as fans of triangles about their first corners, positions in m. If given,
/// body_of_triangle receives the body of every triangle.
TriangleMesh triangulated(const FacetFile& file, double unit,
                          std::vector<int>* body_of_triangle = nullptr);

/// The extension in lower case: ".stl".
std::string lower_extension(const std::filesystem::path& path);

}  // namespace tdbd::mesh
