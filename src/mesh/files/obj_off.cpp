#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>

#include "mesh/files/facet_file.hpp"
#include "mesh/files/text_reader.hpp"

namespace tdbd::mesh {
namespace {

/// Statements that do not affect the shape.
bool is_ignored(const std::string& word) {
  constexpr const char* known[] = {"vt", "vn",     "vp",     "s", "mg", "usemtl",
                                   "l",  "mtllib", "usemap", "p", "lod"};
  return std::find(std::begin(known), std::end(known), word) != std::end(known);
}

/// The index of the point that a word such as "7", "7/1/2" or "-1" (the last point so far) refers
/// to.
int corner(const TextLines& lines, const std::string& word, int points) {
  const std::string number = word.substr(0, word.find('/'));
  int i = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), i);
  if (error != std::errc() || end != number.data() + number.size() || i == 0)
    lines.fail('\'' + word + '\'', "the number of a vertex, 1 or more, or counted back from -1");
  const int v = i > 0 ? i - 1 : points + i;
  if (v < 0 || v >= points)
    lines.fail(fmt::format("a polygon names vertex {} of {}", v, points),
               fmt::format("one of the {} vertices above", points));
  return v;
}

std::vector<int> read_polygon(const TextLines& lines, int points) {
  std::vector<int> polygon;
  polygon.reserve(lines.words().size() - 1);
  for (std::size_t k = 1; k < lines.words().size(); ++k)
    polygon.push_back(corner(lines, lines.words()[k], points));
  if (polygon.size() < 3)
    lines.fail(fmt::format("a polygon with {} corners", polygon.size()), "three or more");
  return polygon;
}

/// Returns the body with this name, and adds it if it is new. A group may be continued later in the
/// file.
int body_named(FacetFile& file, const std::string& name) {
  const auto known = std::find(file.names.begin(), file.names.end(), name);
  if (known != file.names.end()) return static_cast<int>(known - file.names.begin());
  file.names.push_back(name);
  return static_cast<int>(file.names.size()) - 1;
}

/// Removes groups without facets. If the only body has no name, the file has no named bodies.
void drop_empty_bodies(FacetFile& file) {
  std::vector<int> number(file.names.size(), -1);
  for (const int b : file.body) number[at(b)] = 0;
  std::vector<std::string> used;
  for (std::size_t b = 0; b < number.size(); ++b)
    if (number[b] == 0) {
      number[b] = static_cast<int>(used.size());
      used.push_back(file.names[b]);
    }
  for (int& b : file.body) b = number[at(b)];
  file.names = used;
  if (used.size() == 1 && used[0].empty()) {
    file.names.clear();
    file.body.clear();
  }
}

}  // namespace

FacetFile read_obj(std::istream& in, const std::string& path, int power) {
  FacetFile file;
  TextLines lines(in, path, power);
  std::string name;
  while (lines.next()) {
    const std::string& word = lines.words()[0];
    if (word == "v") {
      file.points.push_back(lines.point(1));
    } else if (word == "f") {
      file.polygons.push_back(read_polygon(lines, static_cast<int>(file.points.size())));
      file.body.push_back(body_named(file, name));
    } else if (word == "g" || word == "o") {
      name = lines.rest();
    } else if (!is_ignored(word)) {
      lines.fail('\'' + word + '\'', "a statement of an OBJ file (v, f, g, o, ...)");
    }
  }
  drop_empty_bodies(file);
  return file;
}

namespace {

/// Reads the keyword: OFF with 3-D points. The prefixes ST, C and N mean that texture coordinates,
/// colours and normals follow the coordinates.
void read_off_keyword(TextCursor& in) {
  constexpr std::array known = {"OFF",   "COFF",   "NOFF",   "CNOFF",
                                "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  constexpr auto expected = "'OFF': text, with points of three coordinates";
  const std::string_view word = in.word(expected);
  bool is_known = false;
  for (const std::string_view name : known) is_known = is_known || word == name;
  if (!is_known) in.fail(fmt::format("'{}'", word), expected);
  if (in.word_on_this_line() == "BINARY") in.fail("'BINARY'", expected);
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
  constexpr long first_line = 1;
  TextCursor in(text, path, first_line, power);
  read_off_keyword(in);
  const std::size_t points = off_count(in, "vertices", sizeof "0 0 0" - 1);
  const std::size_t polygons = off_count(in, "facets", sizeof "3 0 0 0" - 1);
  in.end_line();
  FacetFile file;
  file.points.reserve(points);
  file.polygons.reserve(polygons);
  for (std::size_t i = 0; i < points; ++i) {
    const double x = in.number(), y = in.number(), z = in.number();
    file.points.push_back(Vec3(x, y, z));
    in.end_line();
  }
  for (std::size_t i = 0; i < polygons; ++i) {
    file.polygons.push_back(off_polygon(in, points));
    in.end_line();
  }
  return file;
}

}  // namespace tdbd::mesh
