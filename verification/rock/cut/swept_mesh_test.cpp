#include "rock/cut/swept_mesh.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "core/random.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"
#include "reference/rock/brute_force_exit.hpp"
#include "rock/cut/swept_part.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::swept_mesh_test {

using mesh::TriangleMesh;
using mesh::TriangleTree;

constexpr double depth = 1e-12;

Vec3 at(const RelativePath& p, double tau, double t) {
  return (1.0 - tau) * (p.q0_P + t * p.u0_P) + tau * (p.q1_P + t * p.u1_P);
}

/// A way within a cube of half edge `way`, and a direction that turns by about `turn` on it.
RelativePath any_path(double way, double turn) {
  RelativePath p;
  p.q0_P = *battery::point(0.7);
  p.q1_P = p.q0_P + *battery::point(way);
  p.u0_P = *battery::direction();
  p.u1_P = (p.u0_P + turn * *battery::point(1.0)).normalized();
  return p;
}

std::optional<double> exit_of(const TriangleMesh& m, const RelativePath& p) {
  MeshScratch scratch;
  return exit_distance(TriangleTree(m), p, depth, scratch);
}

/// The exits of a convex part as a mesh and as planes; nothing where both say it is not swept.
std::optional<std::pair<double, double>> both_exits(const TriangleMesh& part,
                                                    const RelativePath& p) {
  const TriangleTree tree(part);
  const mesh::ConvexSolid solid = *mesh::convex_solid(part);
  MeshScratch ours;
  PlaneStrip theirs;
  const auto t = exit_distance(tree, p, depth, ours);
  const auto expected = exit_distance(solid, p, depth, theirs);
  RC_TAG(t ? "swept" : "missed");
  RC_ASSERT(is_swept(tree, p, depth, ours) == is_swept(solid, p, depth));
  RC_ASSERT(t.has_value() == expected.has_value());
  return t ? std::optional(std::pair(*t, *expected)) : std::nullopt;
}

RC_GTEST_PROP(SweptMesh, equals_swept_convex_along_a_constant_direction, ()) {
  const auto exits = both_exits(*battery::convex_polyhedron(), any_path(0.5, 0.0));
  if (exits) RC_ASSERT(std::abs(exits->first - exits->second) < 1e-12);
}

RC_GTEST_PROP(SweptMesh, equals_swept_convex_along_a_turning_direction, ()) {
  const auto exits = both_exits(*battery::convex_polyhedron(), any_path(0.3, 0.05));
  if (exits) RC_ASSERT(std::abs(exits->first - exits->second) < 1e-12);
}

/// Whether a sub-pose of the twin's puts the level t inside; with `slack`, or near enough that a
/// pose between two of them may.
bool twin_sees(const TriangleMesh& m, const TriangleTree& tree, const RelativePath& p, double t,
               bool slack) {
  constexpr int substeps = 100;
  const double half_way = (at(p, 1.0, t) - at(p, 0.0, t)).norm() / (2 * substeps) + 1e-9;
  for (int k = 0; k <= substeps; ++k) {
    const Vec3 x = at(p, static_cast<double>(k) / substeps, t);
    if (slack && mesh::is_near(tree, x, half_way)) return true;
    if (reference::inside(m, x)) return true;
  }
  return false;
}

/// The meaning of the exit by the twin's own predicate: no sub-pose reaches the level just above
/// the exit, and every level below it is reached at or between sub-poses.
void expect_exit_by_twin(const TriangleMesh& part, const RelativePath& p) {
  const TriangleTree tree(part);
  const auto t = exit_of(part, p);
  const auto twin = reference::brute_force_exit(part, p.q0_P, p.q1_P, p.u0_P, p.u1_P, 50);
  RC_TAG(t ? "swept" : "missed");
  if (!t) {
    RC_ASSERT(!twin.swept);
    return;
  }
  RC_ASSERT(twin_sees(part, tree, p, 0.0, true));
  RC_ASSERT(!twin_sees(part, tree, p, *t + 1e-8, false));
  for (int k = 1; k < 20; ++k) RC_ASSERT(twin_sees(part, tree, p, *t * k / 20, true));
}

RC_GTEST_PROP(SweptMesh, exit_is_the_twins_on_prisms, ()) {
  expect_exit_by_twin(*battery::nonconvex_prism(), any_path(0.3, 0.2));
}

RC_GTEST_PROP(SweptMesh, exit_is_the_twins_on_stars, ()) {
  expect_exit_by_twin(*battery::star_shape(), any_path(0.3, 0.2));
}

/// A prism over an L, a U or a star, turned anyhow; as `battery::nonconvex_prism`, but from a seed.
TriangleMesh seeded_prism(Random& random, int k) {
  const std::vector<Eigen::Vector2d> outlines[] = {battery::l_outline(1.6, 0.4),
                                                   battery::u_outline(1.6, 0.3),
                                                   battery::star_outline(1.0, 0.3, 5)};
  const Vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  const Eigen::AngleAxisd turn(random.uniform(0.0, 3.0), axis.normalized());
  return battery::placed({turn.toRotationMatrix(), Vec3::Zero()},
                         battery::prism(outlines[k % 3], -0.4, 0.4));
}

/// The twin's exit is lower by at most half the way between two sub-poses times the slope of the
/// face that is left. From a seed, because a face nearly parallel to u has any slope.
TEST(SweptMesh, is_the_limit_of_the_twin) {
  Random random{20240607};
  const auto any = [&](double half) {
    return Vec3(random.uniform(-half, half), random.uniform(-half, half),
                random.uniform(-half, half));
  };
  std::vector<double> above_twin;
  for (int k = 0; k < 400; ++k) {
    const TriangleMesh part = seeded_prism(random, k);
    RelativePath p{any(0.6), {}, any(1.0).normalized(), {}};
    p.q1_P = p.q0_P + any(0.3);
    p.u1_P = (p.u0_P + any(0.1)).normalized();
    const auto t = exit_of(part, p);
    const auto twin = reference::brute_force_exit(part, p.q0_P, p.q1_P, p.u0_P, p.u1_P, 1000);
    EXPECT_LE(twin.swept, t.has_value()) << k;
    if (t && twin.swept) above_twin.push_back(*t - twin.t);
  }
  std::sort(above_twin.begin(), above_twin.end());
  ASSERT_GE(above_twin.size(), 150u);
  EXPECT_GE(above_twin.front(), -1e-14);
  EXPECT_LE(above_twin[above_twin.size() / 2], 1e-14);
  EXPECT_LE(above_twin.back(), 9e-4);
}

const Vec3 up_y(0, 1, 0), to_x(1, 0, 0);
const TriangleMesh u_prism = battery::prism(battery::u_outline(2.0, 0.5), -1.0, 1.0);

TEST(SweptMesh, leaves_the_first_arm_of_a_u_at_its_slot) {
  EXPECT_NEAR(*exit_of(u_prism, {{-0.9, 0, 0}, {-0.8, 0, 0}, to_x, to_x}), 0.4, 1e-14);
}

/// The part moves on by more than the slot's width: the second arm comes before the first has left.
TEST(SweptMesh, goes_through_both_arms_of_a_u_that_moves_far_enough) {
  EXPECT_NEAR(*exit_of(u_prism, {{-0.9, 0, 0}, {-2.0, 0, 0}, to_x, to_x}), 3.0, 1e-14);
}

TEST(SweptMesh, stays_in_the_slot_of_a_u) {
  EXPECT_FALSE(exit_of(u_prism, {{-0.4, 0, 0}, {0.4, 0.1, 0}, up_y, up_y}));
}

/// Along the arm, from its root: the whole band up to the end is inside, without a crossing.
TEST(SweptMesh, follows_an_arm_to_its_end) {
  EXPECT_NEAR(*exit_of(u_prism, {{-0.8, -0.8, 0}, {-0.7, -0.8, 0}, up_y, up_y}), 1.8, 1e-14);
  EXPECT_NEAR(*exit_of(u_prism, {{0.2, -0.8, 0}, {0.3, -0.8, 0}, up_y, up_y}), 0.3, 1e-14);
}

TEST(SweptMesh, no_plate_is_too_thin_for_a_step) {
  const TriangleMesh plate = battery::box({-1, -1, -1e-6}, {1, 1, 1e-6});
  const Vec3 down(0, 0, 1);
  EXPECT_NEAR(*exit_of(plate, {{0.1, 0.2, 1}, {0.3, 0.1, -1}, down, down}), 1.0 + 1e-6, 1e-14);
}

/// Set down by an earlier step: on the surface or deeper by less than `depth`.
TEST(SweptMesh, does_not_pick_up_a_vertex_on_its_surface) {
  for (const double off : {-0.5 * depth, 0.0, 0.5 * depth})
    for (const Vec3& way : {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 0, 0.1), Vec3(0, 0.1, 0)})
      EXPECT_FALSE(
          exit_of(u_prism, {Vec3(-0.5 + off, 0.5, 0), Vec3(-0.5 + off, 0.5, 0) + way, up_y, up_y}))
          << off << " " << way.transpose();
}

}  // namespace tdbd::rock::swept_mesh_test
