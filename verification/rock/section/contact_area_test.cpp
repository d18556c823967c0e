#include "rock/section/contact_area.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bit/cutter/cutter.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/convex_hull.hpp"
#include "rock/section/column_sums.hpp"
#include "rock/section/face_columns.hpp"
#include "rock/section/section.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/bit/generate.hpp"
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
  std::vector<ContactOfPart> how;  ///< per part, or the defaults

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
    contact_areas(rock, cutting, work, {1e-6, how}, contact_work, contacts);
  }

  ContactPatch contact(int i) const { return whole(contacts[at(i)]); }
};

constexpr double rounding = 1e-12;  // of 0.35 m2

/// Exact: the block's bottom, whatever the rock's triangles.
TEST(ContactArea, of_a_plane_pressed_into_a_plane_is_that_plane) {
  Scene s({0.0});
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  ASSERT_EQ(s.contacts.size(), 1U);
  EXPECT_NEAR(s.contact(0).area, 0.35, rounding);
  EXPECT_LT((s.contact(0).area_vector_W - Vec3(0.0, 0.0, -0.35)).norm(), rounding);
  EXPECT_LT((s.contact(0).centroid_W - Vec3(0.0, 0.0, 0.02)).norm(), rounding);
  EXPECT_EQ(s.contacts[0].sides.area, 0.0);
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
  EXPECT_NEAR(s.contact(0).area, 0.35, rounding);
  EXPECT_LT((s.contact(0).centroid_W - Vec3(0.0, 0.0, 0.02)).norm(), rounding);
}

/// A roof of slopes 1/2 and 3/4 that meets the undisturbed rock at x = -0.42 and x = 0.28, over
/// |y| <= 0.25. The rock's triangles cut its four corners there.
TEST(ContactArea, of_a_roof_ends_where_undisturbed_rock_meets_it) {
  constexpr double cut_corners = 8e-3;  // m2; four half cells are 0.02
  std::vector<Vec3> corners;
  for (const double y : {-0.25, 0.25})
    for (const Vec3& x : {Vec3(-0.44, y, 0.22), Vec3(0.3, y, 0.225), Vec3(-0.44, y, 1.0),
                          Vec3(0.3, y, 1.0), Vec3(0.0, y, 0.0)})
      corners.emplace_back(x.x(), x.y(), -x.z());
  Scene s({0.0}, reference::convex_hull(corners));
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.21));
  const double left = 0.21 * std::sqrt(1.25), right = 0.14 * 1.25;
  const ContactPatch c = s.contact(0);
  EXPECT_NEAR(c.area, left + right, cut_corners);
  EXPECT_LT(c.area, left + right);
  EXPECT_NEAR(c.area_vector_W.z(), -0.35, cut_corners);
  EXPECT_NEAR(c.area_vector_W.x(), 0.0, cut_corners);
}

/// A roof of slopes 2 and 3 beside a flat crest, 0.2 wide, over |y| <= 0.25. The crest's edges are on
/// lines of the rock's cells, and the flanks end at x = -0.25 and x = 0.2 on undisturbed rock. At the
/// corners, triangles of the contact have corners on two of the three.
TEST(ContactArea, divided_by_direction_has_crest_and_flanks_apart) {
  constexpr double at_corners = 0.03;  // of an area
  constexpr double leaning = 0.06;     // rad
  std::vector<Vec3> corners;
  for (const double y : {-0.25, 0.25})
    for (const Vec3& x : {Vec3(-0.1, y, 0.0), Vec3(0.1, y, 0.0), Vec3(-0.4, y, -0.6),
                          Vec3(0.3, y, -0.6), Vec3(-0.4, y, -1.0), Vec3(0.3, y, -1.0)})
      corners.push_back(x);
  Scene s({0.0}, reference::convex_hull(corners));
  s.how = {{.division = ContactDivision::by_direction}};
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.3));
  const std::array<ContactPatch, 6>& facing = s.contacts[0].facing;
  const auto expect = [&](std::size_t i, double area, const Vec3& out_of_rock) {
    EXPECT_NEAR(facing[i].area / area, 1.0, at_corners);
    EXPECT_LT(facing[i].area_vector_W.normalized().cross(out_of_rock.normalized()).norm(), leaning);
    EXPECT_GT(facing[i].area_vector_W.dot(out_of_rock), 0.0);
  };
  expect(0, 0.15 * std::sqrt(5.0) * 0.5, Vec3(2.0, 0.0, -1.0));   // -x
  expect(1, 0.1 * std::sqrt(10.0) * 0.5, Vec3(-3.0, 0.0, -1.0));  // x
  expect(5, 0.2 * 0.5, Vec3(0.0, 0.0, -1.0));                     // z
  for (const std::size_t i : {2U, 3U, 4U}) EXPECT_EQ(facing[i].area, 0.0);
}

/// The bottom, and the side in front: 0.02 high and 0.5 wide.
TEST(ContactArea, of_a_block_that_slides_has_its_front_side) {
  Scene s({0.0});
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  s.move(at_place(0.0, 0.02), at_place(0.02, 0.02));
  const PartContact& c = s.contacts[0];
  EXPECT_NEAR(c.sides.area, 0.01, rounding);
  EXPECT_LT((c.sides.area_vector_W - Vec3(-0.01, 0.0, 0.0)).norm(), rounding);
  EXPECT_NEAR(c.below.area, 0.35, rounding);
}

TEST(ContactArea, is_none_before_and_after) {
  Scene s({0.0});
  s.move(at_place(0.0, -0.05), at_place(0.0, -0.01));
  EXPECT_EQ(s.contact(0).area, 0.0);
  EXPECT_EQ(s.contact(0).centroid_W, Vec3(Vec3::Zero()));
  s.move(at_place(0.0, -0.01), at_place(0.0, 0.02));
  s.move(at_place(0.0, 0.02), at_place(0.0, 0.0));
  EXPECT_EQ(s.contact(0).area, 0.0);
}

/// Cells between the blocks belong to neither; what both touch counts for both.
TEST(ContactArea, is_that_of_each_part) {
  Scene s({-0.4, 0.4});
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  for (const double x : {-0.4, 0.4}) {
    EXPECT_NEAR(s.contact(x > 0.0 ? 1 : 0).area, 0.35, rounding);
    EXPECT_LT((s.contact(x > 0.0 ? 1 : 0).centroid_W - Vec3(x, 0.0, 0.02)).norm(), rounding);
  }
  Scene twice({0.0, 0.0});
  twice.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  EXPECT_NEAR(twice.contact(0).area_vector_W.z(), -0.35, rounding);
  // The second block moved nothing, so that no direction is known in which to find its corners.
  EXPECT_NEAR(twice.contact(1).area_vector_W.z(), -0.35, 5e-3);
}

/// Each by its own motion: bottoms of 0.7 x 0.5 and 0.5 x 0.3.
TEST(ContactArea, of_blocks_that_slide_is_that_of_each) {
  Scene s({-0.4});
  s.add_block(0.5, battery::box(Vec3(-0.25, -0.15, -1.0), Vec3(0.25, 0.15, 0.0)));
  s.prepare();
  ASSERT_EQ(s.cutting.groups.size(), 2U);
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  s.move(at_place(0.0, 0.02), at_place(0.02, 0.02));
  EXPECT_NEAR(s.contact(0).area_vector_W.z(), -0.35, rounding);
  EXPECT_NEAR(s.contact(1).area_vector_W.z(), -0.15, rounding);
  EXPECT_NEAR(s.contacts[0].sides.area, 0.01, rounding);
  EXPECT_NEAR(s.contacts[1].sides.area, 0.006, rounding);
}

/// The vertices within the block are at multiples of 0.1, up to 0.3 and 0.2 from its centre.
TEST(ContactArea, by_whole_triangles_is_that_of_triangles_with_three_held_vertices) {
  Scene s({0.0});
  s.how = {{ContactRule::whole_triangles, 0.0}};
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  EXPECT_NEAR(s.contact(0).area, 0.6 * 0.4, rounding);
  EXPECT_LT((s.contact(0).area_vector_W - Vec3(0.0, 0.0, -0.24)).norm(), rounding);
  EXPECT_LT((s.contact(0).centroid_W - Vec3(0.0, 0.0, 0.02)).norm(), rounding);
  EXPECT_TRUE(s.rock.pressed[0].empty());
}

/// A surface that only slides bears nothing.
TEST(ContactArea, under_a_ramp_is_not_that_of_surfaces_that_slide) {
  Scene s({0.0});
  s.how = {{ContactRule::clipped, 0.5}};
  s.move(at_place(0.0, -0.05), at_place(0.0, 0.02));
  EXPECT_LT((s.contact(0).area_vector_W - Vec3(0.0, 0.0, -0.35)).norm(), rounding);
  s.move(at_place(0.0, 0.02), at_place(0.02, 0.02));
  EXPECT_LT((s.contacts[0].sides.area_vector_W - Vec3(-0.01, 0.0, 0.0)).norm(), rounding);
}

// The ends of the engaged edge in rock whose surface is a plane along the path.

ConvexPolygon round_face(double radius, int corners, double turned) {
  ConvexPolygon rim;
  for (int i = 0; i < corners; ++i) {
    const double t = 2.0 * std::numbers::pi * (i + turned) / corners;
    rim.emplace_back(radius * std::sin(t), -radius * std::cos(t));
  }
  return rim;
}

/// Rock below the line z_F = height + slope y_F.
Rock rock_below(double height, double slope) {
  mesh::TriangleMesh m = battery::flat_rock(1.0, 0.0, 20);
  for (Vec3& x_W : m.positions) x_W.z() = -height + slope * x_W.y();
  return make_rock(mesh::make_surface(m), 0.2, mesh::bounding_box(m));
}

EngagedEnds ends_in(const Rock& rock, const ConvexPolygon& rim_F) {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = -Vec3::UnitY();
  X.R.col(2) = -Vec3::UnitZ();
  SectionWork work;
  const SectionFace face = section_face({X, rim_F});
  section(rock, face, {}, {Vec3::Zero(), Vec3::UnitX()}, {0.12, 0.15}, work);
  return engaged_ends(*work.measured, work.sums);
}

/// Of the lower edge, corner by corner.
EngagedEnds ends_below(const ConvexPolygon& rim_F, double height, double slope) {
  EngagedEnds ends;
  for (std::size_t i = 0; i < rim_F.size(); ++i) {
    const Vec2 &p = rim_F[i], &q = rim_F[(i + 1) % rim_F.size()];
    if (!(q.x() > p.x())) continue;  // counter-clockwise: an upper edge
    const double from = height + slope * p.x() - p.y(), to = height + slope * q.x() - q.y();
    if (from <= 0.0 && to <= 0.0) continue;
    const Vec2 crossing = p + from / (from - to) * (q - p);
    const double z_left = from >= 0.0 ? p.y() : crossing.y(),
                 z_right = to >= 0.0 ? q.y() : crossing.y();
    auto& end = ends[q.y() > p.y() ? 1 : 0];
    const double z = std::max(z_left, z_right);
    end = end ? std::max(*end, z) : z;
  }
  return ends;
}

RC_GTEST_PROP(EngagedEnds, are_where_the_edge_leaves_a_plane, ()) {
  const auto any = [](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(*rc::gen::inRange(0, 1000001)) / 1e6;
  };
  const ConvexPolygon rim = round_face(0.3, *rc::gen::inRange(5, 65), any(0.05, 0.95));
  const double height = any(-0.28, 0.1), slope = any(-0.5, 0.5);
  const EngagedEnds found = ends_in(rock_below(height, slope), rim),
                    exact = ends_below(rim, height, slope);
  for (std::size_t side = 0; side < 2; ++side) {
    const bool is_sliver = exact[side] && *exact[side] < -0.3 + 1e-6;
    if (is_sliver) continue;
    RC_ASSERT(found[side].has_value() == exact[side].has_value());
    if (found[side]) RC_ASSERT(std::abs(*found[side] - *exact[side]) < 1e-7);
  }
}

TEST(EngagedEnds, are_none_in_the_open) {
  const EngagedEnds ends = ends_in(rock_below(-0.5, 0.0), round_face(0.3, 16, 0.0));
  EXPECT_FALSE(ends[0]);
  EXPECT_FALSE(ends[1]);
}

}  // namespace tdbd::rock::contact_area_test

namespace tdbd::rock::face_outline_test {

/// Scale of the tolerances: a cutter's place, below a metre.
constexpr double rounding = 1e-14;

RC_GTEST_PROP(FaceOutline, is_the_circle_through_the_tip_up_to_the_wear_flat, ()) {
  bit::Cutter c = bit::any_cutter();
  c.wear = *rc::gen::element(0.0, 0.5e-3, 2e-3);
  bit::CutterMeshing meshing;
  meshing.rim_segments = *battery::integer(8, 64);
  std::vector<bit::Part> parts = bit::cutter_parts(c, meshing);
  for (bit::Part& part : parts) part.cutter = 3;
  const FaceOutline face = face_outline(c, 3, parts);
  double farthest = -1.0, nearest = 1.0;
  const double area = moments(face.rim_F).area;
  for (const Vec2& x_F : face.rim_F) {
    const Vec3 x_B = face.X_BF * Vec3(0.0, x_F.x(), x_F.y());
    RC_ASSERT(x_F.norm() <= 0.5 * c.diameter * (1.0 + rounding));
    nearest = std::min(nearest, (x_B - bit::tip_B(c)).norm());
    farthest = std::max(farthest, bit::profile_normal_B(c).dot(x_B - bit::tip_B(c)));
  }
  RC_ASSERT(area > 0.0);
  if (c.wear > 0.0) RC_ASSERT(std::abs(farthest + c.wear) <= rounding);
  if (c.wear == 0.0) RC_ASSERT(nearest <= rounding);
}

/// A trapezoid in two triangles, computed manually; a removed corner contributes nothing.
TEST(Moments, are_those_of_the_corners_that_are_there) {
  ConvexPolygon trapezoid{{1.0, 1.0}, {4.0, 1.0}, {3.0, 3.0}, {1.0, 3.0}, {0.0, 9.0}};
  trapezoid.pop_back();
  const PolygonMoments m = moments(trapezoid);
  EXPECT_NEAR(m.area, 5.0, rounding);
  EXPECT_LT((m.moment - Vec2(3.0 * 8.0 / 3.0 + 2.0 * 5.0 / 3.0, 3.0 * 5.0 / 3.0 + 2.0 * 7.0 / 3.0))
                .norm(),
            rounding);
}

/// What a half-plane keeps and what its complement keeps are the whole, in any unit of length.
RC_GTEST_PROP(Clip, divides_a_polygon_into_two_that_make_it_up, ()) {
  const double size = std::ldexp(1.0, *battery::integer(-10, 10));
  ConvexPolygon polygon, inside, outside;
  const int corners = *battery::integer(3, 12);
  for (int k = 0; k < corners; ++k)
    polygon.push_back(size * Vec2(std::cos(k * 6.28 / corners), std::sin(k * 6.28 / corners)));
  const double angle = *battery::number(0.0, 6.28);
  const HalfPlane h{*battery::number(0.1, 9.0) * Vec2(std::cos(angle), std::sin(angle)),
                    size * *battery::number(-2.0, 2.0)};
  clip(polygon, h, inside);
  clip(polygon, {-h.n, -h.b}, outside);
  const PolygonMoments all = moments(polygon), in = moments(inside), out = moments(outside);
  RC_ASSERT(std::abs(in.area + out.area - all.area) <= rounding * size * size);
  RC_ASSERT((in.moment + out.moment - all.moment).norm() <= rounding * std::pow(size, 3));
  for (const Vec2& x : inside) RC_ASSERT(h.n.dot(x) - h.b <= rounding * size * 9.0);
  RC_ASSERT(in.area >= 0.0 && out.area >= 0.0);
}

TEST(FaceOutline, is_empty_without_parts) {
  EXPECT_TRUE(face_outline(bit::Cutter{}, 0, {}).rim_F.empty());
}

}  // namespace tdbd::rock::face_outline_test
