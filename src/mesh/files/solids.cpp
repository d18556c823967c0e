#include "mesh/files/solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/check/nesting.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/check/weld.hpp"
#include "mesh/files/write_facets.hpp"

namespace tdbd::mesh {
namespace {

/// The group of all facets of a body, or solid-NUMBER if they have no common group with a name.
std::string name_of_body(const FacetFile& file, const std::vector<int>& group_of_facet,
                         const std::vector<int>& facets, std::size_t number) {
  const auto group = [&](int i) { return group_of_facet[at(i)]; };
  const bool has_group =
      !file.names.empty() && !file.names[at(group(facets[0]))].empty() &&
      std::ranges::all_of(facets, [&](int i) { return group(i) == group(facets[0]); });
  return has_group ? file.names[at(group(facets[0]))] : fmt::format("solid-{}", number);
}

}  // namespace

std::vector<Solid> read_solids(const std::filesystem::path& path, double unit, double weld,
                               std::vector<std::string>* warnings) {
  const FacetFile file = read_facets(path);
  if (warnings != nullptr) *warnings = file.warnings;
  std::vector<int> name_of_facet;
  TriangleMesh all = triangulated(file, path, unit, &name_of_facet);
  std::vector<Solid> solids;
  if (file.names_are == FacetFile::Names::groups || file.names.empty()) {
    if (weld > 0.0) weld_points(all, weld, file.names.empty() ? nullptr : &name_of_facet);
    for (const std::vector<int>& facets : facets_of_bodies(all, name_of_facet))
      solids.push_back(
          {name_of_body(file, name_of_facet, facets, solids.size() + 1), submesh(all, facets)});
    return solids;
  }
  std::vector<std::vector<int>> facets(file.names.size());
  for (std::size_t i = 0; i < all.triangles.size(); ++i)
    facets[at(name_of_facet[i])].push_back(static_cast<int>(i));
  for (std::size_t b = 0; b < facets.size(); ++b)
    solids.push_back({file.names[b], submesh(all, facets[b])});
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
