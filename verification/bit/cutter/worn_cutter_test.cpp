#include <gtest/gtest.h>

#include <algorithm>

#include "bit/cutter/cutter_parts.hpp"
#include "bit/generate.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::worn_cutter_test {

/// A worn cutter, perhaps with two chamfers.
Cutter any_worn_cutter() {
  Cutter c = any_cutter();
  c.wear = number(1e-5, 0.4 * c.diameter);
  if (c.chamfer > 0.0 && *rc::gen::arbitrary<bool>()) {
    c.land = number(1e-4, 5e-4);
    c.land_angle = number(80 * degree, 85 * degree);
    c.X_BC = cutter_pose(c);
  }
  return c;
}

double volume_of(const std::vector<Part>& parts) {
  double volume = 0.0;
  for (const Part& part : parts)
    if (part.density > 0.0) volume += mesh::enclosed_volume(part.mesh_P);
  return volume;
}

RC_GTEST_PROP(WornCutter, has_closed_convex_parts, ()) {
  const Cutter c = any_worn_cutter();
  for (const Part& part : cutter_parts(c, {})) {
    RC_ASSERT(is_closed_and_oriented(part.mesh_P));
    const auto& x = part.mesh_P.positions;
    for (const mesh::Triangle& t : part.mesh_P.triangles) {
      const Vec3 n = mesh::area_vector(x[t[0]], x[t[1]], x[t[2]]);
      for (const Vec3& p : x) RC_ASSERT(n.dot(p - x[t[0]]) < 1e-12 * n.norm() + 1e-18);
    }
  }
}

/// Nothing lies beyond the plane along the path, and the flat reaches it.
RC_GTEST_PROP(WornCutter, ends_in_the_plane_of_its_wear, ()) {
  const Cutter c = any_worn_cutter();
  double farthest = -1.0;
  for (const Part& part : cutter_parts(c, {}))
    for (const Vec3& x_P : part.mesh_P.positions)
      farthest = std::max(farthest, profile_normal_B(c).dot(part.X_BP * x_P - tip_B(c)) + c.wear);
  RC_ASSERT(std::abs(farthest) < 1e-14);
}

/// Without rakes the flat cuts a circular segment off a sharp cylinder; inscribed polygons
/// approach it with the square of the edge.
TEST(WornCutter, loses_a_circular_segment_with_order_2) {
  Cutter c = table('b').front();
  c.chamfer = c.back_rake = c.side_rake = 0.0;
  c.wear = 3e-3;
  c.X_BC = cutter_pose(c);
  const double r = 0.5 * c.diameter, h = r - c.wear;
  const double kept = r * r * std::acos(-h / r) + h * std::sqrt(r * r - h * h);
  const auto error = [&](int n) {
    return kept * c.length - volume_of(cutter_parts(c, {Grading::graded, n, 2e-3}));
  };
  for (const int n : {64, 128, 256}) EXPECT_NEAR(std::log2(error(n) / error(2 * n)), 2.0, 0.019);
  EXPECT_LT(error(1024), 1e-5 * kept * c.length);
}

TEST(WornCutter, is_the_new_one_without_wear) {
  Cutter c = table('b').front();
  const std::vector<Part> fresh = cutter_parts(c, {});
  c.wear = 1e-9;
  EXPECT_NEAR(volume_of(cutter_parts(c, {})), volume_of(fresh), 1e-15);
}

/// A face that is flat and far inside the rim, on a cutter that leans back and is worn to its middle.
TEST(WornCutter, has_no_part_that_is_worn_away_whole) {
  Cutter c = table('b').front();
  c.chamfer = 0.15 * c.diameter;
  c.chamfer_angle = 80 * degree;
  c.back_rake = 60 * degree;
  c.side_rake = 0.0;
  c.X_BC = cutter_pose(c);
  EXPECT_EQ(cutter_parts(c, {}).size(), 3u);
  c.wear = 0.49 * c.diameter;
  const std::vector<Part> parts = cutter_parts(c, {});
  EXPECT_EQ(parts.size(), 2u);
  for (const Part& part : parts) EXPECT_FALSE(part.mesh_P.triangles.empty()) << part.name;
}

TEST(WornCutter, keeps_its_tips_place_in_the_table) {
  Cutter c = table('b').front();
  const Vec3 origin = c.X_BC.p;
  c.wear = 1e-3;
  EXPECT_EQ(cutter_pose(c).p, origin);
}

/// 16 mm, chamfer 0.5 mm at 45 deg and land 1 mm at 60 deg from the axis: by hand.
TEST(TwoChamfers, follow_one_another) {
  Cutter c = table('a').front();
  c.chamfer = 0.5e-3;
  c.chamfer_angle = 45 * degree;
  c.land = 1e-3;
  c.land_angle = 60 * degree;
  c.X_BC = cutter_pose(c);
  const double of_land = 1e-3 / std::sqrt(3.0);
  EXPECT_NEAR(chamfer_depth(c), of_land + 0.5e-3, 1e-18);
  const std::vector<Part> parts = cutter_parts(c, {Grading::graded, 512, 2e-3});
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[1].name, "cutter-1/land");
  EXPECT_EQ(parts[1].kind, PartKind::chamfer);
  const auto frustum = [](double a, double b, double h) {
    return pi / 3 * h * (a * a + a * b + b * b);
  };
  EXPECT_NEAR(mesh::enclosed_volume(parts[1].mesh_P) / frustum(6.5e-3, 7.5e-3, of_land), 1, 3e-5);
  EXPECT_NEAR(mesh::enclosed_volume(parts[2].mesh_P) / frustum(7.5e-3, 8e-3, 0.5e-3), 1, 3e-5);
  const auto box = mesh::bounding_box(parts[2].mesh_P);
  EXPECT_NEAR(box.hi.x(), -of_land, 1e-18);
  EXPECT_NEAR(box.lo.x(), -of_land - 0.5e-3, 1e-18);
  EXPECT_LT((c.X_BC * tip_C(c) - tip_B(c)).norm(), 1e-16);
}

}  // namespace tdbd::bit::worn_cutter_test
