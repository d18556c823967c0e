
#include <gtest/gtest.h>

#include <set>

#include "bit/bit.hpp"
#include "bit/generate.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::update_direction_test {

const std::vector<InsideRule> inside_rules{InsideRule::down, InsideRule::plus_x,
                                           InsideRule::minus_x};
const std::vector<DirectionRule> rules{DirectionRule::hybrid, DirectionRule::all_down,
                                       DirectionRule::along_profile};

/// A cutter whose centre lies on the tip's side of the axis, as on every bit.
Cutter any_cutter_off_the_axis() {
  Cutter c = any_cutter();
  c.tip_radius = number(0.03, 0.2);
  c.side_rake = 0.0;
  c.X_BC = cutter_pose(c);
  return c;
}

RC_GTEST_PROP(UpdateDirection, is_a_unit_vector_in_the_xz_plane, ()) {
  const Vec3 u = update_direction(any_cutter_off_the_axis().X_BC, *rc::gen::elementOf(rules),
                                  *rc::gen::elementOf(inside_rules));
  RC_ASSERT(u.y() == 0.0);
  RC_ASSERT(std::abs(u.norm() - 1.0) < 1e-15);
}

RC_GTEST_PROP(UpdateDirection, does_not_depend_on_the_azimuth, ()) {
  Cutter c = any_cutter_off_the_axis();
  const DirectionRule rule = *rc::gen::elementOf(rules);
  const Vec3 before = update_direction(c.X_BC, rule, InsideRule::down);
  c.azimuth += number(0, 2 * pi);
  const Vec3 after = update_direction(cutter_pose(c), rule, InsideRule::down);
  RC_ASSERT((before - after).norm() < 1e-13 || std::abs(std::sin(c.profile_angle)) < 1e-12);
}

/// Without back rake -Z is the profile's normal, and a sharp face's centre is at its tip's azimuth.
RC_GTEST_PROP(UpdateDirection, without_back_rake_is_the_profile_normal, ()) {
  Cutter c = any_cutter_off_the_axis();
  c.back_rake = c.chamfer = 0.0;
  const Vec3 u = update_direction(cutter_pose(c), DirectionRule::along_profile, InsideRule::down);
  const Vec3 n(std::sin(c.profile_angle), 0.0, std::cos(c.profile_angle));
  RC_ASSERT((u - n).norm() < 1e-13);
}

TEST(UpdateDirection, of_inside_cutters_follows_the_reading) {
  const Pose X_BC = table('b').at(2).X_BC;  // profile angle -15 deg
  const auto inside = [&](InsideRule rule) {
    return update_direction(X_BC, DirectionRule::hybrid, rule);
  };
  EXPECT_EQ(inside(InsideRule::down), Vec3(0, 0, 1));
  EXPECT_EQ(inside(InsideRule::plus_x), Vec3(1, 0, 0));
  EXPECT_EQ(inside(InsideRule::minus_x), Vec3(-1, 0, 0));
  EXPECT_LT(update_direction(X_BC, DirectionRule::along_profile, InsideRule::down).x(), 0.0);
}

TEST(UpdateDirection, of_outside_cutters_is_along_the_profile_unless_all_go_down) {
  const Pose X_BC = table('b').at(20).X_BC;  // profile angle 76 deg
  const Vec3 along = update_direction(X_BC, DirectionRule::along_profile, InsideRule::down);
  for (const InsideRule rule : inside_rules) {
    EXPECT_EQ(update_direction(X_BC, DirectionRule::hybrid, rule), along);
    EXPECT_EQ(update_direction(X_BC, DirectionRule::all_down, rule), Vec3(0, 0, 1));
  }
  EXPECT_GT(along.x(), 0.9);
}

TEST(UpdateDirection, on_the_axis_counts_as_azimuth_zero) {
  Pose X_BC;
  X_BC.R = Eigen::AngleAxisd(pi, Vec3::UnitX()).toRotationMatrix();
  EXPECT_EQ(update_direction(X_BC, DirectionRule::along_profile, InsideRule::down), Vec3(0, 0, 1));
}

/// A solid of revolution with any number of points on each of its rings.
RC_GTEST_PROP(SurfaceOfRevolution, is_closed_and_oriented_for_any_counts, ()) {
  std::vector<Ring> rings{{0.0, 1.0, 1}};
  const int n = *rc::gen::inRange(1, 6);
  for (int k = 0; k < n; ++k)
    rings.push_back({number(0.5, 1.5), 1.0 - (k + 1.0) / (n + 1), *rc::gen::inRange(3, 40)});
  rings.push_back({0.0, 0.0, 1});
  const mesh::TriangleMesh m = surface_of_revolution(rings);
  RC_ASSERT(is_closed_and_oriented(m));
  RC_ASSERT(mesh::enclosed_volume(m) > 0.0);
}

/// Two polygons of n points with their plane of symmetry: a double cone's volume is closed-form.
RC_GTEST_PROP(SurfaceOfRevolution, of_two_cones_has_their_volume, ()) {
  const int n = *rc::gen::inRange(3, 100);
  const double r = number(0.1, 2.0), h = number(0.1, 2.0);
  const mesh::TriangleMesh m = surface_of_revolution({{0, h, 1}, {r, 0, n}, {0, -h, 1}});
  const double base = 0.5 * n * r * r * std::sin(2 * pi / n);
  RC_ASSERT(std::abs(mesh::enclosed_volume(m) - 2.0 * base * h / 3.0) < 1e-14 * base * h + 1e-16);
}

TEST(SurfaceOfRevolution, starts_every_ring_at_minus_z) {
  const mesh::TriangleMesh m = surface_of_revolution({{0, 1, 1}, {2, 0.5, 7}, {0, 0, 1}});
  EXPECT_EQ(m.positions[1], Vec3(0.5, 0.0, -2.0));
  EXPECT_GT(m.positions[2].y(), 0.0);
}

TEST(PartKinds, have_one_name_in_three_spellings) {
  EXPECT_EQ(kind_words(PartKind::cutter_body), "cutter body");
  EXPECT_EQ(kind_name(PartKind::cutter_body), "cutter-body");
  EXPECT_EQ(kind_key(PartKind::cutter_body), "cutter_body");
  EXPECT_EQ(kind_name(PartKind::face), kind_key(PartKind::face));
}

TEST(PartKinds, are_all_in_the_list_in_order_under_names_of_their_own) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < part_kinds.size(); ++k) {
    EXPECT_EQ(static_cast<std::size_t>(part_kinds[k]), k);
    names.insert(kind_name(part_kinds[k]));
  }
  EXPECT_EQ(names.size(), part_kinds.size());
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace tdbd::bit::update_direction_test
