#include "mesh/files/write_facets.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>

#include "core/simd.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

Vec3 normal_of(const std::array<Vec3, 3>& x) {
  return area_vector(x[0], x[1], x[2]).stableNormalized();
}

std::string number_text(double x) { return fmt::format("{}", x); }

/// Appends a facet of a binary STL: the normal, three corners and two bytes.
void append_binary_facet(std::string& bytes, const std::array<Vec3, 3>& corners,
                         const FileCoordinates& c) {
  static_assert(std::endian::native == std::endian::little, "records are written as they lie");
  std::array<Single, 12> numbers{};
  std::size_t k = 0;
  const auto put = [&](const Vec3& x) {
    for (const double value : {x.x(), x.y(), x.z()}) numbers[k++] = static_cast<Single>(value);
  };
  put(normal_of(corners));
  for (const Vec3& x : corners) put(c.value(x));
  std::array<char, sizeof numbers> raw{};
  std::memcpy(raw.data(), numbers.data(), raw.size());
  bytes.append(raw.begin(), raw.end());
  bytes.append(2, '\0');
}

}  // namespace

Vec3 FileCoordinates::value(const Vec3& x) const {
  if (const auto at = known.find({x.x(), x.y(), x.z()}); at != known.end()) return at->second;
  return unit ? Vec3(x / unit->metres) : x;
}

std::string FileCoordinates::text(const Vec3& x) const {
  const auto at = known.find({x.x(), x.y(), x.z()});
  if (at == known.end() && unit && unit->power)
    return fmt::format("{} {} {}", decimal_text(x.x(), *unit->power),
                       decimal_text(x.y(), *unit->power), decimal_text(x.z(), *unit->power));
  const Vec3 v = value(x);
  return fmt::format("{} {} {}", number_text(v.x()), number_text(v.y()), number_text(v.z()));
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
  std::uint32_t facets = 0;
  for (const Solid& solid : solids)
    facets += static_cast<std::uint32_t>(solid.mesh.triangles.size());
  std::array<char, sizeof facets> count{};
  std::memcpy(count.data(), &facets, count.size());
  bytes.append(count.begin(), count.end());
  for (const Solid& solid : solids)
    for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i)
      append_binary_facet(bytes, corners(solid.mesh, i), c);
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
  std::size_t points = 0, facets = 0;
  for (const Solid& solid : solids) {
    points += solid.mesh.positions.size();
    facets += solid.mesh.triangles.size();
  }
  out << "OFF\n";
  if (c.unit) out << "# " << unit_comment(*c.unit) << '\n';
  std::string text = fmt::format("{} {} 0\n", points, facets);
  for (const Solid& solid : solids)
    for (const Vec3& x : solid.mesh.positions) text += c.text(x) + '\n';
  int first = 0;
  for (const Solid& solid : solids) {
    for (const Triangle& t : solid.mesh.triangles)
      fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", first + t[0], first + t[1],
                     first + t[2]);
    first += static_cast<int>(solid.mesh.positions.size());
  }
  out << text;
}

TriangleMesh in_single_precision(const TriangleMesh& m, const FileCoordinates& c) {
  TriangleMesh rounded;
  rounded.positions.reserve(m.positions.size());
  for (const Vec3& x : m.positions) {
    const Vec3 v = c.value(x);
    rounded.positions.push_back(Vec3(static_cast<double>(static_cast<Single>(v.x())),
                                     static_cast<double>(static_cast<Single>(v.y())),
                                     static_cast<double>(static_cast<Single>(v.z()))));
  }
  rounded.triangles = m.triangles;
  rounded.triangles = merge_equal_vertices(rounded);
  return rounded;
}

}  // namespace tdbd::mesh
