#include "rock/index/near_region.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rotation/rotation_vector.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::rock::near_region_test {

const mesh::Box box_P{Vec3(-8e-3, -6e-3, -2e-3), Vec3(8e-3, 6e-3, 2e-3)};

/// The box at both poses, between planes normal to its axes at the second, as rock/cut makes it.
Region region_of(const Pose& X_WP0, const Pose& X_WP1) {
  Region r;
  for (std::size_t k = 0; k < 3; ++k) {
    Slab& s = r.slabs[k];
    s = {X_WP1.R.col(static_cast<int>(k)), INFINITY, -INFINITY};
    for (const Pose* X_WP : {&X_WP0, &X_WP1})
      for (int i = 0; i < 8; ++i) {
        const double along = s.n.dot(*X_WP * Vec3(i & 1 ? box_P.hi.x() : box_P.lo.x(),
                                                  i & 2 ? box_P.hi.y() : box_P.lo.y(),
                                                  i & 4 ? box_P.hi.z() : box_P.lo.z()));
        s.lo = std::min(s.lo, along);
        s.hi = std::max(s.hi, along);
      }
  }
  r.box = box_around(r.slabs);
  return r;
}

/// A cutter anywhere on a bit of 8.5 in at up to 120 rpm and 1 ms, without margins: its region for
/// eight steps holds them all, so that volumes alone do not make lists anew each step.
RC_GTEST_PROP(NearRegion, holds_all_the_steps_it_is_made_for, ()) {
  constexpr int steps = 8;
  const Pose X_BP{(*battery::pose(1.0)).R, Vec3(*battery::number(0.0, 0.108), 0.0, 0.0)};
  const Mat3 turn = rotation::exp(Vec3(0.0, 0.0, *battery::number(0.0, 0.0126)));
  Pose X_WB{Mat3::Identity(), Vec3::Zero()};
  const auto next_of = [&](const Pose& X) {
    return Pose{Mat3(turn * X.R), X.p + Vec3(0.0, 0.0, 4e-6)};
  };
  Region ahead;
  for (int k = 0; k < steps; ++k) {
    const Pose next = next_of(X_WB), X_WP0 = X_WB * X_BP, X_WP1 = next * X_BP;
    const Region r = region_of(X_WP0, X_WP1);
    if (k == 0) ahead = region_ahead({box_P, X_WP0, X_WP1, r}, {}, steps);
    RC_ASSERT(holds(ahead, r));
    X_WB = next;
  }
}

TEST(NearRegion, tells_what_it_holds) {
  const Pose X{Mat3::Identity(), Vec3::Zero()};
  const Region r = region_of(X, X);
  EXPECT_TRUE(holds(widened(r, 1e-6), r));
  EXPECT_FALSE(holds(r, widened(r, 1e-6)));
}

}  // namespace tdbd::rock::near_region_test
