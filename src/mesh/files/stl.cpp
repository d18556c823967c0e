#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <vector>

#include "core/error.hpp"
#include "core/simd.hpp"
#include "core/text.hpp"
#include "core/types.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/text_reader.hpp"

namespace tdbd::mesh {
namespace {

using PointNumbers = std::map<std::array<double, 3>, int>;

/// Returns the number of a finite point, and appends the point if no equal one has a number.
int number_of(PointNumbers& numbers, FacetFile& file, const Vec3& x) {
  const auto next = static_cast<int>(file.points.size());
  const auto [place, is_new] = numbers.try_emplace({x.x(), x.y(), x.z()}, next);
  if (is_new) file.points.push_back(x);
  return place->second;
}

/// The head is 80 arbitrary bytes and a count. A facet is a normal, three vertices and two bytes.
constexpr std::size_t stl_head = 84, stl_facet = 50, stl_normal = 12, stl_vertex = 12;

std::size_t declared_facets(std::string_view bytes) {
  std::uint32_t facets = 0;
  std::memcpy(&facets, bytes.data() + 80, sizeof facets);
  return facets;
}

}  // namespace

bool begins_with_solid(std::string_view bytes) {
  constexpr std::string_view keyword = "solid";
  const std::string_view text = trimmed(without_mark(bytes));
  return is_keyword(text.substr(0, keyword.size()), keyword);
}

StlKind stl_kind(std::string_view bytes, const std::string& path) {
  const bool has_head = bytes.size() >= stl_head;
  const std::size_t facets = has_head ? declared_facets(bytes) : 0;
  const std::size_t expected = stl_head + stl_facet * facets;
  if (has_head && bytes.size() == expected) return StlKind::binary;
  constexpr std::size_t start = 512;  // of a binary file: has a zero byte, which no text has
  if (begins_with_solid(bytes) && bytes.substr(0, start).find('\0') == std::string_view::npos)
    return StlKind::text;
  if (facets > 0 && bytes.size() > expected) return StlKind::binary;
  if (trimmed(bytes).empty()) return StlKind::text;
  if (!has_head)
    throw InputError(path + ": not a valid .stl file: neither text nor a binary header");
  throw InputError(fmt::format("{}: truncated or no STL: {} bytes, expected {} for {} facets", path,
                               bytes.size(), expected, facets));
}

FacetFile read_binary_stl(std::string_view bytes, const std::string& path) {
  FacetFile file;
  PointNumbers points;
  const std::size_t facets = declared_facets(bytes), size = stl_head + stl_facet * facets;
  if (bytes.size() > size)
    file.warnings.push_back(fmt::format(
        "{}: found {} bytes after the {} facets that the header declares; they are ignored", path,
        bytes.size() - size, facets));
  file.polygons.reserve(facets);
  for (std::size_t i = 0; i < facets; ++i) {
    std::vector<int>& corners = file.polygons.emplace_back(3);
    const char* at = bytes.data() + stl_head + stl_facet * i + stl_normal;
    for (std::size_t k = 0; k < 3; ++k) {
      Eigen::Matrix<Single, 3, 1> raw;
      std::memcpy(raw.data(), at + stl_vertex * k, sizeof raw);
      const Vec3 x = raw.cast<double>();
      if (!x.allFinite())
        throw InputError(
            fmt::format("{}: facet {}: found a vertex at ({}, {}, {}), expected finite numbers",
                        path, i, x.x(), x.y(), x.z()));
      corners[k] = number_of(points, file, x);
    }
  }
  return file;
}

namespace {

void require(TextCursor& in, std::string_view keyword, std::string_view expected) {
  if (const auto found = in.word(expected); !is_keyword(found, keyword))
    in.fail(quoted(found), expected);
}

/// Reads a facet after its first word. The normal is ignored, whatever it is.
void read_facet(TextCursor& in, PointNumbers& points, FacetFile& file) {
  for (auto word = in.word_on_this_line(); !word.empty() && !is_keyword(word, "outer");
       word = in.word_on_this_line())
    in.skip(word.size());
  require(in, "outer", "'outer loop'");
  require(in, "loop", "'outer loop'");
  for (int& corner : file.polygons.emplace_back(3)) {
    require(in, "vertex", "'vertex' and three numbers");
    corner = number_of(points, file, in.point());
  }
  require(in, "endloop", "'endloop': a facet has three vertices");
  require(in, "endfacet", "'endfacet'");
  file.body.push_back(static_cast<int>(file.names.size()) - 1);
}

/// Reads the name of a solid without the unit, which the first solid states for the whole file.
std::string name_of_solid(TextCursor& in, FacetFile& file) {
  std::string name(in.rest_of_line());
  const auto unit = take_unit_of_name(name);
  if (file.names.empty()) file.unit = unit;
  const auto text = [](const auto& u) { return u ? "unit=" + u->name : std::string("no unit"); };
  if (text(unit) != text(file.unit))
    in.fail(text(unit), text(file.unit) + ", as in the line of the first solid");
  return name;
}

}  // namespace

FacetFile read_text_stl(std::string_view text, const std::string& path, int power) {
  constexpr auto expected = "'facet' or 'endsolid'";
  FacetFile file;
  TextCursor in(text, path, 1, power);
  while (in.to_next_word()) {
    require(in, "solid", "'solid NAME'");
    file.names.push_back(name_of_solid(in, file));
    PointNumbers points;
    for (auto word = in.word(expected); !is_keyword(word, "endsolid"); word = in.word(expected)) {
      if (!is_keyword(word, "facet")) in.fail(quoted(word), expected);
      read_facet(in, points, file);
    }
    in.rest_of_line();
  }
  return file;
}

}  // namespace tdbd::mesh
