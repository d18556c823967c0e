#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <vector>

#include "core/error.hpp"
#include "core/simd.hpp"
#include "core/types.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/text_reader.hpp"

namespace tdbd::mesh {
namespace {

/// Appends points to a list and stores equal points once. Coordinates must be finite.
class MergedPoints {
 public:
  explicit MergedPoints(std::vector<Vec3>& all) : all_(all) {}

  /// Returns the index of x in the list.
  int add(const Vec3& x) {
    const auto [place, is_new] =
        number_.try_emplace({x.x(), x.y(), x.z()}, static_cast<int>(all_.size()));
    if (is_new) all_.push_back(x);
    return place->second;
  }

 private:
  std::vector<Vec3>& all_;
  std::map<std::array<double, 3>, int> number_;
};

/// The head is 80 arbitrary bytes and the number of facets. A facet is a normal, three vertices and
/// two bytes.
constexpr std::size_t stl_head = 84, stl_facet = 50, stl_normal = 12, stl_vertex = 12;

[[noreturn]] void reject_stl(const std::string& path, const std::string& reason) {
  throw InputError(fmt::format("{}: {}", path, reason));
}

std::size_t declared_facets(std::string_view bytes) {
  std::uint32_t facets = 0;
  std::memcpy(&facets, bytes.data() + 80, sizeof facets);
  return facets;
}

Vec3 stl_point(const char* at) {
  Single x[3];
  std::memcpy(x, at, sizeof x);
  return {x[0], x[1], x[2]};
}

}  // namespace

StlKind stl_kind(std::string_view bytes, const std::string& path) {
  const bool has_head = bytes.size() >= stl_head;
  const std::size_t expected = has_head ? stl_head + stl_facet * declared_facets(bytes) : stl_head;
  if (has_head && bytes.size() == expected) return StlKind::binary;
  if (bytes.empty() || bytes.starts_with("solid")) return StlKind::text;
  if (!has_head) reject_stl(path, "not a valid .stl file: neither text nor a binary header");
  reject_stl(path, fmt::format("truncated or no STL: {} bytes, expected {} for {} facets",
                               bytes.size(), expected, declared_facets(bytes)));
}

FacetFile read_binary_stl(std::string_view bytes, const std::string& path) {
  FacetFile file;
  MergedPoints points(file.points);
  const std::size_t facets = declared_facets(bytes);
  file.polygons.reserve(facets);
  for (std::size_t i = 0; i < facets; ++i) {
    std::vector<int>& corners = file.polygons.emplace_back(3);
    const char* at = bytes.data() + stl_head + stl_facet * i + stl_normal;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 x = stl_point(at + stl_vertex * k);
      if (!x.allFinite())
        reject_stl(path,
                   fmt::format("facet {}: found a vertex at ({}, {}, {}), expected finite numbers",
                               i, x.x(), x.y(), x.z()));
      corners[k] = points.add(x);
    }
  }
  return file;
}

namespace {

/// Moves to the next line and checks its first word. At the end of the file, the error message has
/// the number of the last line.
void require(TextLines& lines, const char* word, const char* expected) {
  if (!lines.next()) lines.fail("the end of the file", expected);
  if (lines.words()[0] != word) lines.fail('\'' + lines.words()[0] + '\'', expected);
}

std::vector<int> read_facet(TextLines& lines, MergedPoints& points) {
  require(lines, "outer", "'outer loop'");
  std::vector<int> corners(3);
  for (int& corner : corners) {
    require(lines, "vertex", "'vertex' and three numbers");
    corner = points.add(lines.point(1));
  }
  require(lines, "endloop", "'endloop': a facet has three vertices");
  require(lines, "endfacet", "'endfacet'");
  return corners;
}

/// Reads the name of a solid without the unit, which the first solid states for the whole file.
std::string name_of_solid(const TextLines& lines, FacetFile& file) {
  std::string name = lines.rest();
  const auto unit = take_unit_of_name(name);
  if (file.names.empty()) file.unit = unit;
  const auto text = [](const auto& u) { return u ? "unit=" + u->name : std::string("no unit"); };
  if (text(unit) != text(file.unit))
    lines.fail(text(unit), text(file.unit) + ", as in the line of the first solid");
  return name;
}

}  // namespace

FacetFile read_text_stl(std::istream& in, const std::string& path, int power) {
  FacetFile file;
  TextLines lines(in, path, power);
  while (lines.next()) {
    if (lines.words()[0] != "solid") lines.fail('\'' + lines.words()[0] + '\'', "'solid NAME'");
    file.names.push_back(name_of_solid(lines, file));
    MergedPoints points(file.points);
    for (;;) {
      if (!lines.next()) lines.fail("the end of the file", "'facet' or 'endsolid'");
      if (lines.words()[0] == "endsolid") break;
      if (lines.words()[0] != "facet")
        lines.fail('\'' + lines.words()[0] + '\'', "'facet' or 'endsolid'");
      file.polygons.push_back(read_facet(lines, points));
      file.body.push_back(static_cast<int>(file.names.size()) - 1);
    }
  }
  return file;
}

}  // namespace tdbd::mesh
