#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "core/random.hpp"
#include "core/tolerance.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/convex_hull.hpp"
#include "reference/rock/brute_force_exit.hpp"
#include "reference/rock/exit_by_corners.hpp"
#include "rock/cut/group_cut.hpp"
#include "rock/cut/swept_part.hpp"
#include "rock/cut/wide_exits.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::swept_convex_test {

using mesh::TriangleMesh;
using reference::brute_force_exit;

/// A part and a vertex's path past it. Parts have the size of the unit cube.
struct Pass {
  TriangleMesh part;
  RelativePath path;
};

Vec3 at(const Vec3& x0, const Vec3& x1, double tau) { return (1.0 - tau) * x0 + tau * x1; }

/// How deep x is behind the planes of a convex mesh's own triangles; negative outside.
double depth_in(const TriangleMesh& m, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : m.triangles) {
    const Vec3 n = mesh::area_vector(m.positions[a], m.positions[b], m.positions[c]);
    if (n.norm() > 1e-12) least = std::min(least, n.normalized().dot(m.positions[a] - x));
  }
  return least;
}

/// The deepest that q(tau) + t u(tau) gets, by sections: a concave function of tau when u rests.
double deepest(const Pass& p, double t) {
  const auto depth = [&](double tau) {
    return depth_in(p.part,
                    at(p.path.q0_P, p.path.q1_P, tau) + t * at(p.path.u0_P, p.path.u1_P, tau));
  };
  double lo = 0.0, hi = 1.0;
  for (int k = 0; k < 100; ++k) {
    const double a = lo + (hi - lo) / 3.0, b = hi - (hi - lo) / 3.0;
    (depth(a) < depth(b) ? lo : hi) = depth(a) < depth(b) ? a : b;
  }
  return depth(0.5 * (lo + hi));
}

double size_of(const TriangleMesh& m) { return mesh::bounding_box(m).size().norm(); }

/// Every kind of convex part: hulls, boxes, discs; thin ones too.
rc::Gen<TriangleMesh> convex_part() {
  const auto box = rc::gen::map(battery::point(1.0), [](const Vec3& half) {
    const Vec3 h = half.cwiseAbs() + Vec3::Constant(0.02);
    return battery::box(-h, h);
  });
  const auto disc = rc::gen::apply(
      [](double r, double l, int sides) { return battery::cylinder(r, l, sides); },
      battery::number(0.2, 1.0), battery::number(0.02, 1.0), rc::gen::inRange(3, 24));
  const auto placed =
      rc::gen::apply([](const Pose& X, TriangleMesh m) { return battery::placed(X, m); },
                     battery::pose(0.3), rc::gen::oneOf(box, disc));
  return rc::gen::oneOf(battery::convex_polyhedron(), placed);
}

/// Paths up to the part's own size, that start in it or near it; the direction turns by up to
/// `turn` rad.
rc::Gen<Pass> pass(double turn) {
  return rc::gen::apply(
      [turn](const TriangleMesh& part, const Vec3& q0, const Vec3& d, const Vec3& u,
             const Vec3& w) {
        const Vec3 axis = turn * w;
        const Mat3 R = axis.norm() > 0.0
                           ? Eigen::AngleAxisd(axis.norm(), axis.normalized()).toRotationMatrix()
                           : Mat3(Mat3::Identity());
        return Pass{part, {q0, q0 + d, u, R * u}};
      },
      convex_part(), battery::point(0.8), battery::point(0.7), battery::direction(),
      battery::point(0.57));
}

/// Production's answers to one pass.
struct Answer {
  mesh::ConvexSolid solid;
  double depth;
  bool swept;
  std::optional<double> exit;
};

Answer answer(const Pass& p) {
  Answer a;
  a.solid = *mesh::convex_solid(p.part);
  a.depth = tolerance::swept * size_of(p.part);
  PlaneStrip scratch;
  a.swept = is_swept(a.solid, p.path, a.depth);
  a.exit = exit_distance(a.solid, p.path, a.depth, scratch);
  return a;
}

reference::SweptExit twin(const Pass& p, int substeps) {
  return brute_force_exit(p.part, p.path.q0_P, p.path.q1_P, p.path.u0_P, p.path.u1_P, substeps);
}

/// The twin sees what is deeper than half the way between two of its sub-poses, for certain.
double resolution(const Pass& p, int substeps) {
  return 0.5 * (p.path.q1_P - p.path.q0_P).norm() / substeps;
}

RC_GTEST_PROP(IsSwept, equals_the_twin_beyond_its_resolution, ()) {
  const Pass p = *pass(0.0);
  const Answer a = answer(p);
  constexpr int substeps = 32;
  const double depth = deepest(p, 0.0);
  RC_ASSERT(a.swept == a.exit.has_value());
  RC_PRE(std::abs(depth) > 1e-9);
  RC_TAG(a.swept ? "swept" : "missed");
  RC_ASSERT(a.swept == (depth > 0.0));
  if (!a.swept) RC_ASSERT(!twin(p, substeps).swept);
  if (depth > resolution(p, substeps)) RC_ASSERT(twin(p, substeps).swept && a.swept);
}

/// A plane beside a path shows that the whole solid is nowhere swept, and is found if there is one. Paths
/// begin on a plane or about as deep as counts: so do those of vertices that a part left behind.
RC_GTEST_PROP(PlaneBesidePath, shows_that_a_path_sweeps_nothing, ()) {
  const mesh::ConvexSolid solid = *mesh::convex_solid(*battery::convex_polyhedron());
  const double depth = *rc::gen::element(0.0, 1e-12, 1e-3);
  const double begins = depth * *battery::number(0.0, 3.0);
  const auto on = tdbd::at(*battery::integer(0, static_cast<int>(solid.planes) - 1));
  Vec3 q0 = *battery::point(1.0);
  q0 -= (mesh::normal(solid, on).dot(q0) - solid.b[on] + begins) * mesh::normal(solid, on);
  const RelativePath path{q0, q0 + 0.2 * *battery::point(1.0), Vec3::UnitZ(), Vec3::UnitZ()};
  PlaneStrip strip;
  const auto sweeps = [&](const mesh::ConvexSolid& s) {
    const Interval inside = put_path_on_strip(s, path, depth, strip);
    return inside.lo < inside.hi;
  };
  std::size_t first = solid.b.size();
  for (std::size_t i = solid.planes; i-- > 0;) {
    mesh::ConvexSolid half_space;
    mesh::add_plane(half_space, mesh::normal(solid, i), solid.b[i]);
    mesh::pad(half_space);
    const bool is_beside = is_beside_path(solid, i, path.q0_P, path.q1_P, depth);
    RC_ASSERT(is_beside == !sweeps(half_space));
    if (is_beside) first = i;
  }
  RC_ASSERT(plane_beside_path(solid, path.q0_P, path.q1_P, depth) == first);
  if (first < solid.b.size()) RC_ASSERT(!sweeps(solid));
}

RC_GTEST_PROP(DepthInside, is_positive_inside_alone, ()) {
  const TriangleMesh part = *convex_part();
  const Vec3 x = *battery::point(1.2);
  const double depth = depth_inside(*mesh::convex_solid(part), x);
  RC_PRE(std::abs(depth) > 1e-9);
  RC_TAG(depth > 0.0 ? "inside" : "outside");
  RC_ASSERT(reference::inside(part, x) == (depth > 0.0));
  RC_ASSERT(std::abs(depth - depth_in(part, x)) < 1e-12);
}

/// For a direction that rests the twin converges from below, and at the exact exit the strip still
/// touches the solid: both bounds are sharp, so the exit is exact.
RC_GTEST_PROP(ExitDistance, is_where_the_last_ray_leaves_the_solid, ()) {
  const Pass p = *pass(0.0);
  const Answer a = answer(p);
  RC_PRE(a.swept);
  RC_ASSERT(*a.exit >= twin(p, 32).t - 1e-9);
  RC_ASSERT(deepest(p, *a.exit) > -1e-9);       // a touch
  RC_ASSERT(deepest(p, *a.exit + 1e-6) < 0.0);  // and beyond it nothing
}

std::optional<double> best_corner(const mesh::ConvexSolid& s, const RelativePath& p) {
  std::vector<reference::HalfSpace> planes;
  for (std::size_t i = 0; i < s.planes; ++i) planes.push_back({mesh::normal(s, i), s.b[i]});
  return reference::exit_by_corners(planes, p.q0_P, p.q1_P, p.u0_P, p.u1_P);
}

/// Also where u turns, up to a hundred times as far as in a step: the same number but for rounding,
/// which a sharp angle between two planes on the strip makes larger. For directions that turn by
/// 0.3 rad this is no longer true: the solid may cut the strip in two, and the exit is that of the
/// piece that contains the path.
RC_GTEST_PROP(ExitDistance, is_the_highest_corner_of_the_planes_on_the_strip, ()) {
  const Pass p = *pass(*rc::gen::element(0.0, 0.01, 0.1));
  const Answer a = answer(p);
  RC_PRE(a.swept);
  const auto corner = best_corner(a.solid, p.path);
  RC_ASSERT(corner.has_value());
  RC_ASSERT(std::abs(*a.exit - *corner) < 2e-12);  // 1.0e-12 in 300 000 passes
}

/// The place and the plane of an exit belong to it.
RC_GTEST_PROP(FindExit, is_on_its_plane_at_its_place, ()) {
  const Pass p = *pass(0.01);
  const mesh::ConvexSolid solid = *mesh::convex_solid(p.part);
  PlaneStrip strip;
  const auto x = find_exit(solid, p.path, tolerance::swept * size_of(p.part), strip);
  RC_PRE(x.has_value());
  const Vec3 x_P =
      at(p.path.q0_P, p.path.q1_P, x->tau) + x->t * at(p.path.u0_P, p.path.u1_P, x->tau);
  RC_ASSERT(std::abs(mesh::normal(solid, x->plane).dot(x_P) - solid.b[x->plane]) < 1e-12);
  RC_ASSERT(depth_inside(solid, x_P) > -1e-11);
}

/// After the move nothing is left inside, wherever the part is in its step.
RC_GTEST_PROP(ExitDistance, leaves_no_vertex_inside, ()) {
  const Pass p = *pass(0.0);
  const Answer a = answer(p);
  RC_PRE(a.swept);
  for (const double tau : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Vec3 x = at(p.path.q0_P, p.path.q1_P, tau) + *a.exit * p.path.u0_P;
    RC_ASSERT(depth_inside(a.solid, x) < tolerance::inside * size_of(p.part));
  }
  RelativePath after = p.path;
  after.q0_P += *a.exit * p.path.u0_P;
  after.q1_P += *a.exit * p.path.u0_P;
  RC_ASSERT(!is_swept(a.solid, after, tolerance::inside * size_of(p.part)));
}

/// A bit that turns by 0.1 rad in a step (a hundred times what drilling does): the strip is
/// bilinear. Nothing that the twin finds may be left out.
RC_GTEST_PROP(ExitDistance, follows_a_direction_that_turns, ()) {
  const Pass p = *pass(0.1);
  const Answer a = answer(p);
  RC_PRE(a.swept);
  const double fine = twin(p, 256).t;
  RC_ASSERT(*a.exit > fine - 1e-3 * size_of(p.part));
  RC_ASSERT(deepest(p, *a.exit) > -1e-3);
}

/// The same passes again and again with more sub-poses: the twin's error falls at first order.
/// Passes so shallow that four sub-poses may miss them are left out.
TEST(ExitDistance, is_the_limit_of_the_twin) {
  Random random{20};
  const auto any = [&](double half) {
    return Vec3(random.uniform(-half, half), random.uniform(-half, half),
                random.uniform(-half, half));
  };
  std::vector<Pass> passes;
  while (passes.size() < 200) {
    std::vector<Vec3> points;
    for (int k = 0; k < 12; ++k) points.push_back(any(1.0));
    const Vec3 q0 = any(1.0), u = any(1.0).normalized();
    Pass p{reference::convex_hull(points), {q0, q0 + any(0.7), u, u}};
    if (deepest(p, 0.0) > resolution(p, 4)) passes.push_back(std::move(p));
  }
  double before = 0.0;
  for (const int substeps : {4, 16, 64, 256}) {
    double mean = 0.0, worst = 0.0;
    for (const Pass& p : passes) {
      const double error = *answer(p).exit - twin(p, substeps).t;
      EXPECT_GT(error, -1e-9);
      mean += error / static_cast<double>(passes.size());
      worst = std::max(worst, error);
    }
    std::printf("  %4d sub-poses: mean %.1e, worst %.1e of the part's size\n", substeps, mean,
                worst);
    if (before > 0.0) {
      EXPECT_LT(mean, 0.35 * before);
    }
    before = mean;
  }
}

/// A plate of a thousandth, crossed in one step: no tunnelling.
TEST(IsSwept, finds_a_thin_part_between_two_far_poses) {
  const Pass p{battery::box({-1, -1, -5e-4}, {1, 1, 5e-4}),
               {Vec3(0.2, 0.1, 3), Vec3(-0.3, 0.2, -4), Vec3::UnitX(), Vec3::UnitX()}};
  const Answer a = answer(p);
  EXPECT_TRUE(a.swept);
  EXPECT_NEAR(*a.exit, 1.0 - (0.2 - 0.5 * (3.0 + 5e-4) / 7.0), 1e-12);
}

/// The direction lies in the plane of the box's upper face but for rounding, and the last ray to
/// leave the solid is the one that grazes that face: it must not count as the end of the ray.
TEST(ExitDistance, is_not_cut_short_by_a_face_that_the_ray_grazes) {
  for (const double rounding : {-1e-16, 0.0, 1e-16, 1e-15}) {
    const Vec3 u(0, 1, rounding);
    const Pass p{battery::box({-1, -1, -1}, {1, 1, 1}), {Vec3(0, 0, 1.5), Vec3(0, 0.5, 0.5), u, u}};
    EXPECT_NEAR(*answer(p).exit, 0.75, 1e-14) << rounding;
  }
}

/// A roof of three planes above x = 0 to 2, through which a vertex goes straight along x: up with slope 2 to (0.5, 1),
/// up with slope 1 / sqrt(3) to the top, and down. The second grows by exactly 1 on the way, which is not 0.
TEST(ExitDistance, continues_to_the_top_where_the_exit_still_grows) {
  mesh::ConvexSolid solid;
  const Vec3 flat(-0.5, 0.0, std::sqrt(0.75)), steep = Vec3(-2, 0, 1).normalized(),
                                               down = Vec3(2, 0, 1).normalized();
  const Vec3 knee(0.5, 0, 1), top = knee + 1.2 * Vec3(flat.z(), 0, -flat.x());
  mesh::add_plane(solid, steep, steep.dot(knee));
  mesh::add_plane(solid, flat, flat.dot(knee));
  mesh::add_plane(solid, down, down.dot(top));
  mesh::add_plane(solid, -Vec3::UnitZ(), 1.0);
  mesh::add_plane(solid, Vec3::UnitY(), 1.0);
  mesh::add_plane(solid, -Vec3::UnitY(), 1.0);
  mesh::pad(solid);
  const Vec3 u = Vec3::UnitZ(), q0(0.1, 0, 0), q1 = q0 + 2.0 * Vec3::UnitX();
  PlaneStrip strip;
  EXPECT_NEAR(*exit_distance(solid, {q0, q1, u, u}, 0.0, strip), top.z(), 1e-14);
  EXPECT_NEAR(*exit_distance(solid, {q1, q0, u, u}, 0.0, strip), top.z(), 1e-14);
}

/// More planes than a strip has room for: prepared parts of that many have a tree instead.
TEST(ExitDistance, rejects_a_solid_of_too_many_planes) {
  mesh::ConvexSolid solid;
  for (std::size_t i = 0; i <= mesh::most_planes; ++i) mesh::add_plane(solid, Vec3::UnitX(), 1.0);
  mesh::pad(solid);
  PlaneStrip strip;
  const Vec3 u = Vec3::UnitX();
  EXPECT_THROW(exit_distance(solid, {u, u, u, u}, 0.0, strip), std::invalid_argument);
}

TEST(IsSwept, leaves_alone_what_slides_along_a_face) {
  const Pass p{battery::box({-1, -1, -1}, {1, 1, 1}),
               {Vec3(-0.5, 0, 1), Vec3(0.5, 0, 1), Vec3::UnitZ(), Vec3::UnitZ()}};
  EXPECT_FALSE(answer(p).swept);
}

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

}  // namespace tdbd::rock::swept_convex_test
