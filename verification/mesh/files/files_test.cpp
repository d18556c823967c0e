#include "mesh/files/files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "core/error.hpp"
#include "mesh/check/check.hpp"
#include "mesh/example_meshes.hpp"
#include "mesh/files/vtp.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::mesh::files_test {

namespace fs = std::filesystem;

/// A path used by the running test alone: tests may run at the same time.
fs::path temporary(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return tdbd::temporary_folder() + "tdbd_files_" + test->name() + "_" + name;
}

fs::path write_text_file(const std::string& name, const std::string& text) {
  std::ofstream(temporary(name)) << text;
  return temporary(name);
}

/// The message of the error E that `f` throws; fails the test if it throws none.
template <class E, class F>
std::string message_of(F f) {
  try {
    f();
  } catch (const E& e) {
    return e.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

std::string refusal(const fs::path& path) {
  return message_of<InputError>([&] { read_mesh(path, 1.0); });
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

double any_coordinate() {
  const double mantissa = static_cast<double>(*rc::gen::arbitrary<std::int64_t>());
  return std::ldexp(mantissa, *rc::gen::inRange(-70, -60));
}

/// Tetrahedra with coordinates of any size between 1e-3 m and 1e1 m and all digits in use.
TriangleMesh any_tetrahedra() {
  TriangleMesh m;
  const int n = *rc::gen::inRange(1, 20);
  for (int k = 0; k < n; ++k) {
    for (int v = 0; v < 4; ++v) {
      const double x = any_coordinate(), y = any_coordinate(), z = any_coordinate();
      m.positions.push_back(Vec3(x, y, z));
    }
    for (const Triangle& t : tetrahedron().triangles)
      m.triangles.push_back({t[0] + 4 * k, t[1] + 4 * k, t[2] + 4 * k});
  }
  return m;
}

TriangleMesh there_and_back(const std::string& extension, const TriangleMesh& m) {
  const fs::path path = temporary("round_trip" + extension);
  write_mesh(path, m);
  return read_mesh(path, 1.0);
}

RC_GTEST_PROP(Files, double_precision_formats_keep_every_bit, ()) {
  const TriangleMesh m = any_tetrahedra();
  for (const char* extension : {".obj", ".ply", ".off", ".OFF"}) {
    const TriangleMesh back = there_and_back(extension, m);
    RC_ASSERT(back.positions == m.positions);
    RC_ASSERT(back.triangles == m.triangles);
  }
}

/// More facets than the writer puts together at a time.
TEST(Files, a_large_ply_is_read_back_bitwise_identical) {
  const TriangleMesh m = square_sheet(70);
  ASSERT_GT(m.triangles.size(), 8192U);
  const TriangleMesh back = there_and_back(".ply", m);
  EXPECT_EQ(back.positions, m.positions);
  EXPECT_EQ(back.triangles, m.triangles);
}

RC_GTEST_PROP(Files, stl_keeps_single_precision_and_the_order_of_triangles, ()) {
  const TriangleMesh m = any_tetrahedra(), back = there_and_back(".stl", m);
  RC_ASSERT(back.triangles.size() == m.triangles.size());
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& x = m.positions[static_cast<std::size_t>(m.triangles[i][k])];
      const Vec3& y = back.positions[static_cast<std::size_t>(back.triangles[i][k])];
      RC_ASSERT((x - y).norm() <= 1e-7 * x.norm());
    }
}

TEST(Files, stl_merges_equal_points_so_that_a_solid_stays_closed) {
  const TriangleMesh back = there_and_back(".stl", tetrahedron());
  EXPECT_EQ(back.positions.size(), 4u);
  EXPECT_TRUE(check_closed(back).empty()) << describe(check_closed(back));
}

TEST(Files, text_stl_is_read_and_scaled_by_the_unit) {
  const auto path = write_text_file(
      "text.stl",
      "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 25.4 0 0\nvertex 0 25.4 0\n"
      "endloop\nendfacet\nendsolid t\n");
  const TriangleMesh m = read_mesh(path, 1e-3);
  ASSERT_EQ(m.triangles.size(), 1u);
  EXPECT_DOUBLE_EQ(m.positions[1].x(), 0.0254);
}

TEST(Files, numbers_may_have_a_plus) {
  const auto path = write_text_file("plus.obj", "v +1.5 +2 -3\nv +1e+1 0 0\nv 0 1 0\nf 1 2 3\n");
  const TriangleMesh m = read_mesh(path, 1.0);
  EXPECT_EQ(m.positions[0], Vec3(1.5, 2, -3));
  EXPECT_EQ(m.positions[1], Vec3(10, 0, 0));
}

TEST(Files, a_binary_stl_that_begins_with_solid_is_still_binary) {
  const fs::path path = temporary("solid.stl");
  write_mesh(path, tetrahedron());
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary) << "solid named by a CAD";
  EXPECT_EQ(read_mesh(path, 1.0).triangles.size(), 4u);
}

TEST(Files, polygons_become_fans) {
  const auto path = write_text_file(
      "fan.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1/1 2/2 3/3 4/4 5/5\n");
  const std::vector<Triangle> fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_EQ(read_mesh(path, 1.0).triangles, fan);
}

TEST(Files, bad_input_is_rejected_with_path_and_reason) {
  EXPECT_TRUE(contains(refusal("nowhere/part.stl"), "nowhere/part.stl: found no such file"));
  EXPECT_TRUE(contains(refusal("part.step"), "unknown mesh format '.step'"));
  EXPECT_TRUE(contains(refusal(tdbd::temporary_folder()), "unknown mesh format"));
  EXPECT_TRUE(contains(refusal(write_text_file("empty.stl", "")), "no triangles"));
  EXPECT_TRUE(
      contains(refusal(write_text_file("none.off", "OFF\n1 0 0\n0 0 0\n")), "no triangles"));
  EXPECT_TRUE(contains(refusal(write_text_file("text.off", "not a mesh at all")), "text.off:1: "));
  EXPECT_TRUE(contains(refusal(write_text_file("text.ply", "not a mesh at all")), "text.ply:1: "));
  EXPECT_TRUE(contains(refusal(write_text_file("text.obj", "not a mesh at all")),
                       "text.obj:1: found 'not'"));
}

TEST(Files, indices_beyond_the_vertices_are_rejected) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_TRUE(contains(refusal(write_text_file("high.obj", triangle + "f 1 2 4\n")),
                       "a polygon names vertex 3 of 3"));
  EXPECT_TRUE(contains(refusal(write_text_file("line.obj", triangle + "f 1 2\n")),
                       "a polygon with 2 corners"));
}

TEST(Files, a_truncated_file_is_rejected) {
  for (const char* extension : {".stl", ".ply", ".off"}) {
    const fs::path path = temporary(std::string("cut") + extension);
    write_mesh(path, square_sheet(4));
    fs::resize_file(path, fs::file_size(path) * 2 / 3);
    EXPECT_FALSE(refusal(path).empty()) << extension;
  }
}

TEST(Files, writing_where_nothing_can_be_written_fails) {
  const auto text = message_of<RunError>([] { write_mesh("/proc/no/part.stl", tetrahedron()); });
  EXPECT_TRUE(contains(text, "cannot write /proc/no/part.stl"));
}

TEST(Files, writing_an_unknown_format_is_rejected_and_leaves_no_file) {
  const fs::path path = temporary("part.step");
  const auto text = message_of<InputError>([&] { write_mesh(path, tetrahedron()); });
  EXPECT_TRUE(contains(text, "unknown mesh format '.step'")) << text;
  EXPECT_FALSE(fs::exists(path));
}

TEST(Files, a_full_disk_leaves_no_partial_file_and_keeps_the_old_one) {
  const fs::path path = temporary("full.ply");
  write_mesh(path, tetrahedron());
  fs::create_symlink("/dev/full", path.string() + ".partial");
  const auto text = message_of<RunError>([&] { write_mesh(path, square_sheet(50)); });
  EXPECT_TRUE(contains(text, "cannot write")) << text;
  EXPECT_FALSE(fs::is_symlink(path.string() + ".partial"));
  EXPECT_EQ(read_mesh(path, 1.0).triangles.size(), 4u);
}

}  // namespace tdbd::mesh::files_test

namespace tdbd::mesh::vtp_test {

namespace fs = std::filesystem;

fs::path temporary(const std::string& name) {
  return tdbd::temporary_folder() + "tdbd_vtp_" + name;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What VTK itself reads from the file, one line per item.
std::string read_by_vtk(const fs::path& path) {
  const fs::path out = path.string() + ".txt";
  const std::string command = std::string("/usr/bin/python3 ") + TDBD_SOURCE_DIR +
                              "/verification/mesh/files/read_vtp.py " + path.string() + " " +
                              out.string();
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return text_of(out);
}

std::string expected(const TriangleMesh& m, const std::vector<Field>& points,
                     const std::vector<Field>& cells) {
  std::string text;
  for (const Vec3& x : m.positions) text += fmt::format("point {} {} {}\n", x.x(), x.y(), x.z());
  for (const Triangle& t : m.triangles) text += fmt::format("cell {} {} {}\n", t[0], t[1], t[2]);
  for (const Field& f : points)
    for (double v : f.values) text += fmt::format("point_data {} {}\n", f.name, v);
  for (const Field& f : cells)
    for (double v : f.values) text += fmt::format("cell_data {} {}\n", f.name, v);
  return text;
}

TEST(Vtp, vtk_reads_back_every_bit) {
  TriangleMesh m = square_sheet(3);
  Field depth{"depth_m", {}}, quality{"quality", {}}, part{"part", {}};
  for (Vec3& x : m.positions) {
    x = 0.1 * x + Vec3(1e-9, 1.0 / 3.0, std::sin(9.0 * x.x()));
    depth.values.push_back(std::sqrt(2.0) * x.z());
  }
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    quality.values.push_back(1.0 / (1.0 + static_cast<double>(i)));
    part.values.push_back(static_cast<double>(i));
  }
  write_vtp(temporary("sheet.vtp"), m, {depth}, {quality, part});
  EXPECT_EQ(read_by_vtk(temporary("sheet.vtp")), expected(m, {depth}, {quality, part}));
}

/// More facets than the writer makes numbers of at a time.
TEST(Vtp, vtk_reads_back_a_large_mesh_with_whole_numbers) {
  const TriangleMesh m = square_sheet(70);
  ASSERT_GT(m.triangles.size(), 8192U);
  Field part{"last_part", {}, FieldValues::whole_numbers}, owner = part;
  for (std::size_t i = 0; i < m.positions.size(); ++i)
    part.values.push_back(static_cast<double>(i % 57) - 1.0);
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    owner.values.push_back(static_cast<double>(i * i % 1000003));
  write_vtp(temporary("large.vtp"), m, {part}, {owner});
  EXPECT_NE(text_of(temporary("large.vtp")).find(R"(type="Int32" Name="last_part")"),
            std::string::npos);
  EXPECT_EQ(read_by_vtk(temporary("large.vtp")), expected(m, {part}, {owner}));
}

TEST(Vtp, two_writings_are_bitwise_identical) {
  write_vtp(temporary("a.vtp"), tetrahedron(), {}, {});
  write_vtp(temporary("b.vtp"), tetrahedron(), {}, {});
  EXPECT_EQ(text_of(temporary("a.vtp")), text_of(temporary("b.vtp")));
}

TEST(Vtp, a_field_of_the_wrong_length_is_rejected) {
  EXPECT_THROW(write_vtp(temporary("c.vtp"), tetrahedron(), {{"depth_m", {1, 2, 3}}}, {}),
               RunError);
  EXPECT_FALSE(fs::exists(temporary("c.vtp")));
}

TEST(Vtp, a_full_disk_leaves_nothing) {
  const fs::path path = temporary("full.vtp");
  fs::create_symlink("/dev/full", path.string() + ".partial");
  EXPECT_THROW(write_vtp(path, square_sheet(80), {}, {}), RunError);
  EXPECT_FALSE(fs::exists(path));
  EXPECT_FALSE(fs::is_symlink(path.string() + ".partial"));
}

TEST(Vtp, a_collection_names_times_and_files) {
  write_pvd(temporary("rock.pvd"),
            {{0.0, "frames/rock-000000.vtp"}, {0.25, "frames/rock-000001.vtp"}});
  const std::string text = text_of(temporary("rock.pvd"));
  EXPECT_NE(text.find(R"(<DataSet timestep="0.25" file="frames/rock-000001.vtp"/>)"),
            std::string::npos);
}

}  // namespace tdbd::mesh::vtp_test
