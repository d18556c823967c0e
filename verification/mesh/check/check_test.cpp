#include "mesh/check/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/example_meshes.hpp"

namespace tdbd::mesh::check_test {

using Kind = Defect::Kind;

bool has(const std::vector<Defect>& defects, Kind kind) {
  return std::any_of(defects.begin(), defects.end(),
                     [&](const Defect& d) { return d.kind == kind; });
}

TEST(Check, sound_meshes_have_no_defect) {
  EXPECT_TRUE(check_closed(tetrahedron()).empty()) << describe(check_closed(tetrahedron()));
  EXPECT_TRUE(check_surface(square_sheet(5)).empty()) << describe(check_surface(square_sheet(5)));
}

TEST(Check, a_missing_triangle_is_three_holes_and_says_where) {
  TriangleMesh m = tetrahedron();
  m.triangles.pop_back();
  const auto defects = check_closed(m);
  ASSERT_EQ(defects.size(), 3u);
  for (const Defect& d : defects) EXPECT_EQ(d.kind, Kind::hole);
  EXPECT_EQ(defects[0].where,
            "edge 1-2 of triangle 0, from (1000.0000, 0.0000, 0.0000) mm to (0.0000, 1000.0000, "
            "0.0000) mm");
}

TEST(Check, a_flipped_triangle_is_found_at_each_of_its_edges) {
  TriangleMesh m = tetrahedron();
  std::swap(m.triangles[2][1], m.triangles[2][2]);
  const auto defects = check_closed(m);
  ASSERT_EQ(defects.size(), 3u);
  for (const Defect& d : defects) EXPECT_EQ(d.kind, Kind::flipped_triangle);
}

TEST(Check, a_mesh_with_all_triangles_flipped_is_inside_out) {
  TriangleMesh m = tetrahedron();
  for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
  const auto defects = check_closed(m);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Kind::inside_out);
}

TEST(Check, solids_that_touch_in_a_vertex_or_an_edge_are_not_manifold) {
  EXPECT_TRUE(has(check_closed(two_tetrahedra_sharing(1)), Kind::non_manifold_vertex));
  EXPECT_FALSE(has(check_closed(two_tetrahedra_sharing(1)), Kind::non_manifold_edge));
  EXPECT_TRUE(has(check_closed(two_tetrahedra_sharing(2)), Kind::non_manifold_edge));
}

TEST(Check, bad_indices_and_numbers_and_slivers_are_found) {
  TriangleMesh bad_index = tetrahedron(), bad_number = tetrahedron(), flat = tetrahedron();
  bad_index.triangles[1][2] = 4;
  bad_number.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  flat.positions[3] = 0.5 * (flat.positions[0] + flat.positions[1]);
  EXPECT_EQ(check_closed(bad_index)[0].where, "triangle 1 names vertex 4 of 4");
  EXPECT_TRUE(has(check_closed(bad_number), Kind::not_finite));
  EXPECT_TRUE(has(check_closed(flat), Kind::degenerate_triangle));
  bad_index.triangles[1][2] = -1;
  EXPECT_TRUE(has(check_surface(bad_index), Kind::index_out_of_range));
  EXPECT_TRUE(has(check_closed({}), Kind::empty));
}

TEST(Check, a_repeated_corner_is_degenerate) {
  TriangleMesh m = square_sheet(3);
  m.triangles.push_back({0, 0, 1});
  EXPECT_TRUE(has(check_surface(m), Kind::degenerate_triangle));
}

TEST(Check, a_sheet_with_a_hole_has_two_loops_and_is_not_a_disk) {
  TriangleMesh m = square_sheet(5);
  m.triangles.erase(m.triangles.begin() + 24);
  const auto defects = check_surface(m);
  EXPECT_TRUE(has(defects, Kind::boundary_loops));
  EXPECT_TRUE(has(defects, Kind::euler_characteristic));
}

TEST(Check, a_closed_mesh_two_sheets_or_a_stray_vertex_are_not_a_sheet) {
  EXPECT_TRUE(has(check_surface(tetrahedron()), Kind::boundary_loops));
  EXPECT_TRUE(has(check_surface(two_sheets()), Kind::several_pieces));
  TriangleMesh stray = square_sheet(3);
  stray.positions.push_back(Vec3(9, 9, 9));
  const auto defects = check_surface(stray);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].where, "vertex 16 at (9000.0000, 9000.0000, 9000.0000) mm");
}

/// Whatever its number.
TEST(Check, a_stray_vertex_is_found_before_the_others_too) {
  TriangleMesh m = square_sheet(3);
  m.positions.insert(m.positions.begin(), Vec3(9, 9, 9));
  for (Triangle& t : m.triangles)
    for (int& v : t) ++v;
  const auto defects = check_surface(m);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].where, "vertex 0 at (9000.0000, 9000.0000, 9000.0000) mm");
}

TEST(Check, a_description_lists_the_first_and_counts_the_rest) {
  const std::vector<Defect> three(3, {Kind::hole, "here"});
  EXPECT_EQ(describe(three, 2), "hole: here\nhole: here\nand 1 more\n");
  EXPECT_EQ(describe({}, 2), "");
}

}  // namespace tdbd::mesh::check_test
