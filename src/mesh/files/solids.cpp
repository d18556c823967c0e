#include "mesh/files/solids.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "mesh/check/self_intersections.hpp"
#include "mesh/check/weld.hpp"
#include "mesh/files/write_facets.hpp"

namespace tdbd::mesh {
namespace {

/// The triangles of each body.
std::vector<std::vector<int>> by_body(const std::vector<int>& body_of_triangle,
                                      std::size_t bodies) {
  std::vector<std::vector<int>> triangles(bodies);
  for (std::size_t i = 0; i < body_of_triangle.size(); ++i)
    triangles[at(body_of_triangle[i])].push_back(static_cast<int>(i));
  return triangles;
}

}  // namespace

std::vector<Solid> read_solids(const std::filesystem::path& path, double unit, double weld) {
  const FacetFile file = read_facets(path);
  std::vector<int> body_of_triangle;
  TriangleMesh all = triangulated(file, path, unit, &body_of_triangle);
  std::vector<Solid> solids;
  if (file.names.empty()) {
    if (weld > 0.0) weld_points(all, weld);
    std::vector<TriangleMesh> pieces = divide(all);
    solids.reserve(pieces.size());
    for (TriangleMesh& piece : pieces)
      solids.push_back({fmt::format("solid-{}", solids.size() + 1), std::move(piece)});
    return solids;
  }
  const auto triangles = by_body(body_of_triangle, file.names.size());
  solids.reserve(file.names.size());
  for (std::size_t b = 0; b < file.names.size(); ++b)
    solids.push_back({file.names[b], submesh(all, triangles[b])});
  return solids;
}

void write_solids(const std::filesystem::path& path, const std::vector<Solid>& solids,
                  const SolidFormat& format) {
  write_bodies(path, solids, {format.unit, {}}, format.stl);
}

void write_like(const std::filesystem::path& path, const std::vector<Solid>& solids,
                const SolidFormat& format, const std::filesystem::path& original, double unit) {
  FileCoordinates coordinates{format.unit, {}};
  const FacetFile file = read_facets(original);
  const bool same_unit = !format.unit || format.unit->name == length_unit_of(unit).name;
  if (same_unit && file.points_are == FacetFile::Points::in_file_unit)
    for (const Vec3& x : file.points) {
      const Vec3 in_m = unit * x;
      coordinates.known.try_emplace({in_m.x(), in_m.y(), in_m.z()}, x);
    }
  write_bodies(path, solids, coordinates, format.stl);
}

}  // namespace tdbd::mesh
