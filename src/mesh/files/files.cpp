#include "mesh/files/files.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "io/whole_file.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/ply.hpp"

namespace tdbd::mesh {
namespace {

using FilePoint = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<int>;

/// Points and polygons in the types that CGAL reads and writes.
struct Soup {
  std::vector<FilePoint> points;
  std::vector<Polygon> polygons;
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

void require_known(const std::filesystem::path& path) {
  const std::string e = lower_extension(path);
  if (e != ".stl" && e != ".obj" && e != ".ply" && e != ".off")
    fail_to_read(path,
                 fmt::format("unknown mesh format '{}', expected .stl, .obj, .ply or .off", e));
}

void require_sound(const std::filesystem::path& path, const FacetFile& file) {
  if (file.polygons.empty()) fail_to_read(path, "no triangles");
  for (std::size_t v = 0; v < file.points.size(); ++v)
    if (const Vec3& x = file.points[v]; !x.allFinite())
      fail_to_read(path, fmt::format("vertex {} of {} is at ({}, {}, {}), expected finite numbers",
                                     v, file.points.size(), x.x(), x.y(), x.z()));
  for (std::size_t i = 0; i < file.polygons.size(); ++i) {
    if (file.polygons[i].size() < 3)
      fail_to_read(path,
                   fmt::format("facet {}: a polygon with {} corners", i, file.polygons[i].size()));
    for (const int v : file.polygons[i])
      if (v < 0 || v >= static_cast<int>(file.points.size()))
        fail_to_read(path, fmt::format("facet {}: a polygon names vertex {} of {}", i, v,
                                       file.points.size()));
  }
}

/// Squares and volumes of larger coordinates would overflow.
void require_small(const std::filesystem::path& path, const std::vector<Vec3>& points) {
  for (std::size_t v = 0; v < points.size(); ++v)
    if (const Vec3& x = points[v]; !(x.cwiseAbs().maxCoeff() <= largest_coordinate))
      fail_to_read(path, fmt::format("vertex {}: found a position of ({}, {}, {}) m, expected "
                                     "coordinates up to {} m",
                                     v, x.x(), x.y(), x.z(), largest_coordinate));
}

FacetFile read_any(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path), name = path.string();
  std::string bytes = read_file(path, "a mesh file");
  if (extension == ".ply") return read_ply(bytes, name);
  if (extension == ".off") return read_off(bytes, name);
  if (extension == ".stl" && stl_kind(bytes, name) == StlKind::binary)
    return read_binary_stl(bytes, name);
  std::istringstream text(std::move(bytes));
  return extension == ".obj" ? read_obj(text, name) : read_text_stl(text, name);
}

Soup soup_of(const TriangleMesh& m) {
  Soup soup;
  soup.points.reserve(m.positions.size());
  soup.polygons.reserve(m.triangles.size());
  for (const Vec3& x : m.positions) soup.points.emplace_back(x.x(), x.y(), x.z());
  for (const Triangle& t : m.triangles) soup.polygons.push_back({t[0], t[1], t[2]});
  return soup;
}

void write_soup(std::ostream& out, const std::string& extension, const Soup& soup) {
  out.precision(17);
  CGAL::IO::set_mode(out, extension == ".stl" ? CGAL::IO::BINARY : CGAL::IO::ASCII);
  if (extension == ".stl") CGAL::IO::write_STL(out, soup.points, soup.polygons);
  if (extension == ".obj") CGAL::IO::write_OBJ(out, soup.points, soup.polygons);
  if (extension == ".off") CGAL::IO::write_OFF(out, soup.points, soup.polygons);
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string e = path.extension().string();
  std::transform(e.begin(), e.end(), e.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return e;
}

FacetFile read_facets(const std::filesystem::path& path) {
  require_known(path);
  FacetFile file = read_any(path);
  require_sound(path, file);
  return file;
}

TriangleMesh triangulated(const FacetFile& file, const std::filesystem::path& path, double unit,
                          std::vector<int>* body_of_triangle) {
  TriangleMesh m;
  m.positions.reserve(file.points.size());
  for (const Vec3& x : file.points) m.positions.push_back(unit * x);
  require_small(path, m.positions);
  for (std::size_t i = 0; i < file.polygons.size(); ++i) {
    const Polygon& p = file.polygons[i];
    for (std::size_t k = 2; k < p.size(); ++k) m.triangles.push_back({p[0], p[k - 1], p[k]});
    if (body_of_triangle != nullptr && !file.body.empty())
      body_of_triangle->insert(body_of_triangle->end(), p.size() - 2, file.body[i]);
  }
  return m;
}

TriangleMesh read_mesh(const std::filesystem::path& path, double unit) {
  return triangulated(read_facets(path), path, unit);
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& m) {
  require_known(path);
  AtomicFile file(path);
  const std::string extension = lower_extension(path);
  if (extension == ".ply") write_ply(file.stream(), m);
  if (extension != ".ply") write_soup(file.stream(), extension, soup_of(m));
  file.commit();
}

}  // namespace tdbd::mesh
