#include <gtest/gtest.h>

#include "mesh/surface.hpp"
#include "simulation/study/levels.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::simulation::hole_test {

/// A sheet of [-1, 1]^2 at z = 0 of which the inner square |x|, |y| < 0.55 was moved down by d.
rock::Rock stamped(int divisions, double d) {
  const mesh::TriangleMesh m = battery::flat_rock(1.0, 0.0, divisions);
  rock::Rock rock = rock::make_rock(mesh::make_surface(m), 0.2, mesh::bounding_box(m));
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    Vec3& x = rock.surface.stars[at(v)].x;
    if (x.head<2>().cwiseAbs().maxCoeff() > 0.55) continue;
    x.z() = d;
    rock.last_part[at(v)] = 0;
  }
  return rock;
}

TEST(Hole, is_what_was_moved_with_its_rim) {
  const Hole hole = hole_of(stamped(10, 0.3));
  EXPECT_EQ(hole.rock.triangles.size(), 200u);
  double widest = 0.0;
  for (const mesh::Triangle& t : hole.cut.triangles)
    for (const int v : t) widest = std::max(widest, hole.cut.positions[at(v)].x());
  EXPECT_NEAR(widest, 0.6, 1e-12);  // one edge of 0.2 beyond what was moved
  EXPECT_GT(hole.edge, 0.2);
  EXPECT_LT(hole.edge, 0.3);
}

TEST(Hole, of_two_depths_differs_by_the_step_between_them) {
  const Hole deep = hole_of(stamped(10, 0.3)), deeper = hole_of(stamped(10, 0.35));
  const HoleDifference d = difference(deep, deeper);
  EXPECT_NEAR(d.largest, 0.05, 1e-12);
  EXPECT_NEAR(d.radius, 0.6, 1e-12);
  const double bottom = 0.8 * 0.8 * 0.05;
  EXPECT_GT(d.volume, bottom);
  EXPECT_LT(d.volume, 1.2 * 1.2 * 0.05);  // and part of the flanks, 0.2 wide
  const HoleDifference back = difference(deeper, deep);
  EXPECT_EQ(back.largest, d.largest);
  EXPECT_DOUBLE_EQ(back.volume, d.volume);
}

TEST(Hole, does_not_differ_from_itself) {
  const Hole hole = hole_of(stamped(7, 0.3));
  constexpr double rounding = 2e-16;  // m, of points in the planes of triangles
  EXPECT_LE(difference(hole, hole).largest, rounding);
  EXPECT_LE(difference(hole, hole).volume, rounding);
}

TEST(Hole, of_rock_that_nothing_cut_is_empty) {
  const Hole none = hole_of(stamped(10, 0.0));
  mesh::TriangleMesh m = battery::flat_rock(1.0, 0.0, 5);
  const Hole untouched =
      hole_of(rock::make_rock(mesh::make_surface(m), 0.2, mesh::bounding_box(m)));
  EXPECT_TRUE(untouched.cut.triangles.empty());
  EXPECT_EQ(difference(untouched, untouched).largest, 0.0);
  EXPECT_EQ(difference(untouched, none).largest, 0.0);
  EXPECT_NEAR(difference(untouched, hole_of(stamped(10, 0.3))).largest, 0.3, 1e-12);
}

}  // namespace tdbd::simulation::hole_test
