#include "mesh/files/vtp.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "mesh/example_meshes.hpp"
#include "verification/core/temporary_folder.hpp"

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

TEST(Vtp, two_writings_give_the_same_bytes) {
  write_vtp(temporary("a.vtp"), tetrahedron(), {}, {});
  write_vtp(temporary("b.vtp"), tetrahedron(), {}, {});
  EXPECT_EQ(text_of(temporary("a.vtp")), text_of(temporary("b.vtp")));
}

TEST(Vtp, a_field_of_the_wrong_length_is_refused) {
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
