#include "rock/section/contact_area.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/measures.hpp"
#include "reference/mesh/convex_hull.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/rock/cut/cutting_scene.hpp"

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

/// What part i of a scene's bit holds at the end, one vertex after the other: what it moved, and what no triangle's
/// plane has outside by more than the gap.
std::vector<char> held_by_hand(const Rock& rock, const rock::Scene& s, const CuttingBit& bit, int i,
                               double gap) {
  const bit::Part& part = s.bit.parts[at(i)];
  const auto group = std::ranges::find_if(bit.groups, [&](const CuttingGroup& g) {
    return std::ranges::any_of(g.parts, [&](const CuttingPart& p) { return p.part == i; });
  });
  std::vector<char> held;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    const Vec3 x_P = inverse(s.X_WB1 * part.X_BP) * rock.surface.position(v);
    const double depth = depth_behind_triangles(part.mesh_P, x_P);
    if (std::abs(depth + gap) < 1e-9) RC_DISCARD("on the border");
    const bool is_moved = is_moved_now(rock, v) && rock.last_part[at(v)] == i;
    held.push_back(
        is_moved || (depth > -gap && !is_far_from(*group, x_P, gaps_around_hull * gap)) ? 1 : 0);
  }
  return held;
}

/// Random bits and steps, whether the step was told of the gap or not, after a step before: the triangles all of whose
/// corners the part holds.
RC_GTEST_PROP(ContactArea, is_that_of_the_triangles_whose_corners_a_part_holds, ()) {
  const rock::Scene s = *scene();
  const CuttingBit bit = prepare_cutting_bit(s.bit);
  Rock rock = rock_of(s);
  const double gap = *rc::gen::element(1e-3, 0.02);
  CutWorkspace work;
  work.contact_gap = *rc::gen::element(-1.0, 0.5 * gap, gap, 2.0 * gap);
  CutReport report;
  const Pose between{s.X_WB0.R, 0.5 * (s.X_WB0.p + s.X_WB1.p)};
  cut_rock(rock, bit, s.X_WB0, between, work, report);
  cut_rock(rock, bit, between, s.X_WB1, work, report);
  ContactWork contact_work;
  std::vector<PartContact> found;
  contact_areas(rock, bit, work, gap, contact_work, found);
  RC_ASSERT(found.size() == s.bit.parts.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<char> held = held_by_hand(rock, s, bit, static_cast<int>(i), gap);
    double area = 0.0;
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (const auto& [a, b, c] : rock.surface.triangles) {
      if (held[at(a)] == 0 || held[at(b)] == 0 || held[at(c)] == 0) continue;
      const Vec3 &x = rock.surface.position(a), &y = rock.surface.position(b),
                 &z = rock.surface.position(c);
      const Vec3 one = mesh::area_vector(x, y, z);
      area += one.norm();
      sum += one;
      moment += one.norm() / 3.0 * (x + y + z);
    }
    RC_TAG(area > 0.0 ? "touches" : "does not");
    RC_ASSERT(std::abs(found[i].area - area) < rounding);
    RC_ASSERT((found[i].area_vector_W - sum).norm() < rounding);
    RC_ASSERT((found[i].centroid_W * area - moment).norm() < rounding);
  }
}

}  // namespace tdbd::rock::contact_area_test
