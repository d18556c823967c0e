#include "rock/section/underside.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mesh/search/inside.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::underside_test {

/// A closed part of about 1 m that is not convex, somewhere beside its axis.
mesh::TriangleMesh any_part() {
  mesh::TriangleMesh m = *rc::gen::element(battery::torus(0.4, 0.2, 24, 12),
                                           battery::prism(battery::l_outline(1.0, 0.4), -1.0, 0.0));
  const Pose X = *battery::pose(0.4);
  for (Vec3& x : m.positions) x = X * x;
  return m;
}

/// No point inside the part is taken for one outside, alone or by the cell or tile around it.
RC_GTEST_PROP(Underside, excludes_no_point_of_the_part, ()) {
  const mesh::TriangleMesh m = any_part();
  const double cell = *battery::number(0.01, 0.1);
  const Underside u = underside_of(m, cell);
  const mesh::TriangleTree tree(m);
  for (int k = 0; k < 200; ++k) {
    const Vec3 x(*battery::number(-1.5, 1.5), *battery::number(-1.5, 1.5),
                 *battery::number(-1.5, 1.5));
    if (!mesh::inside(tree, x)) continue;
    RC_ASSERT(may_hold(u, x));
    RC_ASSERT(may_hold(u, Around::vertex, x, 0.0));
    RC_ASSERT(
        may_hold(u, static_cast<Single>(x.head<2>().squaredNorm()), static_cast<Single>(x.z())));
    const Vec3 within(*battery::number(-0.5, 0.5), *battery::number(-0.5, 0.5),
                      *battery::number(-0.5, 0.5));
    RC_ASSERT(may_hold(u, Around::cell, x + cell * within, 0.5 * cell));
    RC_ASSERT(may_hold(u, Around::tile, x + 4.0 * cell * within, 2.0 * cell));
  }
}

/// Where a vertex is excluded, so is all that the part, turned about its axis by any angle and moved by
/// less than the room, can hold.
RC_GTEST_PROP(Underside, excludes_what_the_part_could_reach_within_its_room, ()) {
  const mesh::TriangleMesh m = any_part();
  const Underside u = underside_of(m, *battery::number(0.05, 0.2));
  const mesh::TriangleTree tree(m);
  const Mat3 turn = Eigen::AngleAxisd(*battery::number(0.0, 6.3), Vec3::UnitZ()).toRotationMatrix();
  const Vec3 away = *battery::direction();
  for (int k = 0; k < 200; ++k) {
    const Vec3 x(*battery::number(-1.5, 1.5), *battery::number(-1.5, 1.5),
                 *battery::number(-1.5, 1.5));
    if (!may_hold(u, Around::vertex, x, 0.0))
      RC_ASSERT(!mesh::inside(tree, turn * (x + u.room * away)));
  }
}

/// Below a block and beside it, by more than columns and room take.
TEST(Underside, excludes_what_is_below_or_beside) {
  const Underside u = underside_of(battery::box(Vec3(-0.5, -0.5, -1.0), Vec3(0.5, 0.5, 0.0)), 0.02);
  EXPECT_FALSE(may_hold(u, Vec3(0.1, 0.2, 0.001)));
  EXPECT_FALSE(may_hold(u, Vec3(0.52, 0.0, -0.5)));
  EXPECT_TRUE(may_hold(u, Vec3(0.1, 0.2, -0.001)));
  EXPECT_FALSE(may_hold(u, Around::vertex, Vec3(0.1, 0.2, 0.006), 0.0));
  EXPECT_FALSE(may_hold(u, Around::vertex, Vec3(0.75, 0.0, -0.5), 0.0));
  EXPECT_TRUE(may_hold(u, Around::vertex, Vec3(0.1, 0.2, 0.004), 0.0));
}

}  // namespace tdbd::rock::underside_test
