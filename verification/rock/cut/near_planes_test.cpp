#include "rock/cut/near_planes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "core/tolerance.hpp"
#include "rock/cut/swept_part.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::near_planes_test {

CuttingPart part_of(const mesh::TriangleMesh& m) {
  bit::Bit bit;
  bit.parts.push_back({});
  bit.parts.back().mesh_P = m;
  return prepare_cutting_bit(bit).groups[0].parts[0];
}

/// Neighbours on nearly the same way, as the candidates of a part are.
std::vector<RelativePath> bundle() {
  const Vec3 q = *battery::point(0.8), way = 0.3 * *battery::point(1.0), u = *battery::direction();
  std::vector<RelativePath> paths;
  for (int k = 0; k < 8; ++k) {
    const Vec3 start = q + 0.1 * *battery::point(1.0);
    paths.push_back({start, start + way, (u + 0.05 * *battery::point(1.0)).normalized(),
                     (u + 0.05 * *battery::point(1.0)).normalized()});
  }
  return paths;
}

/// Around all of the paths.
PathBoxes boxes_around_all(const std::vector<RelativePath>& paths) {
  std::vector<std::size_t> which(paths.size());
  std::iota(which.begin(), which.end(), std::size_t{0});
  return boxes_around(paths, which);
}

rc::Gen<mesh::TriangleMesh> any_part() {
  return rc::gen::oneOf(battery::convex_polyhedron(), rc::gen::just(battery::cylinder(1, 0.5, 64)));
}

/// Bit for bit, with what was remembered from other paths and other parts: a restart, which
/// remembers nothing, goes on as if there had been none.
RC_GTEST_PROP(NearPlanes, give_the_exits_of_the_whole_part_to_the_bit, ()) {
  SweptScratch near, whole;
  for (int k = 0; k < 4; ++k) {
    const CuttingPart part = part_of(*any_part());
    for (int again = 0; again < 3; ++again) {
      const std::vector<RelativePath> paths = *rc::gen::exec(bundle);
      prepare_exits(part, boxes_around_all(paths), near);
      for (const RelativePath& p : paths)
        RC_ASSERT(prepared_exit_distance(part, p, near) == exit_distance(part, p, whole));
    }
  }
}

/// The plane's number is the whole part's.
RC_GTEST_PROP(NearPlanes, tell_through_which_plane_of_the_part_a_path_leaves, ()) {
  const CuttingPart part = part_of(*any_part());
  const std::vector<RelativePath> paths = *rc::gen::exec(bundle);
  SweptScratch near;
  PlaneStrip strip;
  prepare_exits(part, boxes_around_all(paths), near);
  for (const RelativePath& p : paths) {
    const auto x = prepared_exit(part, p, near);
    const auto expected = find_exit(part.solid_P, p, part.depth, strip);
    RC_ASSERT(x.has_value() == expected.has_value());
    if (x) RC_ASSERT(x->plane == expected->plane && x->tau == expected->tau);
  }
}

/// Paths that are not named may be anywhere.
TEST(NearPlanes, are_found_for_boxes_around_the_paths_that_are_named) {
  const Vec3 x(1, 2, 3), far(9, 9, 9);
  const PathBoxes boxes = boxes_around({{far, far, far, far}, {x, 2 * x, 3 * x, 4 * x}}, {1});
  EXPECT_EQ(boxes.q_P.lo, x);
  EXPECT_EQ(boxes.q_P.hi, 2 * x);
  EXPECT_EQ(boxes.u_P.lo, 3 * x);
  EXPECT_EQ(boxes.u_P.hi, 4 * x);
}

/// Paths within the boxes of those before find nothing anew.
TEST(NearPlanes, are_kept_for_paths_beside_those_they_were_found_for) {
  const CuttingPart disc = part_of(battery::cylinder(1.0, 0.5, 64));
  const Vec3 tip(-0.99, 0.0, 0.1), way(0.0, 0.0, 0.05), u(-1.0, 0.0, 0.0);
  NearPlanes near;
  const auto update = [&](const Vec3& x) {
    update_near_planes(disc.solid_P, disc.checksum, boxes_around_all({{x, x + way, u, u}}),
                       disc.depth, 0.1, near);
    return near.uses;
  };
  EXPECT_EQ(update(tip), 0);
  EXPECT_EQ(update(tip + Vec3(0, 1e-3, 0)), 1);
  EXPECT_EQ(update(tip + Vec3(0, 1e-1, 0)), 0);
}

/// A few candidates at a cutter's tip see a fraction of its planes.
TEST(NearPlanes, are_few_at_a_cutters_tip) {
  const CuttingPart disc = part_of(battery::cylinder(1.0, 0.5, 64));
  const Vec3 tip(-0.99, 0.0, 0.1), way(0.0, 0.0, 0.05), u(-1.0, 0.0, 0.0);
  NearPlanes near;
  find_near_planes(disc.solid_P, boxes_around_all({{tip, tip + way, u, u}}), disc.depth, 0.1, near);
  EXPECT_GT(near.solid_P.planes, 2U);
  EXPECT_LT(near.solid_P.planes, 24U);
}

}  // namespace tdbd::rock::near_planes_test
