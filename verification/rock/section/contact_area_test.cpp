#include "rock/section/contact_area.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/measures.hpp"
#include "reference/mesh/convex_hull.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::contact_area_test {

Pose at_place(double x, double z) { return {Mat3::Identity(), Vec3(x, 0.0, z)}; }

/// A bit of blocks [-0.35, 0.35] x [-0.25, 0.25] x [-1, 0], side by side along x, over flat rock of
/// cells of 0.1 at z = 0.
struct Scene {
  bit::Bit bit;
  CuttingBit cutting;
  Rock rock;
  CutWorkspace work;
  ContactWork contact_work;
  std::vector<PartContact> contacts;

  explicit Scene(const std::vector<double>& places,
                 const mesh::TriangleMesh& mesh_P = battery::box(Vec3(-0.35, -0.25, -1.0),
                                                                 Vec3(0.35, 0.25, 0.0))) {
    for (const double x : places) add_block(x, mesh_P);
    prepare();
  }

  void add_block(double x, const mesh::TriangleMesh& mesh_P) {
    bit::Part& part = bit.parts.emplace_back();
    part.name = "block";
    part.mesh_P = mesh_P;
    part.X_BP = at_place(x, 0.0);
  }

  void prepare() {
    cutting = prepare_cutting_bit(bit);
    const mesh::TriangleMesh flat = battery::flat_rock(1.0, 0.0, 20);
    rock = make_rock(mesh::make_surface(flat), 0.2, mesh::bounding_box(flat));
  }

  void move(const Pose& X_WB0, const Pose& X_WB1) {
    CutReport report;
    cut_rock(rock, cutting, X_WB0, X_WB1, work, report);
    contact_areas(rock, cutting, work, 1e-6, contact_work, contacts);
  }
};

constexpr double rounding = 1e-12;  // of 0.24 m2

/// Of the block's 0.7 x 0.5 the vertices in 0.6 x 0.4.
TEST(ContactArea, of_a_plane_pressed_into_a_plane_is_that_of_the_cells_below_it) {
  Scene s({0.0});
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  ASSERT_EQ(s.contacts.size(), 1U);
  EXPECT_NEAR(s.contacts[0].area, 0.24, rounding);
  EXPECT_LT((s.contacts[0].area_vector_W - Vec3(0.0, 0.0, -0.24)).norm(), rounding);
  EXPECT_LT((s.contacts[0].centroid_W - Vec3(0.0, 0.0, 0.02)).norm(), rounding);
}

/// Rock's vertices are numbered in any order: some are below all their neighbours.
TEST(ContactArea, does_not_depend_on_the_numbers_of_vertices) {
  Scene s({0.0});
  const mesh::TriangleMesh flat = battery::flat_rock(1.0, 0.0, 20);
  mesh::TriangleMesh renumbered = flat;
  const int count = static_cast<int>(flat.positions.size());
  ASSERT_EQ(count, 441);
  const auto number = [&](int v) { return (8 * v + 3) % count; };
  for (int v = 0; v < count; ++v) renumbered.positions[at(number(v))] = flat.positions[at(v)];
  for (mesh::Triangle& t : renumbered.triangles)
    for (int& v : t) v = number(v);
  s.rock = make_rock(mesh::make_surface(renumbered), 0.2, mesh::bounding_box(flat));
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  EXPECT_NEAR(s.contacts[0].area, 0.24, rounding);
  EXPECT_LT((s.contacts[0].centroid_W - Vec3(0.0, 0.0, 0.02)).norm(), rounding);
}

/// Its ridge at x = 0 lies on edges of the rock, which so becomes the roof itself: of slope 1/2 to
/// x = -0.4 and 3/4 to x = 0.2, over |y| <= 0.2.
TEST(ContactArea, of_a_roof_has_the_normals_and_the_centroid_of_both_its_sides) {
  std::vector<Vec3> corners;
  for (const double y : {-0.25, 0.25})
    for (const Vec3& x : {Vec3(-0.44, y, 0.22), Vec3(0.3, y, 0.225), Vec3(-0.44, y, 1.0),
                          Vec3(0.3, y, 1.0), Vec3(0.0, y, 0.0)})
      corners.emplace_back(x.x(), x.y(), -x.z());
  Scene s({0.0}, reference::convex_hull(corners));
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.21));
  const double left = 0.16 * std::sqrt(1.25), right = 0.08 * 1.25;
  const PartContact& c = s.contacts[0];
  EXPECT_NEAR(c.area, left + right, rounding);
  EXPECT_LT((c.area_vector_W - Vec3(0.16 * 0.5 - 0.08 * 0.75, 0.0, -0.24)).norm(), rounding);
  const Vec3 centroid_W =
      (left * Vec3(-0.2, 0.0, 0.11) + right * Vec3(0.1, 0.0, 0.135)) / (left + right);
  EXPECT_LT((c.centroid_W - centroid_W).norm(), rounding);
}

TEST(ContactArea, stays_when_the_plane_slides_and_moves_nothing) {
  Scene s({0.0});
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  s.move(at_place(0.0, 0.02), at_place(0.02, 0.02));
  EXPECT_NEAR(s.contacts[0].area, 0.24, rounding);
}

TEST(ContactArea, is_none_before_and_after) {
  Scene s({0.0});
  s.move(at_place(0.0, -0.05), at_place(0.0, -0.01));
  EXPECT_EQ(s.contacts[0].area, 0.0);
  EXPECT_EQ(s.contacts[0].centroid_W, Vec3(Vec3::Zero()));
  s.move(at_place(0.0, -0.01), at_place(0.0, 0.02));
  s.move(at_place(0.0, 0.02), at_place(0.0, 0.0));
  EXPECT_EQ(s.contacts[0].area, 0.0);
}

/// On the way down 0.06 and up again: the vertices are moved, and touched no more at the end.
TEST(ContactArea, counts_what_a_step_moved_even_if_the_part_is_gone) {
  Scene s({0.0});
  Pose X_WB0 = at_place(0.0, 0.01), X_WB1 = at_place(0.45, -0.02);
  s.move(X_WB0, X_WB1);
  EXPECT_GT(s.contacts[0].area, 0.1);
}

/// Cells between the blocks belong to neither; what both touch counts for both.
TEST(ContactArea, is_that_of_each_part) {
  Scene s({-0.4, 0.4});
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  EXPECT_NEAR(s.contacts[0].area, 0.24, rounding);
  EXPECT_NEAR(s.contacts[1].area, 0.24, rounding);
  for (const double x : {-0.4, 0.4})
    EXPECT_LT((s.contacts[x > 0.0].centroid_W - Vec3(x, 0.0, 0.02)).norm(), rounding);
  Scene twice({0.0, 0.0});
  twice.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  EXPECT_NEAR(twice.contacts[0].area, 0.24, rounding);
  EXPECT_NEAR(twice.contacts[1].area, 0.24, rounding);
}

/// Each by its own motion, also where nothing is moved: one block has 0.6 x 0.4 of vertices below
/// it, the other 0.4 x 0.2.
TEST(ContactArea, of_blocks_that_slide_is_that_of_each) {
  Scene s({-0.4});
  s.add_block(0.5, battery::box(Vec3(-0.25, -0.15, -1.0), Vec3(0.25, 0.15, 0.0)));
  s.prepare();
  ASSERT_EQ(s.cutting.groups.size(), 2U);
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  s.move(at_place(0.0, 0.02), at_place(0.02, 0.02));
  EXPECT_NEAR(s.contacts[0].area, 0.24, rounding);
  EXPECT_NEAR(s.contacts[1].area, 0.08, rounding);
  EXPECT_LT((s.contacts[0].centroid_W - Vec3(-0.4, 0.0, 0.02)).norm(), rounding);
  EXPECT_LT((s.contacts[1].centroid_W - Vec3(0.5, 0.0, 0.02)).norm(), rounding);
}

}  // namespace tdbd::rock::contact_area_test
