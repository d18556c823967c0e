#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bit/cutter/cutter.hpp"
#include "bit/generate.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::cutter_parts_test {

CutterMeshing any_meshing() {
  CutterMeshing m;
  m.grading = *rc::gen::element(Grading::graded, Grading::uniform);
  m.rim_segments = *rc::gen::inRange(8, 70);
  m.uniform_edge = number(1.5e-3, 5e-3);
  return m;
}

/// Area of the regular n-gon in a circle of unit radius.
double polygon(int n) { return 0.5 * n * std::sin(2 * pi / n); }

/// Volume of the frustum between n-gons of circumradius a and b, h apart.
double frustum_volume(int n, double a, double b, double h) {
  return polygon(n) * h * (a * a + a * b + b * b) / 3.0;
}

RC_GTEST_PROP(CutterParts, are_closed_and_oriented, ()) {
  for (const Part& part : cutter_parts(any_cutter(), any_meshing()))
    RC_ASSERT(is_closed_and_oriented(part.mesh_P));
}

RC_GTEST_PROP(CutterParts, are_convex, ()) {
  const Cutter c = any_cutter();
  for (const Part& part : cutter_parts(c, any_meshing()))
    for (const mesh::Triangle& t : part.mesh_P.triangles) {
      const auto& x = part.mesh_P.positions;
      const Vec3 n = mesh::area_vector(x[t[0]], x[t[1]], x[t[2]]);
      RC_ASSERT(n.norm() > 0.0);
      for (const Vec3& p : x) RC_ASSERT(n.normalized().dot(p - x[t[0]]) < 1e-12 * c.diameter);
    }
}

RC_GTEST_PROP(CutterParts, have_the_volume_of_polygon_prisms_and_frusta, ()) {
  const Cutter c = any_cutter();
  CutterMeshing m;
  m.rim_segments = *rc::gen::inRange(8, 130);
  const int n = m.rim_segments;
  const double outer = 0.5 * c.diameter, inner = outer - c.chamfer;
  const double f = c.chamfer > 0 ? chamfer_depth(c) : c.table_thickness;
  const auto has_volume = [](const Part& part, double v) {
    return std::abs(mesh::enclosed_volume(part.mesh_P) - v) < 1e-13 * v;
  };
  const std::vector<Part> parts = cutter_parts(c, m);
  RC_ASSERT(parts.size() == (c.chamfer > 0 ? 3u : 2u));
  RC_ASSERT(has_volume(parts.front(), frustum_volume(n, inner, inner, f)));
  RC_ASSERT(has_volume(parts[1], frustum_volume(n, c.chamfer > 0 ? inner : outer, outer,
                                                c.chamfer > 0 ? f : c.length - f)));
  RC_ASSERT(has_volume(parts.back(), frustum_volume(n, outer, outer, c.length - f)));
}

RC_GTEST_PROP(CutterParts, contain_the_tip_and_nothing_beyond_it, ()) {
  Cutter c = any_cutter();
  c.side_rake = 0.0;
  c.back_rake = std::abs(c.back_rake);
  c.X_BC = cutter_pose(c);
  double farthest = -1.0, to_tip = 1.0;
  for (const Part& part : cutter_parts(c, any_meshing()))
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_B = part.X_BP * x_P;
      farthest = std::max(farthest, profile_normal_B(c).dot(x_B - tip_B(c)));
      to_tip = std::min(to_tip, (x_P - tip_C(c)).norm());
    }
  RC_ASSERT(to_tip == 0.0);
  RC_ASSERT(std::abs(farthest) < 1e-12);
}

TEST(CutterParts, count_the_diamond_table_once) {
  Cutter c = table('b').front();
  const std::vector<Part> chamfered = cutter_parts(c, {});
  EXPECT_EQ(chamfered[0].density, 0.0);
  EXPECT_EQ(chamfered[1].density, table_density);
  c.chamfer = 0.0;
  EXPECT_EQ(cutter_parts(c, {})[0].density, table_density);
}

TEST(CutterParts, share_their_rim_points) {
  const std::vector<Part> parts = cutter_parts(table('b').front(), {});
  const auto rim = [](const Part& part, double radius) {
    std::set<std::array<double, 3>> points;
    for (const Vec3& x : part.mesh_P.positions)
      if (std::abs(std::hypot(x.y(), x.z()) - radius) < 1e-12) points.insert({x.x(), x.y(), x.z()});
    return points;
  };
  const auto of_chamfer = rim(parts[1], 9.5e-3), of_body = rim(parts[2], 9.5e-3);
  EXPECT_EQ(of_chamfer.size(), 64u);
  EXPECT_TRUE(std::ranges::includes(of_body, of_chamfer));
  const auto of_face = rim(parts[0], 9.1e-3), front_of_chamfer = rim(parts[1], 9.1e-3);
  EXPECT_EQ(front_of_chamfer.size(), 64u);
  EXPECT_TRUE(std::ranges::includes(of_face, front_of_chamfer));
}

TEST(CutterParts, are_fine_at_the_rim_and_coarse_at_the_centre_or_even) {
  Cutter c = table('b').front();
  const auto ratio_of_edges = [&](const CutterMeshing& m) {
    const mesh::TriangleMesh face = cutter_parts(c, m).front().mesh_P;
    double shortest = 1.0, longest = 0.0;
    for (const mesh::Triangle& t : face.triangles)
      for (int k = 0; k < 3; ++k) {
        const Vec3 &a = face.positions[t[k]], &b = face.positions[t[(k + 1) % 3]];
        if (a.x() != 0.0 || b.x() != 0.0) continue;
        shortest = std::min(shortest, (b - a).norm());
        longest = std::max(longest, (b - a).norm());
      }
    return longest / shortest;
  };
  EXPECT_GT(ratio_of_edges({}), 3.0);
  EXPECT_LT(ratio_of_edges({Grading::uniform, 0, 1e-3}), 2.5);
}

/// However coarse the mesh and small the cutter.
TEST(CutterParts, have_eight_segments_around_at_least) {
  Cutter c = table('b')[0];
  const std::vector<Part> parts =
      cutter_parts(c, {.grading = Grading::uniform, .uniform_edge = 1.0});
  const auto& x = parts.back().mesh_P.positions;
  const auto on_rim = [&](const Vec3& p) { return p.tail<2>().norm() > 0.49 * c.diameter; };
  EXPECT_EQ(std::ranges::count_if(x, on_rim), 2 * 8);
}

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

/// 16 mm, chamfer 0.5 mm at 45 deg and land 1 mm at 60 deg from the axis, computed manually.
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

}  // namespace tdbd::bit::cutter_parts_test
