#include "rock/cut/wide_paths.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rock/cut/mapped_direction.hpp"
#include "rotation/rotation_vector.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::rock::wide_paths_test {

Pose any_pose() {
  return {rotation::exp(*battery::number(0.0, 3.0) * *battery::direction()), *battery::point(1.0)};
}

CuttingGroup any_group() {
  CuttingGroup g{};
  g.X_BP = g.X_BP1 = any_pose();
  g.update_direction_B = *battery::direction();
  g.box_P = {-Vec3::Ones(), Vec3::Ones()};
  g.directions = *rc::gen::element(DirectionFrame::upright, DirectionFrame::bit);
  return g;
}

/// Bitwise, on the axis of D as well.
RC_GTEST_PROP(WidePaths, are_those_of_one_vertex_after_another, ()) {
  const CuttingGroup g = any_group();
  const Pose X_WB0 = any_pose();
  const Pose X_WB1{X_WB0.R * rotation::exp(*battery::number(0.0, 0.1) * *battery::direction()),
                   X_WB0.p + 0.1 * *battery::point(1.0)};
  const GroupMotion m = group_motion(g, X_WB0, X_WB1);
  std::array<Vec3, lanes> places_W;
  std::array<const Vec3*, lanes> x_W{};
  for (std::size_t l = 0; l < lanes; ++l) {
    places_W[l] = *rc::gen::element(0, 1) == 0 ? X_WB1.p : *battery::point(1.0);
    x_W[l] = &places_W[l];
  }
  WidePaths wide;
  find_paths(g, m, x_W, wide);
  for (std::size_t l = 0; l < lanes; ++l) {
    const Vec3 u_W = mapped_direction_W(g, m, places_W[l]);
    const RelativePath expected = relative_path(m.X_PW0, m.X_PW1, places_W[l], u_W),
                       path = path_of(wide, l);
    RC_ASSERT(lane_of(wide.u_W, l) == u_W);
    RC_ASSERT(path.q0_P == expected.q0_P && path.q1_P == expected.q1_P);
    RC_ASSERT(path.u0_P == expected.u0_P && path.u1_P == expected.u1_P);
  }
}

}  // namespace tdbd::rock::wide_paths_test
