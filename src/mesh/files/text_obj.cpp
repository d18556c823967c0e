#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "mesh/files/facet_file.hpp"
#include "mesh/files/text_lines.hpp"

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

FacetFile read_obj(std::istream& in, const std::string& path) {
  FacetFile file;
  TextLines lines(in, path);
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

}  // namespace tdbd::mesh
