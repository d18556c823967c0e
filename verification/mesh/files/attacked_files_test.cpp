#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "core/error.hpp"
#include "mesh/example_meshes.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/files.hpp"
#include "mesh/files/ply.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::mesh::attacked_files_test {

namespace fs = std::filesystem;

fs::path temporary(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return tdbd::temporary_folder() + "tdbd_attacked_" + test->name() + "_" + name;
}

/// The message that refuses a file of this name and content, with FILE for its path; "" if it is read.
std::string refusal(const std::string& name, const std::string& bytes) {
  const fs::path path = temporary(name);
  std::ofstream(path, std::ios::binary) << bytes;
  try {
    read_mesh(path, 1.0);
  } catch (const InputError& e) {
    const std::string text = e.what();
    return text.rfind(path.string(), 0) == 0 ? "FILE" + text.substr(path.string().size()) : text;
  }
  return "";
}

const std::string two_elements =
    "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string ascii = "ply\nformat ascii 1.0\n";

TEST(AttackedPly, a_property_before_any_element_is_rejected) {
  EXPECT_EQ(refusal("a.ply", ascii + "property double x\nend_header\n"),
            "FILE:3: found a property of no element, expected an element before it");
}

TEST(AttackedPly, headers_are_rejected_with_line_found_and_expected) {
  const std::array<std::array<std::string, 2>, 11> wrong = {{
      {"", "FILE:1: found the end of the file, expected 'ply'"},
      {"ply\nformat ascii 1.0\n", "FILE:2: found the end of the file, expected end_header"},
      {"ply\nformat morse 1.0\n",
       "FILE:2: found 'morse', expected ascii, binary_little_endian or binary_big_endian"},
      {ascii + "element vertex -1\n", "FILE:3: found '-1', expected the number of records"},
      {ascii + "element vertex 99999999999999999999\n",
       "FILE:3: found '99999999999999999999', expected the number of records"},
      {ascii + "element vertex 3\nproperty real x\n",
       "FILE:4: found 'real', expected a type such as double"},
      {ascii + "element face 3\nproperty list float int vertex_indices\n",
       "FILE:4: found a list with a length that is no whole number, expected a type such as uchar"},
      {ascii + "elephant\n",
       "FILE:3: found 'elephant', expected format, element, property, comment, obj_info or "
       "end_header"},
      {ascii + "element vertex 0\nproperty double x\nend_header\n",
       "FILE:3: element vertex: found 0 properties y, expected one"},
      {ascii + "element face 0\nproperty double x\nend_header\n",
       "FILE:3: element face: found 0 properties 'list vertex_indices', expected one"},
      {ascii + "element vertex 9\nend_header\n",
       "FILE:3: element vertex: found 9 records, expected at most 0: 0 bytes follow the header"},
  }};
  for (const auto& [bytes, message] : wrong) EXPECT_EQ(refusal("a.ply", bytes), message) << bytes;
}

TEST(AttackedPly, a_count_that_the_file_cannot_hold_is_rejected_before_memory_is_taken) {
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string head = "ply\nformat " + format + " 1.0\nelement vertex 1000000000\n";
    EXPECT_NE(refusal("a.ply", head + "property double x\nend_header\n0 0 0\n")
                  .find("element vertex: found 1000000000 records, expected at most "),
              std::string::npos);
  }
  const std::string list =
      "ply\nformat binary_little_endian 1.0\nelement face 1\n"
      "property list int double vertex_indices\nend_header\n";
  EXPECT_EQ(
      refusal("a.ply", list + "\xff\xff\xff\x7f"),
      "FILE: byte 4 of 4 after the header: found a list of 2147483647, expected one that fits "
      "into the rest of the file");
  EXPECT_NE(refusal("a.ply", list + "\xff\xff\xff\xff").find("found a list of -1"),
            std::string::npos);
}

TEST(AttackedPly, records_are_rejected_with_line_found_and_expected) {
  const std::array<std::array<std::string, 2>, 7> wrong = {{
      {"0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n", "FILE:12: found 'x', expected a finite number"},
      {"0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n", "FILE:12: found 'nan', expected a finite number"},
      {"0 0 0\n1 0 0\n0 1 0\n2 0 1 2\n",
       "FILE:13: found a polygon with 2 corners, expected three or more"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n",
       "FILE:13: found -2, expected the number of a vertex, 0 or more"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 0.5\n", "FILE:13: found '0.5', expected a whole number"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "FILE: facet 0: a polygon names vertex 3 of 3"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1",
       "FILE:13: found the end of the file, expected a finite number"},
  }};
  for (const auto& [records, message] : wrong)
    EXPECT_EQ(refusal("a.ply", ascii + two_elements + records), message) << records;
}

TEST(AttackedOff, is_rejected_with_line_found_and_expected) {
  const std::string points = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const std::array<std::array<std::string, 2>, 10> wrong = {{
      {"",
       "FILE:1: found the end of the file, expected 'OFF': text, with points of three "
       "coordinates"},
      {"4OFF\n", "FILE:1: found '4OFF', expected 'OFF': text, with points of three coordinates"},
      {"OFF BINARY\n",
       "FILE:1: found 'BINARY', expected 'OFF': text, with points of three coordinates"},
      {"OFF\n1000000000 1 0\n0 0 0\n",
       "FILE:2: found 1000000000 vertices in the 11 bytes that follow, expected at most 2"},
      {"OFF\n1 -1 0\n0 0 0\n", "FILE:2: found '-1', expected the number of facets"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 inf 0\n3 0 1 2\n",
       "FILE:5: found 'inf', expected a finite number"},
      {"OFF\n" + points + "2 0 1\n3 0 1 2\n",
       "FILE:6: found a polygon with 2 corners, expected three or more"},
      {"OFF\n" + points + "999999999 0 1 2\n",
       "FILE:6: found a polygon with 999999999 corners in the last 7 bytes, expected fewer"},
      {"OFF\n" + points + "3 0 1 3\n",
       "FILE:6: found a polygon names vertex 3 of 3, expected one of "
       "them"},
      {"OFF\n" + points + "3 0 1 \n",
       "FILE:6: found the end of the file, expected the number of a vertex, 0 or more"},
  }};
  for (const auto& [bytes, message] : wrong) EXPECT_EQ(refusal("a.off", bytes), message) << bytes;
}

TEST(AttackedOff, colours_normals_and_comments_are_skipped) {
  const fs::path path = temporary("a.off");
  std::ofstream(path) << "# made by hand\r\nCNOFF 3 1 # counts\n\n0 0 0 0 0 1 255 0 0\n1 0 0 0 0 1 "
                         "255 0 0\n0 1 0 0 0 1 255 0 0\n3 0 1 2 0.5 0.5 0.5\n";
  const TriangleMesh m = read_mesh(path, 1.0);
  EXPECT_EQ(m.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(m.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

/// Products of such coordinates are no numbers: CGAL stopped the program.
TEST(AttackedCoordinates, too_large_ones_are_rejected_in_every_format) {
  for (const std::string x : {"1e200", "1e300", "-1e9"}) {
    const std::string expected = "expected coordinates up to 1000000 m";
    const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 " + x + " 0\n3 0 1 2\n";
    EXPECT_NE(refusal("a.off", off).find(expected), std::string::npos);
    const std::string ply = ascii + two_elements + "0 0 0\n1 0 0\n0 " + x + " 0\n3 0 1 2\n";
    EXPECT_NE(refusal("a.ply", ply).find(expected), std::string::npos);
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 " + x + " 0\nf 1 2 3\n";
    EXPECT_NE(refusal("a.obj", obj).find(expected), std::string::npos);
    const std::string stl =
        "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 " +
        x + " 0\nendloop\nendfacet\nendsolid a\n";
    EXPECT_NE(refusal("a.stl", stl).find(expected), std::string::npos);
  }
}

TEST(AttackedCoordinates, of_a_binary_stl_are_finite) {
  const fs::path path = temporary("a.stl");
  write_mesh(path, tetrahedron());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(84 + 50 + 12);
  file.write(reinterpret_cast<const char*>(&nan), sizeof nan);
  file.close();
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  EXPECT_EQ(refusal("a.stl", bytes.str()).rfind("FILE: facet 1: found a vertex at (nan, ", 0), 0u);
}

TEST(AttackedFiles, a_pipe_is_rejected_unopened) {
  const fs::path pipe = temporary("pipe.ply");
  fs::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  try {
    read_mesh(pipe, 1.0);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InputError& e) {
    EXPECT_EQ(e.what(), pipe.string() + ": found no regular file, expected a mesh file");
  }
}

template <class Number>
void put(std::string& out, Number x, bool is_big) {
  auto raw = std::bit_cast<std::array<char, sizeof x>>(x);
  if (is_big) std::reverse(raw.begin(), raw.end());
  out.append(raw.begin(), raw.end());
}

/// The mesh with properties, an element and a list that no mesh needs, in binary of either order.
std::string laden_ply(const TriangleMesh& m, bool is_big) {
  std::ostringstream head;
  head << "ply\r\nformat binary_" << (is_big ? "big" : "little") << "_endian 1.0\r\n"
       << "comment of no use\r\nelement material 1\r\nproperty list ushort short tones\r\n"
       << "element vertex " << m.positions.size() << "\r\nproperty uchar red\r\n"
       << "property double z\r\nproperty double x\r\nproperty double y\r\nelement face "
       << m.triangles.size() << "\r\nproperty int8 flag\r\n"
       << "property list uint32 uint16 vertex_index\r\nproperty float32 heat\r\nend_header\r\n";
  std::string out = head.str();
  put(out, std::uint16_t{2}, is_big);
  put(out, std::int16_t{7}, is_big);
  put(out, std::int16_t{-7}, is_big);
  for (const Vec3& x : m.positions) {
    put(out, std::uint8_t{200}, is_big);
    for (const double coordinate : {x.z(), x.x(), x.y()}) put(out, coordinate, is_big);
  }
  for (const Triangle& t : m.triangles) {
    put(out, std::int8_t{-1}, is_big);
    put(out, std::uint32_t{3}, is_big);
    for (const int v : t) put(out, static_cast<std::uint16_t>(v), is_big);
    put(out, 0.5F, is_big);
  }
  return out;
}

RC_GTEST_PROP(AttackedPly, what_no_mesh_needs_is_read_over_in_either_byte_order, ()) {
  TriangleMesh m = tetrahedron();
  for (Vec3& x : m.positions)
    for (double& coordinate : x) coordinate = 1e-3 * *rc::gen::inRange(-1000000, 1000000);
  for (const bool is_big : {false, true}) {
    const fs::path path = temporary("laden.ply");
    std::ofstream(path, std::ios::binary) << laden_ply(m, is_big);
    const TriangleMesh back = read_mesh(path, 1.0);
    RC_ASSERT(back.positions == m.positions);
    RC_ASSERT(back.triangles == m.triangles);
  }
}

/// A sound file of each format.
std::string sound_file(const std::string& extension) {
  if (extension == ".ply" && *rc::gen::arbitrary<bool>())
    return laden_ply(tetrahedron(), *rc::gen::arbitrary<bool>());
  if (extension == ".ply" && *rc::gen::arbitrary<bool>())
    return ascii + two_elements + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const fs::path path = temporary("sound" + extension);
  write_mesh(path, tetrahedron());
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

/// Some bytes changed, left out or doubled; numbers and words of the formats put in.
std::string damaged(std::string bytes) {
  const std::array<std::string, 12> words = {"element face 3\n",
                                             "property double x\n",
                                             "-1",
                                             "99999999999",
                                             "1e308",
                                             "nan",
                                             "end_header\n",
                                             "list",
                                             "OFF",
                                             "\xff\xff\xff\xff",
                                             "#",
                                             "\n"};
  for (int k = *rc::gen::inRange(1, 6); k > 0 && !bytes.empty(); --k) {
    const std::size_t at = *rc::gen::inRange<std::size_t>(0, bytes.size());
    const std::size_t n = *rc::gen::inRange<std::size_t>(0, bytes.size() - at);
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        bytes[at] = *rc::gen::arbitrary<char>();
        break;
      case 1:
        bytes.erase(at, n);
        break;
      case 2:
        bytes.insert(at, bytes.substr(at, n));
        break;
      default:
        bytes.insert(at, words[*rc::gen::inRange<std::size_t>(0, words.size())]);
    }
  }
  return bytes;
}

RC_GTEST_PROP(AttackedFiles, any_damage_is_read_or_rejected_with_the_path, ()) {
  for (const std::string extension : {".ply", ".off", ".obj", ".stl"}) {
    const std::string message = refusal("damaged" + extension, damaged(sound_file(extension)));
    RC_ASSERT(message.empty() || message.rfind("FILE:", 0) == 0);
  }
}

}  // namespace tdbd::mesh::attacked_files_test
