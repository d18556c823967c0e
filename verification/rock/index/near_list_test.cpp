#include "rock/index/near_list.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "rotation/rotation_vector.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::rock::near_list_test {

const mesh::Box part_P{Vec3(-0.3, -0.1, -0.2), Vec3(0.3, 0.1, 0.2)};

/// Vertices under an index, and the list of what is near a box that moves through them.
struct Indexed {
  VertexGrid grid{{Vec3::Constant(-1.0), Vec3::Constant(1.0)}, 0.2};
  std::map<int, Vec3> points;
  NearList list;
  NearListMargins margins{*battery::number(0.0, 0.2), *battery::number(0.0, 0.5)};

  Indexed() {
    for (int v = 0; v < 300; ++v) {
      points[v] = *battery::point(1.2);
      grid.insert(v, points[v]);
    }
  }
};

/// The box at both poses, between planes normal to its axes at the first.
Region region_of(const Pose& X_WP0, const Pose& X_WP1) {
  Region r;
  for (std::size_t k = 0; k < 3; ++k) {
    Slab& s = r.slabs[k];
    s = {X_WP0.R.col(static_cast<int>(k)), INFINITY, -INFINITY};
    for (const Pose& X_WP : {X_WP0, X_WP1})
      for (int i = 0; i < 8; ++i) {
        const Vec3 x_W = X_WP * Vec3(i & 1 ? part_P.hi.x() : part_P.lo.x(),
                                     i & 2 ? part_P.hi.y() : part_P.lo.y(),
                                     i & 4 ? part_P.hi.z() : part_P.lo.z());
        s.lo = std::min(s.lo, s.n.dot(x_W));
        s.hi = std::max(s.hi, s.n.dot(x_W));
        r.box.add(x_W);
      }
  }
  return r;
}

/// What the list offers for a region: all that is there, each once, and nothing unknown.
void check_list(const Indexed& x, const Region& r) {
  std::vector<int> found;
  add_vertices_between(x.list, r, single_slack(x.list.region_W.box), found);
  for (const auto& [v, p] : x.points)
    if (is_between(r.slabs, p)) RC_ASSERT(std::ranges::count(found, v) == 1);
  for (const int v : found) RC_ASSERT(std::ranges::count(x.list.v, v) == 1);
}

/// Others change the index, or the step itself moves vertices and says so.
void change_something(Indexed& x) {
  const int v = *battery::integer(0, 299);
  const Vec3 to = *battery::point(1.2);
  const bool is_own = *rc::gen::arbitrary<bool>();
  const bool knows = x.list.changes == x.grid.changes();
  x.grid.move(v, to);
  x.points[v] = to;
  if (!is_own || !knows) return;
  if (is_between(x.list.region_W.slabs, to)) note_moved(x.list, v, to);
  x.list.changes = x.grid.changes();
}

RC_GTEST_PROP(NearList, holds_all_that_a_step_needs_whatever_moves, ()) {
  Indexed x;
  Pose X_WP = *battery::pose(0.5);
  const Pose step{rotation::exp(*battery::number(0.0, 0.2) * *battery::direction()),
                  *battery::number(0.0, 0.1) * *battery::direction()};
  for (int k = 0; k < 12; ++k) {
    const Pose next = *battery::integer(0, 5) == 0 ? *battery::pose(0.5) : X_WP * step;
    const Region r = region_of(X_WP, next);
    bring_up_to_date(x.grid, {part_P, X_WP, next, r}, x.margins, x.list);
    RC_ASSERT(covers(x.list, x.grid, r));
    check_list(x, r);
    if (*battery::integer(0, 2) == 0) change_something(x);
    X_WP = next;
  }
}

/// A steady turn: after some steps the index is queried once in eight; more often where others
/// change it meanwhile.
TEST(NearList, is_made_once_in_several_steps) {
  VertexGrid grid({Vec3::Constant(-1.0), Vec3::Constant(1.0)}, 0.2);
  grid.insert(0, Vec3::Zero());
  NearList list;
  const Pose step{rotation::exp(Vec3(0.0, 0.0, 0.01)), Vec3(0.0, 0.0, 0.001)};
  Pose X_WP{Mat3::Identity(), Vec3(0.8, 0.0, 0.0)};
  const auto times_made = [&](int steps, int change_every) {
    int made = 0;
    for (int k = 0; k < steps; ++k) {
      if (change_every > 0 && k % change_every == 0) grid.move(0, Vec3::Zero());
      const Vec3 before = list.origin_W;
      const Pose next = X_WP * step;
      bring_up_to_date(grid, {part_P, X_WP, next, region_of(X_WP, next)}, {}, list);
      made += before != list.origin_W ? 1 : 0;
      X_WP = next;
    }
    return made;
  };
  times_made(60, 0);
  EXPECT_EQ(times_made(80, 0), 10);
  times_made(20, 5);
  EXPECT_EQ(times_made(50, 5), 10);
}

}  // namespace tdbd::rock::near_list_test
