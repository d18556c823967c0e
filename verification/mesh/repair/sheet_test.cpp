#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::sheet_test {

/// A sheet that faces up, against z, with a square hole from (x, 0). `size` is a multiple of 1/8.
TriangleMesh with_hole(double x, double size) {
  TriangleMesh m = battery::flat_rock(1.0, 0.0, 16);
  std::erase_if(m.triangles, [&](const Triangle& t) {
    const Vec3 c = (position(m, t[0]) + position(m, t[1]) + position(m, t[2])) / 3.0;
    return c.x() > x && c.x() < x + size && c.y() > 0.0 && c.y() < size;
  });
  std::vector<int> all(m.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return submesh(m, all);  // without the points inside the hole
}

TEST(Sheet, lists_its_rim_first_and_then_the_holes_with_their_places) {
  const std::vector<Opening> all = openings(with_hole(0.25, 0.25));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(describe(all[0], "rim").find("rim of 64 edges, 2828 mm across, at ("), 0u);
  EXPECT_EQ(describe(all[1], "hole"),
            "hole of 8 edges, 353.6 mm across, at (375.0000, 125.0000, 0.0000) mm");
}

TEST(Sheet, keeps_its_rim_when_its_holes_are_filled) {
  TriangleMesh m = with_hole(0.25, 0.25);
  EXPECT_FALSE(sheet_faults(m).empty());
  std::string refusal;
  EXPECT_EQ(fill_sheet_holes(m, refusal), 1u);
  EXPECT_EQ(refusal, "");
  EXPECT_TRUE(sheet_faults(m).empty());
  EXPECT_NEAR(area(m), 4.0, 1e-14);  // a few roundings of 512 areas
  EXPECT_EQ(openings(m).size(), 1u);
  EXPECT_EQ(fill_sheet_holes(m, refusal), 0u);
}

TEST(Sheet, loses_vertices_of_no_triangle_when_its_holes_are_filled) {
  TriangleMesh m = with_hole(0.25, 0.25);
  const std::size_t used = m.positions.size();
  m.positions.insert(m.positions.begin(), Vec3(0.3, 0.3, 0.1));
  for (Triangle& t : m.triangles)
    for (int& v : t) ++v;
  std::string refusal;
  EXPECT_EQ(fill_sheet_holes(m, refusal), 1u);
  EXPECT_EQ(m.positions.size(), used);
  EXPECT_TRUE(sheet_faults(m).empty());
}

TEST(Sheet, that_faces_down_is_reported_with_a_question_about_z) {
  TriangleMesh m = battery::flat_rock(1.0, 0.1, 4);
  EXPECT_FALSE(faces_down(m));
  flip(m);
  ASSERT_EQ(sheet_faults(m).size(), 1u);
  EXPECT_NE(sheet_faults(m)[0].find("does z point down in the file?"), std::string::npos);
  turn_about_x(m);
  EXPECT_TRUE(sheet_faults(m).empty());
  EXPECT_EQ(position(m, 0).z(), -0.1);
}

}  // namespace tdbd::mesh::sheet_test
