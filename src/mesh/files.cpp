#include "mesh/files.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <string>

#include "core/error.hpp"
#include "mesh/files_whole.hpp"

namespace tdbd::mesh {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<int>;

/// What a mesh file holds, before it is a mesh.
struct Soup {
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string e = path.extension().string();
  std::transform(e.begin(), e.end(), e.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return e;
}

void require_known(const std::filesystem::path& path) {
  const std::string e = lower_extension(path);
  if (e != ".stl" && e != ".obj" && e != ".ply" && e != ".off")
    fail_to_read(path,
                 fmt::format("unknown mesh format '{}', expected .stl, .obj, .ply or .off", e));
}

bool parse(std::istream& in, const std::string& extension, Soup& soup) {
  if (extension == ".stl") return CGAL::IO::read_STL(in, soup.points, soup.polygons);
  if (extension == ".obj") return CGAL::IO::read_OBJ(in, soup.points, soup.polygons);
  if (extension == ".off") return CGAL::IO::read_OFF(in, soup.points, soup.polygons);
  return CGAL::IO::read_PLY(in, soup.points, soup.polygons, CGAL::parameters::verbose(false));
}

/// The readers throw on broken files (sizes beyond memory, failed assertions); that is bad input.
Soup read_soup(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) fail_to_read(path, "no such file");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_to_read(path, "cannot be opened for reading");
  Soup soup;
  bool understood = false;
  try {
    understood = parse(in, lower_extension(path), soup);
  } catch (const std::exception& e) {
    fail_to_read(path, fmt::format("broken file ({})", e.what()));
  }
  if (!understood) fail_to_read(path, fmt::format("not a valid {} file", lower_extension(path)));
  return soup;
}

/// Adds a polygon as a fan of triangles about its first corner.
void add_fan(const std::filesystem::path& path, const Polygon& polygon, TriangleMesh& m) {
  if (polygon.size() < 3)
    fail_to_read(path, fmt::format("a polygon with {} corners", polygon.size()));
  for (const int v : polygon)
    if (v < 0 || v >= static_cast<int>(m.positions.size()))
      fail_to_read(path, fmt::format("a polygon names vertex {} of {}", v, m.positions.size()));
  for (std::size_t k = 2; k < polygon.size(); ++k)
    m.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
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
  const bool binary = extension == ".stl" || extension == ".ply";
  CGAL::IO::set_mode(out, binary ? CGAL::IO::BINARY : CGAL::IO::ASCII);
  if (extension == ".stl") CGAL::IO::write_STL(out, soup.points, soup.polygons);
  if (extension == ".obj") CGAL::IO::write_OBJ(out, soup.points, soup.polygons);
  if (extension == ".ply") CGAL::IO::write_PLY(out, soup.points, soup.polygons);
  if (extension == ".off") CGAL::IO::write_OFF(out, soup.points, soup.polygons);
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path, double unit) {
  require_known(path);
  const Soup soup = read_soup(path);
  TriangleMesh m;
  m.positions.reserve(soup.points.size());
  for (const Point& p : soup.points) m.positions.push_back(unit * Vec3(p.x(), p.y(), p.z()));
  for (const Polygon& polygon : soup.polygons) add_fan(path, polygon, m);
  if (m.triangles.empty()) fail_to_read(path, "no triangles");
  return m;
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& m) {
  require_known(path);
  WholeFile file(path);
  write_soup(file.stream(), lower_extension(path), soup_of(m));
  file.commit();
}

}  // namespace tdbd::mesh
