#include "mesh/files/facet_file.hpp"
#include "mesh/files/merged_points.hpp"
#include "mesh/files/text_lines.hpp"

namespace tdbd::mesh {
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

}  // namespace

FacetFile read_text_stl(std::istream& in, const std::string& path) {
  FacetFile file;
  TextLines lines(in, path);
  while (lines.next()) {
    if (lines.words()[0] != "solid") lines.fail('\'' + lines.words()[0] + '\'', "'solid NAME'");
    file.names.push_back(lines.rest());
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
