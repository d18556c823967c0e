#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/tolerance.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/cut/group_cut.hpp"
#include "rock/cut/sieves.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/rock/cut/cutting_scene.hpp"

namespace tdbd::rock::round_sieve_test {

using battery::number;

constexpr double radius = 0.3;  // m

/// A disc about the x axis of P, with its middle at x.
mesh::TriangleMesh disc(int sides, double x, double length) {
  const Pose X_across{rotation::exp(Vec3(0, 0.5 * std::numbers::pi, 0)), x * Vec3::UnitX()};
  return battery::placed(X_across, battery::cylinder(radius, length, sides));
}

mesh::TriangleMesh any_disc(double longest = 0.5) {
  return disc(*battery::integer(12, 40), *number(-0.5, 0.5), *number(0.05, longest));
}

bit::Bit bit_of(const mesh::TriangleMesh& m) {
  bit::Bit bit;
  bit.parts.push_back({});
  bit.parts.back().mesh_P = m;
  return bit;
}

/// A round group in a step, and rock around it.
struct Case {
  CuttingBit cutting;
  GroupMotion m;
  std::vector<Vec3> points_W;

  const CuttingGroup& group() const { return cutting.groups[0]; }
};

GroupMotion any_motion(const CuttingGroup& g) {
  const Pose X_WB0{rotation::exp(*number(0.0, 3.0) * *battery::direction()),
                   *number(0.0, 2.0) * *battery::direction()};
  const Pose X_WB1{X_WB0.R * rotation::exp(*number(0.0, 0.4) * *battery::direction()),
                   X_WB0.p + *number(0.0, 0.2) * *battery::direction()};
  return group_motion(g, X_WB0, X_WB1);
}

/// Half of the points are within a few bounds of rounding from the cylinder at one of the poses.
std::vector<Vec3> points_near(const CuttingGroup& g, const GroupMotion& m) {
  std::vector<Vec3> points;
  const mesh::Box& box = m.region_W.box;
  for (int k = 0; k < 40; ++k)
    points.push_back(box.lo + 0.5 * (*battery::point(1.2) + Vec3::Ones()).cwiseProduct(box.size()));
  const double room = single_slack(box);
  for (std::size_t v = 0; v < points.size(); v += 2) {
    const bool at_end = v % 4 == 0;
    Vec3 x_P = (at_end ? m.X_PW1 : m.X_PW0) * points[v];
    x_P.tail<2>() *= (g.radius + *number(-4.0, 8.0) * room) / x_P.tail<2>().norm();
    points[v] = (at_end ? m.X_WP1 : m.X_WP0) * x_P;
  }
  return points;
}

Case any_case() {
  Case c{prepare_cutting_bit(bit_of(any_disc(3.0))), {}, {}};
  c.m = any_motion(c.group());
  c.points_W = points_near(c.group(), c.m);
  return c;
}

struct Found {
  std::vector<int> swept, touched;
};

Found found(const Case& c, double gap, const NearListMargins& margins = {}) {
  const Region region = widened(c.m.region_W, std::max(0.0, gap));
  VertexGrid grid(region.box, 0.3);
  mesh::Surface surface;
  for (const Vec3& x_W : c.points_W) {
    grid.insert(static_cast<int>(surface.stars.size()), x_W);
    surface.stars.emplace_back().x = x_W;
  }
  NearList list;
  NearGroup near;
  update_near_list(grid, {c.group().box_P, c.m.X_WP0, c.m.X_WP1, region}, margins, list);
  find_candidates(c.group(), c.m, surface, list, gap, near);
  Found f{{}, near.touching};
  for (const int place : near.places) f.swept.push_back(list.v[at(place)]);
  std::ranges::sort(f.swept);
  std::ranges::sort(f.touched);
  return f;
}

std::vector<int> not_outside(const Case& c) {
  std::vector<int> expected;
  for (std::size_t v = 0; v < c.points_W.size(); ++v)
    if (!keeps_outside(c.group(), c.m, c.points_W[v])) expected.push_back(static_cast<int>(v));
  return expected;
}

TEST(RoundSieve, takes_discs_and_leaves_boxes_to_their_planes) {
  const CuttingBit box =
      prepare_cutting_bit(bit_of(battery::box({-0.1, -0.2, -0.3}, {0.1, 0.2, 0.3})));
  EXPECT_EQ(box.groups[0].radius, 0.0);
  const CuttingBit round = prepare_cutting_bit(bit_of(disc(32, 0.1, 0.2)));
  EXPECT_GE(round.groups[0].radius, radius);
  EXPECT_LT(round.groups[0].radius, radius + 2.0 * tolerance::convex);
}

/// The first pass and the later ones agree, whatever single precision makes of a place.
RC_GTEST_PROP(RoundSieve, finds_what_does_not_keep_outside, ()) {
  const Case c = any_case();
  const std::vector<int> expected = not_outside(c);
  RC_CLASSIFY(!expected.empty());
  RC_ASSERT(found(c, -1.0).swept == expected);
}

/// Lists made elsewhere have another origin and other bounds of rounding.
RC_GTEST_PROP(RoundSieve, finds_the_same_from_any_list, ()) {
  const Case c = any_case();
  const NearListMargins margins{*number(0.0, 2.0), *number(0.0, 3.0)};
  RC_ASSERT(found(c, -1.0, margins).swept == not_outside(c));
}

RC_GTEST_PROP(RoundSieve, finds_all_that_is_touched_and_nothing_if_the_gap_is_negative, ()) {
  const Case c = any_case();
  const double gap = *number(0.0, 0.2);
  const std::vector<int> touched = found(c, gap).touched;
  for (std::size_t v = 0; v < c.points_W.size(); ++v)
    if (!is_far_from(c.group(), c.m.X_PW1 * c.points_W[v], gap))
      RC_ASSERT(std::ranges::binary_search(touched, static_cast<int>(v)));
  RC_ASSERT(found(c, -1e-3).touched.empty());
}

/// The twin looks at many places of the way.
RC_GTEST_PROP(RoundSieve, misses_a_cylinder_that_no_place_of_the_way_is_in, ()) {
  const Case c = any_case();
  const CuttingGroup& g = c.group();
  constexpr int places = 200;
  constexpr double rounding = 1e-15;  // m, of a place
  for (const Vec3& x_W : c.points_W) {
    const Vec3 q0 = c.m.X_PW0 * x_W, q1 = c.m.X_PW1 * x_W;
    const double between = 0.5 * (q1 - q0).norm() / places;  // m, no place is farther from the next
    double least = 1e300;
    for (int k = 0; k <= places; ++k)
      least = std::min(least, (q0 + k * (q1 - q0) / places).tail<2>().norm());
    const bool passes_an_end =
        std::min(q0.x(), q1.x()) > g.box_P.hi.x() || std::max(q0.x(), q1.x()) < g.box_P.lo.x();
    const bool misses = misses_cylinder(g, q0, q1, 0.0);
    if (passes_an_end || least > g.radius + between + rounding) RC_ASSERT(misses);
    if (!passes_an_end && least <= g.radius - rounding) RC_ASSERT(!misses);
  }
}

/// The parts are one group: between groups, the pass in which one looks at a vertex that another
/// has moved may differ, and with it who moves the vertex on.
Scene scene_of_discs() {
  Scene s = *scene();
  const bit::Part& first = s.bit.parts.front();
  for (bit::Part& p : s.bit.parts) {
    p.group = 0;
    p.X_BP = first.X_BP;
    p.update_direction_B = first.update_direction_B;
    if (*battery::integer(0, 5) > 0) p.mesh_P = any_disc();
  }
  return s;
}

struct Cut {
  Rock rock;
  CutReport report;
};

enum class Around { cylinder, planes };

Cut cut(const Scene& s, Around around) {
  CuttingBit bit = prepare_cutting_bit(s.bit);
  if (around == Around::planes)
    for (CuttingGroup& g : bit.groups) g.radius = 0.0;
  Cut c{rock_of(s), {}};
  CutWorkspace work;
  cut_rock(c.rock, bit, s.X_WB0, s.X_WB1, work, c.report);
  return c;
}

bool same_places(const Rock& a, const Rock& b) {
  return std::ranges::equal(
      a.surface.stars, b.surface.stars,
      [](const mesh::VertexStar& s, const mesh::VertexStar& t) { return s.x == t.x; });
}

/// What is not swept does not move: the planes around a group and its cylinder give
/// bitwise identical steps.
RC_GTEST_PROP(RoundSieve, moves_the_same_as_the_planes_do, ()) {
  const Scene s = scene_of_discs();
  const Cut c = cut(s, Around::cylinder), twin = cut(s, Around::planes);
  RC_TAG(c.report.moved > 0 ? "cuts" : "misses");
  RC_ASSERT(same_places(c.rock, twin.rock));
  RC_ASSERT(c.report.removed_by_part == twin.report.removed_by_part);
}

}  // namespace tdbd::rock::round_sieve_test

namespace tdbd::rock::hull_filter_test {

/// What touches a side is left to the exact tests, and what is beyond it is not.
TEST(HullFilter, keeps_outside_what_is_beyond_a_side_of_a_box_and_not_what_is_on_it) {
  const Vec3 lo(-0.25, -0.5, -0.125), hi(0.5, 0.25, 0.375);
  bit::Bit bit;
  bit.parts.push_back({});
  bit.parts.back().mesh_P = battery::box(lo, hi);
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const CuttingGroup& g = cutting.groups[0];
  ASSERT_EQ(g.radius, 0.0);
  const GroupMotion at_rest = group_motion(g, Pose{}, Pose{});
  for (int k = 0; k < 3; ++k)
    for (const bool upper : {false, true}) {
      Vec3 x = 0.5 * (lo + hi);
      x[k] = upper ? hi[k] : lo[k];
      EXPECT_FALSE(keeps_outside(g, at_rest, x)) << k << upper;
      x[k] += upper ? 1e-3 : -1e-3;
      EXPECT_TRUE(keeps_outside(g, at_rest, x)) << k << upper;
    }
}

/// A prism of 8 sides about x: the cylinder through its corners stands out over its facets.
TEST(HullFilter, keeps_outside_what_is_beyond_the_cylinder_of_a_round_part) {
  constexpr double radius = 0.2;
  const Pose to_x{.R = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()).toRotationMatrix(),
                  .p = Vec3::Zero()};
  bit::Bit bit;
  bit.parts.push_back({});
  bit.parts.back().mesh_P = battery::placed(to_x, battery::cylinder(radius, 0.1, 8));
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const CuttingGroup& g = cutting.groups[0];
  ASSERT_NEAR(g.radius, radius, 1.1 * tolerance::convex * g.box_P.size().norm());
  const GroupMotion at_rest = group_motion(g, Pose{}, Pose{});
  for (int i = 0; i < 16; ++i) {
    const double a = 2.0 * std::numbers::pi * (i + 0.5) / 16.0;
    const Vec3 out(0.0, std::cos(a), std::sin(a));
    EXPECT_FALSE(keeps_outside(g, at_rest, 0.999 * radius * out)) << i;
    EXPECT_TRUE(keeps_outside(g, at_rest, 1.001 * radius * out)) << i;
    EXPECT_FALSE(is_far_from(g, 1.009 * radius * out, 0.01 * radius)) << i;
    EXPECT_TRUE(is_far_from(g, 1.011 * radius * out, 0.01 * radius)) << i;
  }
}

}  // namespace tdbd::rock::hull_filter_test
