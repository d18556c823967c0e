#include <fmt/format.h>

#include <array>

#include "mesh/files/facet_file.hpp"
#include "mesh/files/text_cursor.hpp"

namespace tdbd::mesh {
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

FacetFile read_off(std::string_view text, const std::string& path) {
  TextCursor in(text, path);
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
