#include "mesh/files/files.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/whole_file.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/ply.hpp"

namespace tdbd::mesh {
namespace {

using FilePoint = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<int>;

/// Points and polygons as CGAL reads and writes them.
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

/// A binary STL gives the number of facets after its header of 80 bytes. A file is text if it begins with "solid" and
/// its length does not match that number: some programs begin binary files with "solid" too.
enum class StlKind { text, binary };
StlKind stl_kind(const std::filesystem::path& path, std::istream& in) {
  constexpr std::uintmax_t head = 84, facet = 50;
  const std::uintmax_t size = std::filesystem::file_size(path);
  std::array<unsigned char, head> bytes{};
  in.read(reinterpret_cast<char*>(bytes.data()), head);
  const bool has_head = static_cast<bool>(in);
  in.clear();
  in.seekg(0);
  std::uintmax_t facets = 0;
  for (std::size_t k = 4; k-- > 0;) facets = 256 * facets + bytes[80 + k];
  if (has_head && size == head + facet * facets) return StlKind::binary;
  const std::string start(bytes.begin(), bytes.begin() + 5);
  if (start == "solid" || size == 0) return StlKind::text;
  if (!has_head) fail_to_read(path, "not a valid .stl file: neither text nor a binary header");
  fail_to_read(path, fmt::format("truncated or no STL: {} bytes, expected {} for {} facets", size,
                                 head + facet * facets, facets));
}

bool parse(std::istream& in, const std::string& extension, Soup& soup) {
  if (extension == ".stl") return CGAL::IO::read_STL(in, soup.points, soup.polygons);
  if (extension == ".off") return CGAL::IO::read_OFF(in, soup.points, soup.polygons);
  return CGAL::IO::read_PLY(in, soup.points, soup.polygons, CGAL::parameters::verbose(false));
}

/// CGAL's readers throw on broken files (sizes beyond memory, failed assertions): that is an input error.
FacetFile read_by_cgal(const std::filesystem::path& path, std::istream& in) {
  Soup soup;
  bool understood = false;
  try {
    understood = parse(in, lower_extension(path), soup);
  } catch (const std::exception& e) {
    fail_to_read(path, fmt::format("broken file ({})", e.what()));
  }
  if (!understood)
    fail_to_read(path, fmt::format("not a valid {} file, or cut short", lower_extension(path)));
  FacetFile file;
  file.points.reserve(soup.points.size());
  for (const FilePoint& p : soup.points) file.points.push_back(Vec3(p.x(), p.y(), p.z()));
  file.polygons = std::move(soup.polygons);
  return file;
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

FacetFile read_any(const std::filesystem::path& path, std::istream& in) {
  const std::string extension = lower_extension(path);
  if (extension == ".obj") return read_obj(in, path.string());
  if (extension == ".stl" && stl_kind(path, in) == StlKind::text)
    return read_text_stl(in, path.string());
  return read_by_cgal(path, in);
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
  if (!std::filesystem::is_regular_file(path)) fail_to_read(path, "no such file");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_to_read(path, "cannot be opened for reading");
  FacetFile file = read_any(path, in);
  require_sound(path, file);
  return file;
}

TriangleMesh triangulated(const FacetFile& file, double unit, std::vector<int>* body_of_triangle) {
  TriangleMesh m;
  m.positions.reserve(file.points.size());
  for (const Vec3& x : file.points) m.positions.push_back(unit * x);
  for (std::size_t i = 0; i < file.polygons.size(); ++i) {
    const Polygon& p = file.polygons[i];
    for (std::size_t k = 2; k < p.size(); ++k) m.triangles.push_back({p[0], p[k - 1], p[k]});
    if (body_of_triangle != nullptr && !file.body.empty())
      body_of_triangle->insert(body_of_triangle->end(), p.size() - 2, file.body[i]);
  }
  return m;
}

TriangleMesh read_mesh(const std::filesystem::path& path, double unit) {
  return triangulated(read_facets(path), unit);
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& m) {
  require_known(path);
  WholeFile file(path);
  const std::string extension = lower_extension(path);
  if (extension == ".ply") write_ply(file.stream(), m);
  if (extension != ".ply") write_soup(file.stream(), extension, soup_of(m));
  file.commit();
}

}  // namespace tdbd::mesh
