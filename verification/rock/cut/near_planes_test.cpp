#include "rock/cut/near_planes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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

/// Bit for bit where the order of planes does not decide; rounding where it does.
RC_GTEST_PROP(NearPlanes, give_the_exits_of_the_whole_part, ()) {
  const CuttingPart part = part_of(
      *rc::gen::oneOf(battery::convex_polyhedron(), rc::gen::just(battery::cylinder(1, 0.5, 64))));
  const std::vector<RelativePath> paths = *rc::gen::exec(bundle);
  SweptScratch near, whole;
  prepare_exits(part, paths, near);
  for (const RelativePath& p : paths) {
    const auto t = prepared_exit_distance(part, p, near);
    const auto expected = exit_distance(part, p, whole);
    RC_ASSERT(t.has_value() == expected.has_value());
    if (t) RC_ASSERT(std::abs(*t - *expected) < 1e-8);
  }
}

/// A few candidates at a cutter's tip see a fraction of its planes.
TEST(NearPlanes, are_few_at_a_cutters_tip) {
  const CuttingPart disc = part_of(battery::cylinder(1.0, 0.5, 64));
  const Vec3 tip(-0.99, 0.0, 0.1), way(0.0, 0.0, 0.05), u(-1.0, 0.0, 0.0);
  NearPlanes near;
  find_near_planes(disc.solid_P, {{tip, tip + way, u, u}}, disc.depth, 0.1, near);
  EXPECT_GT(near.solid_P.planes, 2U);
  EXPECT_LT(near.solid_P.planes, 24U);
}

}  // namespace tdbd::rock::near_planes_test
