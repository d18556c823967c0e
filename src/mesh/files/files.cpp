#include "mesh/files/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/text.hpp"
#include "io/whole_file.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/ply.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/files/text_reader.hpp"
#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

/// A triangle of lower quality has no area up to rounding, as in check_closed.
constexpr double flat_quality = 1e-14;

/// A polygon being cut. The corners that are left are counter-clockwise about `normal`.
struct Ring {
  const std::vector<Vec3>& points;
  Vec3 normal;
  std::vector<int> corners;

  const Vec3& x(std::size_t k) const { return points[at(corners[k % corners.size()])]; }
};

/// Twice the area of a triangle as seen along the normal; positive if it is counter-clockwise.
double turn(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) {
  return normal.dot((b - a).cross(c - a));
}

bool is_proper(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) {
  return turn(normal, a, b, c) > 0.0 && triangle_quality(a, b, c) >= flat_quality;
}

/// Area vector of a polygon (Newell). Its first corner is the origin, which keeps rounding small.
Vec3 polygon_area(const std::vector<Vec3>& points, const std::vector<int>& corners) {
  Vec3 sum = Vec3::Zero();
  const Vec3& a = points[at(corners[0])];
  for (std::size_t k = 2; k < corners.size(); ++k)
    sum += area_vector(a, points[at(corners[k - 1])], points[at(corners[k])]);
  return sum;
}

/// Whether the triangle at corner k can be cut off: it is proper, and no other corner is in it or
/// on its sides. Corners at the position of one of its own do not count: two parts of a boundary
/// may touch, as in a polygon around a hole.
bool is_ear(const Ring& ring, std::size_t k) {
  const std::size_t n = ring.corners.size();
  const Vec3 &a = ring.x(k + n - 1), &b = ring.x(k), &c = ring.x(k + 1);
  if (!is_proper(ring.normal, a, b, c)) return false;
  for (std::size_t other = 2; other + 1 < n; ++other) {
    const Vec3& p = ring.x(k + other);
    if (p == a || p == b || p == c) continue;
    if (turn(ring.normal, a, b, p) >= 0.0 && turn(ring.normal, b, c, p) >= 0.0 &&
        turn(ring.normal, c, a, p) >= 0.0)
      return false;
  }
  return true;
}

/// Cuts ears until a triangle is left. Returns whether that succeeded.
bool cut_ears(Ring ring, std::vector<Triangle>& triangles) {
  for (std::size_t k = 0, failed = 0; ring.corners.size() > 3;) {
    const std::size_t n = ring.corners.size();
    if (failed == n) return false;
    if (!is_ear(ring, k)) {
      k = (k + 1) % n;
      ++failed;
      continue;
    }
    triangles.push_back(
        {ring.corners[(k + n - 1) % n], ring.corners[k], ring.corners[(k + 1) % n]});
    ring.corners.erase(ring.corners.begin() + static_cast<std::ptrdiff_t>(k));
    k %= n - 1;  // the corner after the ear, so that ears are not all cut at one corner
    failed = 0;
  }
  triangles.push_back({ring.corners[0], ring.corners[1], ring.corners[2]});
  return is_proper(ring.normal, ring.x(0), ring.x(1), ring.x(2));
}

/// Splits a simple polygon into triangles without new points and appends them. `corners` are
/// indices into `points`, at least three, counter-clockwise seen from outside; the triangles have
/// the same sense. A polygon whose fan about its first corner consists of proper triangles is split
/// into that fan. Any other, such as a concave one or one with corners on its sides, is split by
/// cutting ears in the plane of its area vector (Meisters 1975). A polygon without area, one that
/// crosses itself, and a concave one with more than 2000 corners become fans; the checks of the
/// mesh then report the triangles that are wrong.
void triangulate_polygon(const std::vector<Vec3>& points, const std::vector<int>& corners,
                         std::vector<Triangle>& triangles) {
  constexpr std::size_t most_corners = 2000;  // the run time grows with the square
  const std::size_t before = triangles.size(), n = corners.size();
  const auto fan = [&] {
    triangles.resize(before);
    for (std::size_t k = 2; k < n; ++k)
      triangles.push_back({corners[0], corners[k - 1], corners[k]});
  };
  fan();
  if (n == 3) return;
  const Vec3 normal = polygon_area(points, corners).stableNormalized();
  const bool fan_is_proper =
      std::all_of(triangles.begin() + static_cast<std::ptrdiff_t>(before), triangles.end(),
                  [&](const Triangle& t) {
                    return is_proper(normal, points[at(t[0])], points[at(t[1])], points[at(t[2])]);
                  });
  if (fan_is_proper || n > most_corners) return;
  triangles.resize(before);
  if (!cut_ears({points, normal, corners}, triangles)) fan();
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

void require_known(const std::filesystem::path& path) {
  if (const std::string e = lower_extension(path);
      e != ".stl" && e != ".obj" && e != ".ply" && e != ".off")
    fail_to_read(path,
                 fmt::format("unknown mesh format '{}', expected .stl, .obj, .ply or .off", e));
}

void require_sound(const std::filesystem::path& path, const FacetFile& file) {
  if (file.polygons.empty()) fail_to_read(path, "no triangles");
  for (std::size_t i = 0; i < file.polygons.size(); ++i)
    for (const int v : file.polygons[i])
      if (v < 0 || v >= static_cast<int>(file.points.size()))
        fail_to_read(path, fmt::format("facet {}: a polygon names vertex {} of {}", i, v,
                                       file.points.size()));
}

/// Squares and volumes of larger coordinates would overflow. NaN is rejected as well.
void require_small(const std::filesystem::path& path, const std::vector<Vec3>& points) {
  for (std::size_t v = 0; v < points.size(); ++v)
    if (const Vec3& x = points[v]; !(x.cwiseAbs().maxCoeff() <= largest_coordinate))
      fail_to_read(path, fmt::format("vertex {}: found a position of ({}, {}, {}) m, expected "
                                     "coordinates up to {} m",
                                     v, x.x(), x.y(), x.z(), largest_coordinate));
}

/// Old files end their lines with CR alone.
void use_newlines(std::string& bytes) {
  if (bytes.find('\n') == std::string::npos) std::ranges::replace(bytes, '\r', '\n');
}

FacetFile read_any(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path), name = path.string();
  std::string bytes = read_file(path, "a mesh file");
  const auto unit = stated_unit(bytes, extension);
  FacetFile file;
  if (extension == ".stl" && stl_kind(bytes, name) == StlKind::binary) {
    file = read_binary_stl(bytes, name);
  } else if (use_newlines(bytes); extension == ".ply") {
    file = read_ply(without_mark(bytes), name);
  } else {
    const auto power = unit ? unit->power : std::nullopt;
    const auto read = extension == ".off"   ? read_off
                      : extension == ".obj" ? read_obj
                                            : read_text_stl;
    file = read(without_mark(bytes), name, power.value_or(0));
    if (power) file.points_are = FacetFile::Points::in_m;
  }
  file.unit = unit;
  for (std::string& n : file.names) n = utf8_or_latin1(std::move(n));
  return file;
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
  if (const std::string found = unit_contradiction(path, file.unit, unit); !found.empty())
    fail_to_read(path, fmt::format("found the unit {}", found));
  const double scale = file.points_are == FacetFile::Points::in_m ? 1.0 : unit;
  TriangleMesh m;
  m.positions.reserve(file.points.size());
  for (const Vec3& x : file.points) m.positions.push_back(scale * x);
  require_small(path, m.positions);
  for (std::size_t i = 0; i < file.polygons.size(); ++i) {
    const std::vector<int>& p = file.polygons[i];
    triangulate_polygon(m.positions, p, m.triangles);
    if (body_of_triangle != nullptr && !file.body.empty())
      body_of_triangle->insert(body_of_triangle->end(), p.size() - 2, file.body[i]);
  }
  return m;
}

TriangleMesh read_mesh(const std::filesystem::path& path, double unit,
                       std::vector<std::string>* warnings) {
  FacetFile file = read_facets(path);
  if (warnings != nullptr) *warnings = std::move(file.warnings);
  return triangulated(file, path, unit);
}

TriangleMesh merged(const std::vector<Solid>& solids) {
  TriangleMesh all;
  for (const Solid& solid : solids) {
    const int first = static_cast<int>(all.positions.size());
    all.positions.insert(all.positions.end(), solid.mesh.positions.begin(),
                         solid.mesh.positions.end());
    for (const Triangle& t : solid.mesh.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

void write_bodies(const std::filesystem::path& path, const std::vector<Solid>& solids,
                  const FileCoordinates& c, StlKind stl) {
  require_known(path);
  AtomicFile file(path);
  const std::string extension = lower_extension(path);
  if (extension == ".ply") {
    TriangleMesh all = merged(solids);
    for (Vec3& x : all.positions) x = c.value(x);
    write_ply(file.stream(), all,
              std::vector<std::string>(c.unit ? 1 : 0, c.unit ? unit_comment(*c.unit) : ""));
  }
  if (extension == ".obj") write_obj(file.stream(), solids, c);
  if (extension == ".off") write_off(file.stream(), solids, c);
  if (extension == ".stl" && stl == StlKind::text) write_text_stl(file.stream(), solids, c);
  if (extension == ".stl" && stl == StlKind::binary) write_binary_stl(file.stream(), solids, c);
  file.commit();
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& m,
                const std::optional<LengthUnit>& unit) {
  const auto format = lower_extension(path) == ".stl" ? StlKind::binary : StlKind::text;
  write_bodies(path, {{"", m}}, {unit, {}}, format);
}

}  // namespace tdbd::mesh
