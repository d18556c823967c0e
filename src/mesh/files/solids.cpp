#include "mesh/files/solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include "core/simd.hpp"
#include "mesh/check/nesting.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/check/weld.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/measures.hpp"

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

namespace {

Vec3 normal_of(const std::array<Vec3, 3>& x) {
  return area_vector(x[0], x[1], x[2]).stableNormalized();
}

/// Appends a facet of a binary STL: the normal, three corners and two bytes.
void append_binary_facet(std::string& bytes, const std::array<Vec3, 3>& corners,
                         const FileCoordinates& c) {
  static_assert(std::endian::native == std::endian::little, "records are written as they lie");
  Eigen::Matrix<Single, 3, 4> numbers;
  numbers.col(0) = normal_of(corners).cast<Single>();
  for (std::size_t k = 0; k < 3; ++k)
    numbers.col(static_cast<Eigen::Index>(k) + 1) = c.value(corners[k]).cast<Single>();
  bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
  bytes.append(2, '\0');
}

}  // namespace

Vec3 FileCoordinates::value(const Vec3& x) const {
  if (const auto at = known.find({x.x(), x.y(), x.z()}); at != known.end()) return at->second;
  return unit ? Vec3(x / unit->metres) : x;
}

std::string FileCoordinates::text(const Vec3& x) const {
  const bool is_known = known.contains({x.x(), x.y(), x.z()});
  const bool is_decimal = !is_known && unit && unit->power;
  const Vec3 v = is_decimal ? x : value(x);
  const int power = is_decimal ? *unit->power : 0;
  return fmt::format("{} {} {}", decimal_text(v.x(), power), decimal_text(v.y(), power),
                     decimal_text(v.z(), power));
}

void write_text_stl(std::ostream& out, const std::vector<Solid>& solids, const FileCoordinates& c) {
  for (const Solid& solid : solids) {
    const std::string name = c.unit ? name_with_unit(solid.name, *c.unit) : solid.name;
    std::string text = fmt::format("solid {}\n", name);
    for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
      const std::array<Vec3, 3> x = corners(solid.mesh, i);
      const Vec3 n = normal_of(x);
      fmt::format_to(std::back_inserter(text), "facet normal {:.6g} {:.6g} {:.6g}\nouter loop\n",
                     n.x(), n.y(), n.z());
      for (const Vec3& corner : x) text += "vertex " + c.text(corner) + '\n';
      text += "endloop\nendfacet\n";
    }
    out << text << fmt::format("endsolid {}\n", name);
  }
}

void write_binary_stl(std::ostream& out, const std::vector<Solid>& solids,
                      const FileCoordinates& c) {
  constexpr std::size_t title_bytes = 80;
  std::string bytes = c.unit ? unit_comment(*c.unit) : "tdbd";
  bytes.resize(title_bytes, ' ');
  const TriangleMesh all = merged(solids);
  const auto facets = static_cast<std::uint32_t>(all.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&facets), sizeof facets);
  for (std::size_t i = 0; i < all.triangles.size(); ++i)
    append_binary_facet(bytes, corners(all, i), c);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void write_obj(std::ostream& out, const std::vector<Solid>& solids, const FileCoordinates& c) {
  if (c.unit) out << "# " << unit_comment(*c.unit) << '\n';
  int first = 1;  // OBJ counts vertices from 1 over the whole file
  for (const Solid& solid : solids) {
    std::string text = solid.name.empty() ? "" : fmt::format("g {}\n", solid.name);
    for (const Vec3& x : solid.mesh.positions) text += "v " + c.text(x) + '\n';
    for (const Triangle& t : solid.mesh.triangles)
      fmt::format_to(std::back_inserter(text), "f {} {} {}\n", first + t[0], first + t[1],
                     first + t[2]);
    out << text;
    first += static_cast<int>(solid.mesh.positions.size());
  }
}

void write_off(std::ostream& out, const std::vector<Solid>& solids, const FileCoordinates& c) {
  const TriangleMesh all = merged(solids);
  out << "OFF\n";
  if (c.unit) out << "# " << unit_comment(*c.unit) << '\n';
  std::string text = fmt::format("{} {} 0\n", all.positions.size(), all.triangles.size());
  for (const Vec3& x : all.positions) text += c.text(x) + '\n';
  for (const Triangle& t : all.triangles)
    fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", t[0], t[1], t[2]);
  out << text;
}

TriangleMesh in_single_precision(const TriangleMesh& m, const FileCoordinates& c) {
  TriangleMesh rounded;
  rounded.positions.reserve(m.positions.size());
  for (const Vec3& x : m.positions)
    rounded.positions.push_back(c.value(x).cast<Single>().cast<double>());
  rounded.triangles = m.triangles;
  rounded.triangles = merge_equal_vertices(rounded);
  return rounded;
}

}  // namespace tdbd::mesh
