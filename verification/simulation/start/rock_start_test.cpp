#include "simulation/start/rock_start.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/error.hpp"
#include "mesh/files/files.hpp"
#include "rock/start/borehole.hpp"
#include "simulation/mesh_bit.hpp"

namespace tdbd::simulation::rock_start_test {

Case with(std::vector<std::string> settings) {
  settings.emplace_back("time.revolutions=0.1");
  return read_case(TDBD_SOURCE_DIR "/cases/bit-b-steady.toml", settings);
}

/// What start_rock refuses, in its own words; empty: nothing.
std::string refusal(const Case& c) {
  try {
    start_rock(c);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

Case of_profile(const std::string& points, const std::string& edge,
                const std::string& check = "on") {
  return with({"rock={shape='profile', profile=" + points + ", edge_length=" + edge +
               ", intersection_check='" + check + "'}"});
}

/// Its flank cuts through its bottom.
TEST(RockOfAProfile, may_not_cross_itself) {
  const std::string plain = "[[0, 0.1], [0.2, 0.1], [0.2, 0]]",
                    crossing = "[[0, 0.1], [0.2, 0.1], [0.2, 0], [0.1, 0.15], [0.3, 0]]";
  EXPECT_EQ(refusal(of_profile(plain, "0.02")), "");
  const std::string found = refusal(of_profile(crossing, "0.02"));
  EXPECT_NE(found.find("rock.profile: found "), std::string::npos) << found;
  EXPECT_NE(found.find(" pairs of triangles that intersect, the first "), std::string::npos);
  EXPECT_EQ(refusal(of_profile(crossing, "0.02", "off")), "");
}

/// Before it is made: too much rock is refused by the size of what the meridian sweeps.
TEST(RockOfAProfile, needs_space_all_around_its_axis) {
  const Case c = of_profile("[[0, 0.1], [1, 0.1], [1, -0.9]]", "1e-5");
  mesh::Box box = reach_W(c);
  box.add(Vec3(-1.0, -1.0, -0.9));
  box.add(Vec3(1.0, 1.0, 0.1));
  const double area = 3.0 * std::numbers::pi;  // the disc, and the cylinder's wall
  const RockRequirements rock = rock_requirements(area, box, c.rock.edge_length),
                         wall = new_wall_requirements(c);
  const std::string expected = fmt::format("which makes {:.1e} triangles and {:.1e} cells of rock",
                                           rock.triangles + wall.triangles, rock.cells);
  const std::string found = refusal(c);
  EXPECT_NE(found.find(expected), std::string::npos) << found << "\nexpected " << expected;
}

/// A flat hole of 0.2 m whose rim leans by `lean` (m per m) toward x, in a file.
mesh::TriangleMesh leaning_hole(double lean) {
  mesh::TriangleMesh m = rock::borehole(rock::flat_bottom(0.2, 0.1, 0.1), 0.02);
  for (Vec3& p : m.positions) p.z() += lean * p.x();
  return m;
}

Case of_file(const mesh::TriangleMesh& m, const std::string& unit = "1 m",
             const std::string& edge = "20 mm") {
  const auto path = test_folder() / "hole.ply";
  mesh::write_mesh(path, m);
  return with({"rock={shape='file', file='" + path.string() + "', unit='" + unit +
               "', edge_length='" + edge + "'}"});
}

TEST(RockOfAFile, faces_up_however_it_leans) {
  for (const double lean : {0.0, 0.2, -0.2}) {
    mesh::TriangleMesh m = leaning_hole(lean);
    EXPECT_EQ(refusal(of_file(m)), "") << lean;
    for (mesh::Triangle& t : m.triangles) std::swap(t[0], t[1]);
    EXPECT_NE(refusal(of_file(m)).find("found all facets flipped"), std::string::npos) << lean;
  }
}

/// Edges may be 20 times as long as edge_length, or as short.
TEST(RockOfAFile, has_edges_of_about_the_edge_length) {
  const mesh::TriangleMesh m = leaning_hole(0.0);  // edges of about 20 mm
  for (const char* edge : {"2 mm", "90 mm"})
    EXPECT_EQ(refusal(of_file(m, "1 m", edge)), "") << edge;
  EXPECT_NE(refusal(of_file(m, "1 m", "0.5 mm")).find("found edges of about "), std::string::npos);
  const std::string in_mm = refusal(of_file(m, "1 mm"));
  EXPECT_NE(in_mm.find("with rock.unit = 0.001 m, in a mesh "), std::string::npos) << in_mm;
  EXPECT_NE(in_mm.find("expected edges near rock.edge_length"), std::string::npos) << in_mm;
}

TEST(RockOfAFile, keeps_the_order_of_its_vertices) {
  const mesh::TriangleMesh m = leaning_hole(0.0);
  const rock::Rock rock = start_rock(of_file(m));
  ASSERT_EQ(static_cast<std::size_t>(rock.surface.vertex_slots()), m.positions.size());
  for (std::size_t v = 0; v < m.positions.size(); ++v)
    EXPECT_EQ(rock.surface.position(static_cast<int>(v)), m.positions[v]);
}

}  // namespace tdbd::simulation::rock_start_test
