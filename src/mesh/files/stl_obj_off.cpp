#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
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

namespace {

/// Statements that do not affect the facets: attributes of vertices and of the display, free-form
/// curves and surfaces, points and lines.
bool is_ignored(std::string_view word) {
  constexpr std::string_view known =
      " vn vt vp s l p usemtl mtllib usemap maplib mg lod bevel c_interp d_interp shadow_obj "
      "trace_obj ctech stech cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con "
      "res bsp bzp cdc cdp ";
  return word == "vn" || word == "vt" || known.find(fmt::format(" {} ", word)) != known.npos;
}

/// The index of the point that a word such as "7", "7/1/2" or "-1" (the last point so far) refers
/// to.
int corner(const TextCursor& in, std::string_view word, int points) {
  const std::string_view number = word.substr(0, word.find('/'));
  int i = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), i);
  if (error != std::errc() || end != number.data() + number.size() || i == 0)
    in.fail(quoted(word), "the number of a vertex, 1 or more, or counted back from -1");
  const int v = i > 0 ? i - 1 : points + i;
  if (v < 0 || v >= points)
    in.fail(fmt::format("a polygon names vertex {} of {}", v, points),
            fmt::format("one of the {} vertices above", points));
  return v;
}

std::vector<int> obj_polygon(TextCursor& in, int points) {
  std::vector<int> polygon;
  for (auto word = in.word_on_this_line(); !word.empty(); word = in.word_on_this_line()) {
    polygon.push_back(corner(in, word, points));
    in.skip(word.size());
  }
  if (polygon.size() < 3)
    in.fail(fmt::format("a polygon with {} corners", polygon.size()), "three or more");
  return polygon;
}

}  // namespace

FacetFile read_obj(std::string_view text, const std::string& path, int power) {
  FacetFile file;
  file.names_are = FacetFile::Names::groups;
  TextCursor in(text, path, 1, power);
  std::map<std::string, int> groups = {{"", 0}};  // may continue later in the file
  file.names = {""};
  int group = 0;
  while (in.to_next_word()) {
    const std::string_view word = in.word("a statement");
    if (word == "v") {
      file.points.push_back(in.point());
    } else if (word == "f" || word == "fo") {
      file.polygons.push_back(obj_polygon(in, static_cast<int>(file.points.size())));
      file.body.push_back(group);
    } else if (word == "g" || word == "o") {
      const std::string name(in.rest_of_line());
      const auto [known, is_new] = groups.try_emplace(name, static_cast<int>(groups.size()));
      if (is_new) file.names.push_back(name);
      group = known->second;
      continue;
    } else if (!is_ignored(word)) {
      in.fail(quoted(word), "a statement of an OBJ file (v, f, g, o, ...)");
    }
    in.end_line();
  }
  return file;
}

namespace {

/// Reads the keyword: OFF with 3-D points. The prefixes ST, C and N mean that texture coordinates,
/// colours and normals follow the coordinates. The keyword may be missing, and the counts may
/// follow it without a blank. Returns how many numbers a vertex has.
std::size_t read_off_keyword(TextCursor& in) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 9> known = {{{"", 3},
                                                                              {"off", 3},
                                                                              {"coff", 7},
                                                                              {"noff", 6},
                                                                              {"cnoff", 10},
                                                                              {"stoff", 5},
                                                                              {"stcoff", 9},
                                                                              {"stnoff", 8},
                                                                              {"stcnoff", 12}}};
  constexpr auto expected = "'OFF': text, with points of three coordinates";
  if (!in.to_next_word()) in.fail("the end of the file", expected);
  const std::string_view word = in.word_on_this_line();
  const std::string_view keyword = word.substr(0, word.find_last_not_of("0123456789") + 1);
  const auto found = std::ranges::find_if(
      known, [&](const auto& name) { return is_keyword(keyword, name.first); });
  if (found == known.end()) in.fail(quoted(word), expected);
  in.skip(keyword.size());
  if (is_keyword(in.word_on_this_line(), "binary")) in.fail("'BINARY'", expected);
  return found->second;
}

/// Reads a count of the header for items that take at least `bytes` each, and checks it against the
/// bytes that are left.
std::size_t off_count(TextCursor& in, const char* what, std::size_t bytes) {
  const auto count = static_cast<std::size_t>(in.whole(fmt::format("the number of {}", what)));
  const std::size_t most = in.left() / bytes;
  if (count > most)
    in.fail(fmt::format("{} {} in the {} bytes that follow", count, what, in.left()),
            fmt::format("at most {}", most));
  return count;
}

/// Whether each item of a list starts a line, so that the rest of its last line can be ignored.
/// Otherwise items follow each other without regard to line ends.
enum class Layout { lines, run_on };

/// Decides on lines if the file has enough of them for the items that are left, and if the next one
/// has enough words for the start of an item. `in` is a copy.
Layout layout_of(TextCursor in, std::size_t items, std::size_t words_of_item) {
  std::size_t lines = 0, words = 0;
  in.to_next_word();
  for (TextCursor first = in; !first.word_on_this_line().empty(); ++words)
    first.skip(first.word_on_this_line().size());
  if (words < words_of_item) return Layout::run_on;
  for (; lines < items && in.to_next_word(); ++lines) in.end_line();
  return lines < items ? Layout::run_on : Layout::lines;
}

std::vector<int> off_polygon(TextCursor& in, std::size_t points) {
  const std::int64_t corners = in.whole("the number of corners");
  if (corners < 3) in.fail(fmt::format("a polygon with {} corners", corners), "three or more");
  if (static_cast<std::size_t>(corners) > in.left())
    in.fail(fmt::format("a polygon with {} corners in the last {} bytes", corners, in.left()),
            "fewer");
  std::vector<int> polygon;
  polygon.reserve(static_cast<std::size_t>(corners));
  for (std::int64_t k = 0; k < corners; ++k) {
    const std::int64_t v = in.whole("the number of a vertex, 0 or more");
    if (static_cast<std::size_t>(v) >= points)
      in.fail(fmt::format("a polygon names vertex {} of {}", v, points), "one of them");
    polygon.push_back(static_cast<int>(v));
  }
  return polygon;
}

}  // namespace

FacetFile read_off(std::string_view text, const std::string& path, int power) {
  TextCursor in(text, path, 1, power);
  const std::size_t numbers = read_off_keyword(in);
  const std::size_t points = off_count(in, "vertices", sizeof "0 0 0" - 1);
  const std::size_t polygons = off_count(in, "facets", sizeof "3 0 0 0" - 1);
  in.skip(in.word_on_this_line().size());  // the number of edges
  FacetFile file;
  file.points.reserve(points);
  file.polygons.reserve(polygons);
  const Layout of_points = layout_of(in, points + polygons, 3);
  for (std::size_t i = 0; i < points; ++i) {
    const double x = in.number(), y = in.number(), z = in.number();
    file.points.push_back(Vec3(x, y, z));
    for (std::size_t k = 3; k < numbers && of_points == Layout::run_on; ++k) in.number();
    if (of_points == Layout::lines) in.end_line();
  }
  const Layout of_polygons = layout_of(in, polygons, 1);
  for (std::size_t i = 0; i < polygons; ++i) {
    file.polygons.push_back(off_polygon(in, points));
    if (of_polygons == Layout::lines) in.end_line();
  }
  return file;
}

}  // namespace tdbd::mesh
