#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "mesh/search/triangle_tree.hpp"
#include "reference/mesh/convex_hull.hpp"
#include "rock/section/contact_end.hpp"
#include "rock/section/pressing_part.hpp"
#include "rock/section/underside.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

/// The loops over planes against their definitions, one plane at a time.
namespace tdbd::rock::shadow_test {

constexpr double rounding = 1e-12;  // m, of parts of 1 m
constexpr double infinite = std::numeric_limits<double>::infinity();

Vec3 any_point(Random& random, double size) {
  return size *
         Vec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
}

struct Hull {
  mesh::ConvexSolid solid;
  Vec3 middle;  ///< mean of its corners, inside
};

Hull any_hull(Random& random) {
  std::vector<Vec3> corners;
  const int count = 4 + static_cast<int>(random.uniform(0.0, 40.0));
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    corners.push_back(any_point(random, 1.0).normalized());
    sum += corners.back();
  }
  const auto solid = mesh::convex_solid(reference::convex_hull(corners));
  RC_PRE(solid.has_value());
  return {*solid, sum / count};
}

double out_of(const mesh::ConvexSolid& s, std::size_t i, const Vec3& x) {
  return mesh::normal(s, i).dot(x) - s.b[i];
}

double farthest_out(const mesh::ConvexSolid& s, const Vec3& x) {
  double out = -infinite;
  for (std::size_t i = 0; i < s.planes; ++i) out = std::max(out, out_of(s, i, x));
  return out;
}

struct Way {
  mesh::ConvexSolid solid;
  Vec3 U, e, u;

  Vec3 point(double t, double s) const { return U + t * e + s * u; }
};

/// It begins inside.
Way any_way(Random& random) {
  const Hull hull = any_hull(random);
  const Vec3 off_middle = any_point(random, 1.0);
  double share = 1.0;
  while (share > 1e-3 && farthest_out(hull.solid, hull.middle + share * off_middle) > 0.0)
    share *= 0.5;
  RC_PRE(share > 1e-3);
  return {hull.solid, hull.middle + share * off_middle, any_point(random, 1.5),
          any_point(random, 1.0).normalized()};
}

RC_GTEST_PROP(Shadow, of_a_way_leaves_through_the_first_plane, ()) {
  Random random = battery::any_random();
  const Way w = any_way(random);
  double t = 1.0;
  for (std::size_t i = 0; i < w.solid.planes; ++i)
    if (const double across = mesh::normal(w.solid, i).dot(w.e); across > 0.0)
      t = std::min(t, -out_of(w.solid, i, w.U) / across);
  const Exit exit = exit_of_line(w.solid, w.U, w.e, w.U);
  RC_ASSERT(std::abs(exit.t - t) < rounding);
  if (t < 1.0) RC_ASSERT(std::abs(out_of(w.solid, exit.plane, w.point(exit.t, 0.0))) < rounding);
}

/// s at which the line at t leaves the solid, of planes above; and where it enters, at least 0.
struct Line {
  double enters = 0.0, leaves = infinite;
};

Line line_at(const Way& w, double t) {
  Line line;
  for (std::size_t i = 0; i < w.solid.planes; ++i) {
    const double c = mesh::normal(w.solid, i).dot(w.u);
    const double s = -out_of(w.solid, i, w.point(t, 0.0)) / c;
    if (c > 0.0) line.leaves = std::min(line.leaves, s);
    if (c < 0.0) line.enters = std::max(line.enters, s);
  }
  return line;
}

/// Beyond it no point of the shadow is inside, before it some are.
RC_GTEST_PROP(Shadow, ends_at_the_last_line_that_meets_the_solid, ()) {
  Random random = battery::any_random();
  const Way w = any_way(random);
  const Shadow shadow(w.solid, w.U, w.e, w.u, w.U);
  const Vec3 end = end_of_shadow(shadow);
  RC_ASSERT(farthest_out(w.solid, end) < rounding);
  double t = 0.0, beyond = 1.0;
  const auto meets = [&](double at) {
    const Line line = line_at(w, at);
    return line.enters <= line.leaves;
  };
  for (int i = 0; i < 60 && !meets(1.0); ++i) {
    const double middle = 0.5 * (t + beyond);
    (meets(middle) ? t : beyond) = middle;
  }
  const double last = meets(1.0) ? 1.0 : t;
  const Vec3 across = w.e - w.e.dot(w.u) * w.u;  // t of a point, whatever its s
  RC_ASSERT(std::abs((end - w.U).dot(across) / across.squaredNorm() - last) < 1e-9);
}

RC_GTEST_PROP(Shadow, has_on_each_stretch_the_first_plane_below, ()) {
  Random random = battery::any_random();
  const Way w = any_way(random);
  const Shadow shadow(w.solid, w.U, w.e, w.u, w.U);
  Stretch s = first_stretch(shadow);
  RC_ASSERT(s.from == 0.0);
  for (std::size_t i = 0; i <= w.solid.planes; ++i) {
    RC_ASSERT(s.to >= s.from);
    const double t = s.from + random.uniform(0.0, 1.0) * (s.to - s.from);
    RC_ASSERT(std::abs(shadow.height(s.plane, t) - line_at(w, t).leaves) < 1e-9);
    if (s.next == mesh::most_planes) break;
    s = stretch_from(shadow, s.next, s.to);
  }
  RC_ASSERT(s.next == mesh::most_planes);
  const Line line = line_at(w, s.to);  // at the end of the way, or where the surface above meets it
  RC_ASSERT(s.to >= 1.0 - rounding || std::abs(line.leaves - line.enters) < 1e-9 ||
            line.leaves < 1e-9);
}

/// Without a direction the plane of a stretch is the nearest.
RC_GTEST_PROP(Shadow, without_a_direction_has_the_nearest_planes, ()) {
  Random random = battery::any_random();
  const Way w = any_way(random);
  const Shadow shadow(w.solid, w.U, w.e, w.U);
  Stretch s = first_stretch(shadow);
  for (std::size_t i = 0; i <= w.solid.planes; ++i) {
    const double t = s.from + random.uniform(0.0, 1.0) * (s.to - s.from);
    const Vec3 x = w.point(t, 0.0);
    RC_ASSERT(std::abs(out_of(w.solid, s.plane, x) - farthest_out(w.solid, x)) < rounding);
    if (s.next == mesh::most_planes) break;
    s = stretch_from(shadow, s.next, s.to);
  }
  RC_ASSERT(s.to == 1.0);
}

struct Pressing {
  std::vector<CuttingPart> solids;
  PressingPart part;
};

/// One convex solid that turns and moves a little.
Pressing any_part(Random& random) {
  Pressing p;
  CuttingPart& solid = p.solids.emplace_back();
  solid.solid_P = any_hull(random).solid;
  p.part = {p.solids, {Mat3::Identity(), any_point(random, 1e-3)}, 1e-2, 0.0};
  return p;
}

/// Planes that are equally near have no part in this: random points have one nearest plane.
RC_GTEST_PROP(PressingPart, touches_at_its_nearest_plane, ()) {
  Random random = battery::any_random();
  const Pressing p = any_part(random);
  const mesh::ConvexSolid& s = p.solids[0].solid_P;
  const auto i = std::min(
      static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(s.planes))), s.planes - 1);
  Vec3 x = any_point(random, 1.0);
  x -= (out_of(s, i, x) - 0.5 * p.part.gap) * mesh::normal(s, i);  // over a plane, often a far one
  const double out = farthest_out(s, x);
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < s.planes; ++k)
    if (out_of(s, k, x) == out) nearest = k;
  const Vec3 n = mesh::normal(s, nearest);
  const Vec3 v = x - p.part.X_P1P0 * x;
  RC_PRE(std::abs(n.dot(v)) > 2e-4 * v.norm());
  const Touch found = touch(p.part, x);
  RC_ASSERT(found.is_lee == (n.dot(v) < 0.0));
  RC_ASSERT(found.is_lee == is_on_lee_side(p.part, x));
  RC_ASSERT(nearest_normal(p.part, x) == n);
  RC_ASSERT(is_inside(p.part, x) == (out <= 0.0));
  const Vec3 expected = std::abs(out) <= p.part.gap ? Vec3(x - out * n) : x;
  RC_ASSERT((found.x_P - expected).norm() < rounding);
  RC_ASSERT(std::abs(found.rise - (std::abs(out) <= p.part.gap ? std::max(out, 0.0) : 0.0)) <
            rounding);
}

/// Bit for bit, where several planes are equally near, or nearly: the first of them is touched, and all of
/// them decide whether the point is on the lee side.
RC_GTEST_PROP(PressingPart, touches_the_first_of_equally_near_planes, ()) {
  Random random = battery::any_random();
  Pressing p = any_part(random);
  mesh::ConvexSolid& s = p.solids[0].solid_P;
  const Vec3 x = any_point(random, 1.0);
  const double near = 1e-6 * p.part.gap;
  const auto along = [&](std::size_t i) {
    return s.nx[i] * x.x() + s.ny[i] * x.y() + s.nz[i] * x.z();
  };
  const std::vector<double> beyond{0.0, 0.5 * near, 2.0 * near, 0.1};
  for (std::size_t i = 0; i < s.planes; ++i)
    s.b[i] =
        along(i) + beyond[std::min<std::size_t>(3, at(static_cast<int>(random.uniform(0, 4))))];
  std::size_t first = 0;
  for (std::size_t i = 1; i < s.planes; ++i)
    if (along(i) - s.b[i] > along(first) - s.b[first]) first = i;
  const double most = along(first) - s.b[first];
  const Vec3 v = displacement_P(p.part, x);
  bool moved_away = true;
  for (std::size_t i = 0; i < s.planes; ++i)
    if (along(i) - s.b[i] >= most - near)
      moved_away = moved_away && !presses_or_slides(p.part, v, mesh::normal(s, i));
  const Touch found = touch(p.part, x);
  RC_ASSERT(found.is_lee == moved_away);
  RC_ASSERT(found.rise == (std::abs(most) <= p.part.gap ? std::max(most, 0.0) : 0.0));
  if (std::abs(most) <= p.part.gap) RC_ASSERT(found.x_P == Vec3(x - most * mesh::normal(s, first)));
}

}  // namespace tdbd::rock::shadow_test

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
    RC_ASSERT(may_contain(u, x));
    RC_ASSERT(may_contain(u, Around::vertex, x, 0.0));
    RC_ASSERT(
        may_contain(u, static_cast<Single>(x.head<2>().squaredNorm()), static_cast<Single>(x.z())));
    const Vec3 within(*battery::number(-0.5, 0.5), *battery::number(-0.5, 0.5),
                      *battery::number(-0.5, 0.5));
    RC_ASSERT(may_contain(u, Around::cell, x + cell * within, 0.5 * cell));
    RC_ASSERT(may_contain(u, Around::tile, x + 4.0 * cell * within, 2.0 * cell));
  }
}

/// Where a vertex is excluded, so is all that the part, turned about its axis by any angle and moved by
/// less than the margin, can hold.
RC_GTEST_PROP(Underside, excludes_what_the_part_could_reach_within_its_room, ()) {
  const mesh::TriangleMesh m = any_part();
  const Underside u = underside_of(m, *battery::number(0.05, 0.2));
  const mesh::TriangleTree tree(m);
  const Mat3 turn = Eigen::AngleAxisd(*battery::number(0.0, 6.3), Vec3::UnitZ()).toRotationMatrix();
  const Vec3 away = *battery::direction();
  for (int k = 0; k < 200; ++k) {
    const Vec3 x(*battery::number(-1.5, 1.5), *battery::number(-1.5, 1.5),
                 *battery::number(-1.5, 1.5));
    if (!may_contain(u, Around::vertex, x, 0.0))
      RC_ASSERT(!mesh::inside(tree, turn * (x + u.margin * away)));
  }
}

/// Below a block and beside it, by more than columns and margin take.
TEST(Underside, excludes_what_is_below_or_beside) {
  const Underside u = underside_of(battery::box(Vec3(-0.5, -0.5, -1.0), Vec3(0.5, 0.5, 0.0)), 0.02);
  EXPECT_FALSE(may_contain(u, Vec3(0.1, 0.2, 0.001)));
  EXPECT_FALSE(may_contain(u, Vec3(0.52, 0.0, -0.5)));
  EXPECT_TRUE(may_contain(u, Vec3(0.1, 0.2, -0.001)));
  EXPECT_FALSE(may_contain(u, Around::vertex, Vec3(0.1, 0.2, 0.006), 0.0));
  EXPECT_FALSE(may_contain(u, Around::vertex, Vec3(0.75, 0.0, -0.5), 0.0));
  EXPECT_TRUE(may_contain(u, Around::vertex, Vec3(0.1, 0.2, 0.004), 0.0));
}

}  // namespace tdbd::rock::underside_test
