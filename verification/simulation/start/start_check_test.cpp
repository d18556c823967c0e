#include "simulation/start/start_check.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rock/start/borehole.hpp"

namespace tdbd::simulation::start_check_test {

/// A bowl: flat bottom of radius 0.1 at depth 0.05, wall up to depth 0.02.
mesh::Surface bowl() {
  return mesh::make_surface(rock::borehole(rock::flat_bottom(0.1, 0.05, 0.03), 0.01));
}

TEST(CoverAbove, is_nothing_in_the_hole) {
  for (const Vec3& x : {Vec3(0, 0, 0.049), Vec3(0.05, 0.03, 0.03), Vec3(0.09, 0, -1)})
    EXPECT_EQ(rock_height_above(bowl(), x), 0.0);
}

TEST(CoverAbove, is_the_depth_below_the_bottom) {
  for (const Vec3& x : {Vec3(0, 0, 0.06), Vec3(0.05, 0.03, 0.06), Vec3(0.01, 0, 0.06)})
    EXPECT_NEAR(rock_height_above(bowl(), x), 0.01, 1e-15);
}

TEST(CoverAbove, is_nothing_where_there_is_no_surface_above) {
  EXPECT_EQ(rock_height_above(bowl(), Vec3(0.2, 0, 0.06)), 0.0);
}

/// Below a ledge the open is what lies under its lower face, and rock what lies in it.
TEST(CoverAbove, distinguishes_a_ledge_from_the_space_below_it) {
  using rock::MeridianPoint;
  const mesh::Surface hollow = mesh::make_surface(rock::borehole(
      {{0.0, 0.1}, {0.1, 0.1}, {0.1, 0.08}, {0.05, 0.07}, {0.05, 0.05}, {0.1, 0.04}}, 0.005));
  EXPECT_EQ(rock_height_above(hollow, Vec3(0.08, 0.0, 0.09)), 0.0);
  EXPECT_GT(rock_height_above(hollow, Vec3(0.08, 0.0, 0.06)), 0.01);
  EXPECT_GT(rock_height_above(hollow, Vec3(0.08, 0.0, 0.11)), 0.01);
  EXPECT_EQ(rock_height_above(hollow, Vec3(0.0, 0.0, 0.06)), 0.0);
}

/// Every face against the point, none left out.
double cover_by_all_faces(const mesh::Surface& rock, const Vec3& x_W) {
  const Vec3 p = x_W + Vec3(1.37e-8, 2.11e-8, 0.0);
  const auto cross = [](const Vec3& a, const Vec3& b) { return a.x() * b.y() - a.y() * b.x(); };
  int up_minus_down = 0;
  double cover = 0.0;
  for (const mesh::Triangle& t : rock.triangles) {
    const Vec3 a = rock.position(t[0]) - p, b = rock.position(t[1]) - p,
               c = rock.position(t[2]) - p;
    const double wa = cross(b, c), wb = cross(c, a), wc = cross(a, b), sum = wa + wb + wc;
    if (std::min({wa, wb, wc}) < 0.0 && std::max({wa, wb, wc}) > 0.0) continue;
    const double height = sum == 0.0 ? 0.0 : -(wa * a.z() + wb * b.z() + wc * c.z()) / sum;
    if (height <= 0.0) continue;
    up_minus_down += sum < 0.0 ? 1 : -1;
    cover = std::max(cover, height);
  }
  return up_minus_down > 0 ? cover : 0.0;
}

RC_GTEST_PROP(CoversAbove, are_those_of_every_point_against_every_face, ()) {
  const mesh::Surface hollow = mesh::make_surface(rock::borehole(
      {{0.0, 0.1}, {0.1, 0.1}, {0.1, 0.08}, {0.05, 0.07}, {0.05, 0.05}, {0.1, 0.04}}, 0.01));
  std::vector<Vec3> points;
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(0, 40));
  const auto upto = [](int mm) { return 1e-3 * *rc::gen::inRange(-mm, mm + 1); };
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(upto(120), upto(120), 0.08 + upto(40));
  const std::vector<double> covers = rock_heights_above(hollow, points);
  RC_ASSERT(covers.size() == n);
  for (std::size_t i = 0; i < n; ++i) RC_ASSERT(covers[i] == cover_by_all_faces(hollow, points[i]));
}

}  // namespace tdbd::simulation::start_check_test
