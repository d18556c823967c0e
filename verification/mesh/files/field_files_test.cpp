#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/simd.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/files.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/measures.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/core/temporary_folder.hpp"

/// Files as other programs write them: each is a cube of 10 units, or a body of known volume.
namespace tdbd::mesh::field_files_test {

namespace fs = std::filesystem;

struct Read {
  std::vector<Solid> solids;
  std::vector<std::string> warnings;
  std::string message;  ///< of the error, without the folder
};

Read read(const std::string& name, const std::string& bytes) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path path = tdbd::temporary_folder() + "tdbd_field_" + test->name() + "_" + name;
  std::ofstream(path, std::ios::binary) << bytes;
  Read found;
  try {
    found.solids = read_solids(path, 1.0, 0.0, &found.warnings);
  } catch (const InputError& e) {
    found.message = e.what();
    if (found.message.starts_with(path.string())) found.message.erase(0, path.string().size());
  }
  return found;
}

/// One sound solid of this volume.
void expect_solid(const Read& found, double volume, const std::string& what) {
  EXPECT_EQ(found.message, "") << what;
  ASSERT_EQ(found.solids.size(), 1u) << what;
  const TriangleMesh& m = found.solids[0].mesh;
  EXPECT_TRUE(check_solid(m).empty()) << what << summarize(check_solid(m));
  EXPECT_NEAR(enclosed_volume(m), volume, 1e-12 * volume) << what;
}

void replace(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t i = text.find(from); i != std::string::npos; i = text.find(from, i + to.size()))
    text.replace(i, from.size(), to);
}

const std::vector<Vec3> cube_points = {{0, 0, 0},  {10, 0, 0},  {0, 10, 0},  {10, 10, 0},
                                       {0, 0, 10}, {10, 0, 10}, {0, 10, 10}, {10, 10, 10}};
const std::vector<std::vector<int>> cube_sides = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

std::string vertices(const std::vector<Vec3>& points, const std::string& start,
                     const std::string& end = "\n") {
  std::ostringstream out;
  for (const Vec3& x : points) out << start << x.x() << ' ' << x.y() << ' ' << x.z() << end;
  return out.str();
}

std::string polygons(const std::vector<std::vector<int>>& sides, bool counted, int first) {
  std::ostringstream out;
  for (const std::vector<int>& side : sides) {
    out << (counted ? std::to_string(side.size()) : "f");
    for (const int v : side) out << ' ' << v + first;
    out << '\n';
  }
  return out.str();
}

std::string text_stl() {
  std::string text = "solid part\n";
  const TriangleMesh m = battery::box({0, 0, 0}, {10, 10, 10});
  for (const Triangle& t : m.triangles)
    text += "  facet normal 0 0 1\n    outer loop\n" +
            vertices({position(m, t[0]), position(m, t[1]), position(m, t[2])}, "      vertex ") +
            "    endloop\n  endfacet\n";
  return text + "endsolid part\n";
}

std::string binary_stl(const std::string& title) {
  const TriangleMesh m = battery::box({0, 0, 0}, {10, 10, 10});
  std::string bytes(84 + 50 * m.triangles.size(), '\0');
  bytes.replace(0, 80, title + std::string(80 - title.size(), ' '));
  const auto count = static_cast<std::uint32_t>(m.triangles.size());
  std::memcpy(&bytes[80], &count, sizeof count);
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (Eigen::Index j = 0; j < 3; ++j) {
        const auto x = static_cast<Single>(m.positions[at(m.triangles[i][k])][j]);
        std::memcpy(&bytes[84 + 50 * i + 12 + 12 * k + 4 * static_cast<std::size_t>(j)], &x,
                    sizeof x);
      }
  return bytes;
}

struct Prism {
  const char* name;
  std::vector<Vec3> outline;  ///< counter-clockwise; the prism is 10 high
  double volume;
};

/// Concave outlines, some with corners on their sides, beginning with any corner.
std::vector<Prism> prisms() {
  const std::vector<Prism> shapes = {
      {"L", {{0, 0, 0}, {20, 0, 0}, {20, 10, 0}, {10, 10, 0}, {10, 20, 0}, {0, 20, 0}}, 3000},
      {"L with corners on sides",
       {{0, 0, 0},
        {5, 0, 0},
        {10, 0, 0},
        {20, 0, 0},
        {20, 10, 0},
        {15, 10, 0},
        {10, 10, 0},
        {10, 20, 0},
        {0, 20, 0},
        {0, 10, 0}},
       3000},
      {"square with a corner on each side",
       {{0, 0, 0},
        {5, 0, 0},
        {10, 0, 0},
        {10, 5, 0},
        {10, 10, 0},
        {5, 10, 0},
        {0, 10, 0},
        {0, 5, 0}},
       1000},
      {"triangle with a corner on a side", {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}, {0, 10, 0}}, 500},
      {"arrow", {{0, 0, 0}, {10, 5, 0}, {0, 10, 0}, {4, 5, 0}}, 300},
      {"U",
       {{0, 0, 0},
        {30, 0, 0},
        {30, 20, 0},
        {20, 20, 0},
        {20, 10, 0},
        {10, 10, 0},
        {10, 20, 0},
        {0, 20, 0}},
       5000}};
  std::vector<Prism> all;
  for (const Prism& shape : shapes)
    for (std::size_t first = 0; first < shape.outline.size(); ++first) {
      all.push_back(shape);
      std::rotate(all.back().outline.begin(),
                  all.back().outline.begin() + static_cast<std::ptrdiff_t>(first),
                  all.back().outline.end());
    }
  return all;
}

TEST(FieldPolygons, concave_ones_with_corners_on_their_sides_are_read_in_every_format) {
  for (const Prism& prism : prisms()) {
    const int n = static_cast<int>(prism.outline.size());
    std::vector<Vec3> points = prism.outline;
    for (const Vec3& x : prism.outline) points.push_back(x + Vec3(0, 0, 10));
    std::vector<std::vector<int>> sides(2);
    for (int k = 0; k < n; ++k) {
      sides[0].push_back(n - 1 - k);
      sides[1].push_back(n + k);
      sides.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
    }
    const std::string counts = std::to_string(2 * n) + " " + std::to_string(n + 2) + " 0\n";
    expect_solid(read("a.obj", vertices(points, "v ") + polygons(sides, false, 1)), prism.volume,
                 prism.name);
    expect_solid(read("a.off", "OFF\n" + counts + vertices(points, "") + polygons(sides, true, 0)),
                 prism.volume, prism.name);
    expect_solid(read("a.ply", "ply\nformat ascii 1.0\nelement vertex " + std::to_string(2 * n) +
                                   "\nproperty float x\nproperty float y\nproperty float z\n"
                                   "element face " +
                                   std::to_string(n + 2) +
                                   "\nproperty list uchar int vertex_indices\nend_header\n" +
                                   vertices(points, "") + polygons(sides, true, 0)),
                 prism.volume, prism.name);
  }
}

TEST(FieldStl, text_is_recognised_with_marks_blanks_case_and_line_ends) {
  for (const std::string start : {"", " ", "\n\t ", "\xef\xbb\xbf", "\xef\xbb\xbf \n"})
    for (const std::string end : {"\n", "\r\n", "\r"})
      for (const bool upper : {false, true}) {
        std::string text = start + text_stl();
        if (upper)
          std::ranges::transform(text, text.begin(), [](unsigned char c) {
            return c < 128 ? static_cast<char>(std::toupper(c)) : static_cast<char>(c);
          });
        replace(text, "\n", end);
        const Read found = read("a.stl", text);
        expect_solid(found, 1000.0, text.substr(0, 30));
        EXPECT_EQ(found.solids.at(0).name, upper ? "PART" : "part");
      }
  std::string mixed = text_stl();
  replace(mixed, "endsolid", "EndSolid");
  replace(mixed, "outer loop\n", "Outer Loop ");
  replace(mixed, "normal 0 0 1\n", "normal -nan(ind) nan inf ");
  expect_solid(read("a.stl", mixed), 1000.0, mixed.substr(0, 60));
  std::string with_unit = "\xef\xbb\xbf Solid part unit=mm" + text_stl().substr(10);
  EXPECT_NE(read("a.stl", with_unit).message.find("states the unit mm"), std::string::npos);
}

TEST(FieldStl, names_in_latin1_are_read) {
  std::string latin = text_stl();
  latin.replace(latin.find('\n'), 0, " k\xF6rper");
  const Read found = read("a.stl", latin);
  expect_solid(found, 1000.0, "latin");
  EXPECT_TRUE(found.solids[0].name.ends_with("k\xC3\xB6rper")) << found.solids[0].name;
}

TEST(FieldStl, bytes_after_the_last_facet_are_a_warning) {
  for (const std::string title : {"", "solid cad"})
    for (const std::size_t more : {1u, 2u, 50u, 80u, 4096u}) {
      const Read found = read("a.stl", binary_stl(title) + std::string(more, '\0'));
      expect_solid(found, 1000.0, title);
      ASSERT_EQ(found.warnings.size(), 1u);
      EXPECT_NE(found.warnings[0].find("found " + std::to_string(more) +
                                       " bytes after the 12 facets that the header declares"),
                std::string::npos);
    }
  EXPECT_TRUE(read("a.stl", binary_stl("solid")).warnings.empty());
  for (const std::string title : {"", "solid cad"}) {
    std::string shortened = binary_stl(title);
    shortened.resize(600);
    EXPECT_EQ(read("a.stl", shortened).message,
              ": truncated or no STL: 600 bytes, expected 684 for 12 facets");
  }
}

std::string ply_with(const std::string& header, const std::string& of_vertex,
                     const std::string& values) {
  std::string text = header + "element vertex 8\nproperty float x\nproperty float y\n" + of_vertex +
                     "property float z\nelement face 6\nproperty list uchar int vertex_indices\n" +
                     "property float quality\nend_header\n";
  for (const Vec3& x : cube_points)
    text += std::to_string(x.x()) + " " + std::to_string(x.y()) + " " + values + " " +
            std::to_string(x.z()) + "\n";
  std::string sides = polygons(cube_sides, true, 0);
  replace(sides, "\n", " inf\n");
  return text + sides;
}

TEST(FieldPly, values_that_are_not_needed_may_be_anything) {
  const std::string header = "ply\nformat ascii 1.0\n";
  for (const std::string value : {"nan", "inf", "-inf", "-nan(ind)", "1e999", "1.#QNAN", "255"}) {
    expect_solid(read("a.ply", ply_with(header, "property float nx\n", value)), 1000, value);
    expect_solid(read("a.ply", ply_with(header, "property int label\n", value)), 1000, value);
    expect_solid(read("a.ply", ply_with(header, "property list uchar float w\n",
                                        "3 " + value + " 0 " + value)),
                 1000, value);
  }
  std::string bad = ply_with(header, "", "");
  replace(bad, "10.000000 10.000000  10.000000", "10 nan 10");
  EXPECT_EQ(read("a.ply", bad).message, ":18: found 'nan', expected a finite number");
}

TEST(FieldPly, headers_may_begin_with_comments_and_strips_are_named) {
  for (const std::string between : {"comment a scanner\n", "obj_info x 1\n", "\n", "comment\n\n"}) {
    expect_solid(read("a.ply", ply_with("ply\n" + between + "format ascii 1.0\n", "", "")), 1000,
                 between);
    std::string crlf = ply_with("\xef\xbb\xbfply\n" + between + "format ascii 1.0\n", "", "");
    replace(crlf, "\n", "\r\n");
    expect_solid(read("a.ply", crlf), 1000, between);
  }
  EXPECT_EQ(read("a.ply", ply_with("ply\n", "", "")).message,
            ":9: found no format, expected 'format ascii 1.0' above");
  EXPECT_EQ(read("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
                 "float y\nproperty float z\nelement tristrips 1\nproperty list int int "
                 "vertex_indices\nend_header\n0 0 0\n3 0 0 0\n")
                .message,
            ":7: found triangle strips (element tristrips), expected an element face: save the "
            "mesh as triangles");
}

TEST(FieldOff, keywords_counts_and_vertices_may_share_lines) {
  const std::string sides = polygons(cube_sides, true, 0), points = vertices(cube_points, "");
  for (const std::string start :
       {"OFF\n8 6 12\n", "OFF8 6 12\n", "OFF 8 6 12\n", "off\n8 6\n", "8 6 12\n",
        "# c\nOFF # d\n# e\n\n8 6 12 # f\n# g\n", "\xef\xbb\xbfOFF\r\n8 6 12\r\n", "OFF 8 6 12 "}) {
    expect_solid(read("a.off", start + points + sides), 1000, start);
    expect_solid(read("a.off", start + vertices(cube_points, "", " ") + "\n" + sides), 1000, start);
    std::string pairs = vertices(cube_points, "", ";");
    for (std::size_t i = 0, n = 0; i < pairs.size(); ++i)
      if (pairs[i] == ';') pairs[i] = ++n % 2 == 0 ? '\n' : ' ';
    expect_solid(read("a.off", start + pairs + sides), 1000, start);
    std::string split = points, one_line = sides;
    replace(split, " ", "\n");
    expect_solid(read("a.off", start + split + sides), 1000, start);
    replace(one_line, "\n", " ");
    expect_solid(read("a.off", start + points + one_line), 1000, start);
    expect_solid(read("a.off", start + vertices(cube_points, "", " ") + one_line), 1000, start);
  }
}

TEST(FieldOff, colours_and_normals_are_skipped) {
  std::string coloured = polygons(cube_sides, true, 0);
  replace(coloured, "\n", " 255 0 0\n");
  const auto cube = [&](const char* keyword, const char* extra, const char* end) {
    return read("a.off", std::string(keyword) + "\n8 6 12\n" +
                             vertices(cube_points, "", std::string(" ") + extra + end) + coloured);
  };
  expect_solid(cube("OFF", "", "\n"), 1000, "plain");
  expect_solid(cube("OFF", "255 0 0 255", "\n"), 1000, "colours without a prefix");
  expect_solid(cube("COFF", "255 0 0 255", "\n"), 1000, "colours");
  expect_solid(cube("coff", "0.5 0 0 1", " "), 1000, "colours that run on");
  expect_solid(cube("NOFF", "0 0 1", "\n"), 1000, "normals");
  expect_solid(cube("NOFF", "0 0 1", " "), 1000, "normals that run on");
  expect_solid(cube("STCNOFF", "0 0 1 255 0 0 255 0 0", "\n"), 1000, "all");
}

TEST(FieldObj, lines_continue_and_display_statements_are_ignored) {
  const std::string points = vertices(cube_points, "v ");
  std::string sides = polygons(cube_sides, false, 1);
  for (const std::string start :
       {"bevel off\nc_interp off\nd_interp off\nlod 1\n", "mtllib a.mtl \\\n b.mtl\n",
        "vt 0 0\nvn 0 0 1\ns off\nusemtl m\nshadow_obj a.obj\ntrace_obj b.obj\n",
        "cstype bezier\ndeg 3\nctech cparm 1\nstech cparma 1 1\nmg 1 2\n", "\xef\xbb\xbf# mark\n"})
    expect_solid(read("a.obj", start + points + "l 1 2 \\\n 3 4\np 1 2\n" + sides), 1000, start);
  for (const std::string end : {" \\\n ", "\\\n ", " \\\r\n", "\\ \n ", " \\\n\\\n"}) {
    std::string continued = points + sides;
    replace(continued, " ", "@");
    for (std::size_t i = 0, n = 0; i < continued.size(); ++i)
      if (continued[i] == '@') continued.replace(i, 1, ++n % 3 == 0 ? " " + end : " ");
    expect_solid(read("a.obj", continued), 1000, end);
  }
  std::string bad = points + "f 1 3 \\\n 4 x\n";
  EXPECT_EQ(read("a.obj", bad).message,
            ":10: found 'x', expected the number of a vertex, 1 or more, or counted back from -1");
}

TEST(FieldObj, groups_name_facets_and_pieces_are_bodies) {
  std::string sides = "g default\n" + vertices(cube_points, "v ");
  for (std::size_t i = 0; i < cube_sides.size(); ++i)
    sides += "s " + std::to_string(i) + "\ng box side" + std::to_string(i % 2) + "\n" +
             polygons({cube_sides[i]}, false, 1);
  expect_solid(read("a.obj", sides), 1000, "sides in two groups");
  EXPECT_EQ(read("a.obj", sides).solids.at(0).name, "solid-1");
  std::vector<Vec3> far = cube_points;
  for (Vec3& x : far) x += Vec3(50, 0, 0);
  const std::string points = vertices(cube_points, "v ") + vertices(far, "v ");
  const std::string a = polygons(cube_sides, false, 1), b = polygons(cube_sides, false, 9);
  const Read two = read("a.obj", points + "o both\n" + a + b);
  ASSERT_EQ(two.solids.size(), 2u);
  EXPECT_EQ(two.solids[0].name + " " + two.solids[1].name, "both both");
  const Read named = read("a.obj", points + "o left\n" + a + "o right\n" + b);
  ASSERT_EQ(named.solids.size(), 2u);
  EXPECT_EQ(named.solids[0].name + " " + named.solids[1].name, "left right");
  EXPECT_NEAR(enclosed_volume(named.solids[1].mesh), 1000, 1e-9);
}

/// A body in a body counts twice and a cavity does not, in files with and without names.
TEST(FieldNested, outward_shells_are_defects_and_cavities_are_not) {
  const TriangleMesh outer = battery::box({0, 0, 0}, {10, 10, 10});
  TriangleMesh inner = battery::box({2, 2, 2}, {7, 7, 7});
  for (const bool is_cavity : {false, true}) {
    if (is_cavity)
      for (Triangle& t : inner.triangles) std::swap(t[1], t[2]);
    for (const char* name : {"a.stl", "a.obj", "a.ply", "a.off"}) {
      const fs::path path = tdbd::temporary_folder() + "tdbd_field_nested_" + name;
      write_solids(path, {{"part", merged({{"o", outer}, {"i", inner}})}});
      const std::vector<Solid> back = read_solids(path, 1.0);
      ASSERT_EQ(back.size(), 1u) << name;
      const std::vector<Defect> defects = check_solid(back[0].mesh);
      EXPECT_EQ(defects.size(), is_cavity ? 0u : 1u) << name << summarize(defects);
      EXPECT_NEAR(enclosed_volume(back[0].mesh), is_cavity ? 875 : 1125, 1e-9);
    }
  }
}

}  // namespace tdbd::mesh::field_files_test
