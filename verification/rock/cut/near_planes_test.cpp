#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/tolerance.hpp"
#include "rock/cut/plane_sectors.hpp"
#include "rock/cut/plane_strip.hpp"
#include "rock/cut/swept_mesh.hpp"
#include "rock/cut/swept_part.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/rock/cut/round_solids.hpp"

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

/// Bitwise identical with the planes kept from other paths and other parts: a restart, which keeps
/// nothing, does not change the results.
RC_GTEST_PROP(NearPlanes, give_bitwise_the_exits_of_the_whole_part, ()) {
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
RC_GTEST_PROP(NearPlanes, find_the_plane_through_which_a_path_leaves, ()) {
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

/// Paths within the boxes of earlier ones reuse their planes.
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

bool is_in_wedge(const PlaneSector& s, const Vec3& x) {
  return s.sides[0] * x.y() + s.sides[1] * x.z() >= 0.0 &&
         s.sides[2] * x.y() + s.sides[3] * x.z() >= 0.0;
}

/// How far x is outside plane i, m.
double outside(const mesh::ConvexSolid& s, std::size_t i, const Vec3& x) {
  return mesh::normal(s, i).dot(x) - s.b[i];
}

/// The rows of the sector that have x outside by more than the slack of plane_sectors.hpp.
std::vector<std::size_t> rows_outside(const RoundSolid& s, const PlaneSector& sector,
                                      const Vec3& x) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < sector.plane.size(); ++i)
    if (outside(s.solid_P, sector.plane[i], x) > 1e-7 * s.size) rows.push_back(i);
  return rows;
}

/// A point near the surface, or anywhere within twice the size of the axis's origin.
Vec3 any_point(const RoundSolid& s) {
  Vec3 x = 2.0 * s.size / std::sqrt(3.0) * *battery::point(1.0);
  if (*rc::gen::element(0, 1, 1) == 0) return x;
  const Vec3 from(x.x() / 4.0, 0.0, 0.0);
  double way = 1.0;
  for (std::size_t i = 0; i < s.solid_P.planes; ++i) {
    const double speed = mesh::normal(s.solid_P, i).dot(x - from);
    if (speed > 0.0) way = std::min(way, -outside(s.solid_P, i, from) / speed);
  }
  return from + (way + *battery::number(-1e-2, 1e-2)) * (x - from);
}

/// A prism of 40 sides about an axis at a distance z from x.
mesh::ConvexSolid prism(double z, int sides = 40) {
  mesh::ConvexSolid s;
  for (const double x : {-1.0, 1.0}) mesh::add_plane(s, x * Vec3::UnitX(), 0.1);
  for (int k = 0; k < sides; ++k) {
    const double a = 2.0 * std::numbers::pi * k / sides;
    const Vec3 n(0.0, std::cos(a), std::sin(a));
    mesh::add_plane(s, n, 0.4 + z * n.z());
  }
  mesh::pad(s);
  return s;
}

/// The claim of plane_sectors.hpp.
RC_GTEST_PROP(PlaneSectors, have_every_plane_that_their_wedge_needs, ()) {
  const RoundSolid s = any_round_solid();
  const PlaneSectors all = plane_sectors(s.solid_P, s.size);
  RC_TAG(all.sectors.empty() ? "none" : "some");
  if (all.sectors.empty()) return;
  for (int k = 0; k < 100; ++k) {
    const Vec3 x = any_point(s);
    for (const PlaneSector& sector : all.sectors) {
      const std::vector<std::size_t> rows = rows_outside(s, sector, x);
      const bool is_claimed =
          rows.empty() || (rows.size() == 1 && (sector.ends >> rows.front() & 1U) != 0 &&
                           outside(s.solid_P, sector.plane[rows.front()], x) <= all.beyond);
      if (!is_in_wedge(sector, x) || !is_claimed) continue;
      for (std::size_t i = 0; i < s.solid_P.planes; ++i)
        RC_ASSERT(std::ranges::count(sector.plane, i) == 1 ||
                  outside(s.solid_P, i, x) < -1e-7 * s.size);
    }
  }
}

/// Of the core, on its border as well.
RC_GTEST_PROP(PlaneSectors, have_every_plane_that_bounds_their_core, ()) {
  const RoundSolid s = any_round_solid();
  const PlaneSectors all = plane_sectors(s.solid_P, s.size);
  if (all.sectors.empty() || all.core_radius < 0.0) return;
  for (int k = 0; k < 200; ++k) {
    const double angle = *battery::number(0.0, 6.283),
                 radius = all.core_radius * *rc::gen::element(0.5, 1.0),
                 share = *rc::gen::element(0.0, 0.3, 1.0);
    const Vec3 x(all.core_lo + share * (all.core_hi - all.core_lo), radius * std::cos(angle),
                 radius * std::sin(angle));
    for (const PlaneSector& sector : all.sectors)
      for (std::size_t i = 0; i < s.solid_P.planes; ++i)
        RC_ASSERT(std::ranges::count(sector.plane, i) == 1 ||
                  outside(s.solid_P, i, x) < -1e-7 * s.size);
  }
}

TEST(PlaneSectors, have_a_core_as_wide_as_the_solid) {
  const PlaneSectors all = plane_sectors(prism(0.0), 1.2);
  EXPECT_NEAR(all.core_radius, 0.4, 2e-6);
  EXPECT_NEAR(all.core_lo, -0.1, 2e-6);
  EXPECT_NEAR(all.core_hi, 0.1, 2e-6);
}

RC_GTEST_PROP(PlaneSectors, keep_the_planes_and_their_order, ()) {
  const RoundSolid s = any_round_solid();
  const PlaneSectors all = plane_sectors(s.solid_P, s.size);
  for (const PlaneSector& sector : all.sectors) {
    RC_ASSERT(std::ranges::is_sorted(sector.plane));
    RC_ASSERT(sector.rows.size() == 4 * all.rows);
    for (std::size_t i = 0; i < all.rows; ++i) {
      const Vec3 n(sector.rows[4 * i], sector.rows[4 * i + 1], sector.rows[4 * i + 2]);
      const bool is_padding = i >= sector.plane.size();
      RC_ASSERT(n == (is_padding ? Vec3(Vec3::Zero()) : mesh::normal(s.solid_P, sector.plane[i])));
      RC_ASSERT(sector.rows[4 * i + 3] == (is_padding ? HUGE_VAL : s.solid_P.b[sector.plane[i]]));
    }
  }
}

RC_GTEST_PROP(PlaneSectors, are_found_by_direction, ()) {
  const PlaneSectors all = plane_sectors(any_round_solid().solid_P, 1.0);
  if (all.sectors.empty()) return;
  const Vec3 x = *battery::point(1.0);
  RC_ASSERT(is_in_wedge(all.towards(x.y(), x.z()), x));
  RC_ASSERT(is_in_wedge(all.towards(0.0, x.z()), Vec3(0.0, 0.0, x.z())));
  RC_ASSERT(is_in_wedge(all.towards(-0.0, x.z()), Vec3(0.0, 0.0, x.z())));
  RC_ASSERT(is_in_wedge(all.towards(x.y(), 0.0), Vec3(0.0, x.y(), 0.0)));
}

TEST(PlaneSectors, have_a_fraction_of_the_planes) {
  const PlaneSectors all = plane_sectors(prism(0.0), 1.2);
  EXPECT_EQ(all.sectors.size(), 64U);
  EXPECT_LE(all.rows, 8U);
  EXPECT_EQ(all.sectors.front().ends, 3U);
}

TEST(PlaneSectors, are_none_where_the_axis_is_outside_or_planes_are_few) {
  EXPECT_FALSE(plane_sectors(prism(0.35), 1.2).sectors.empty());
  EXPECT_TRUE(plane_sectors(prism(0.4), 1.2).sectors.empty());
  EXPECT_TRUE(plane_sectors(prism(0.5), 1.2).sectors.empty());
  EXPECT_TRUE(plane_sectors(prism(0.0, 12), 1.2).sectors.empty());
}

}  // namespace tdbd::rock::near_planes_test

namespace tdbd::rock::strip_test {

const mesh::Box part{Vec3::Constant(-2.0), Vec3::Constant(2.0)};

/// A way of up to `way` along each axis, and a direction that turns by about `turn` on it.
RelativePath any_path(double way, double turn) {
  RelativePath p;
  p.q0_P = *battery::point(0.5);
  p.q1_P = p.q0_P + way * *battery::point(1.0);
  p.u0_P = *battery::direction();
  p.u1_P = (p.u0_P + turn * *battery::point(1.0)).normalized();
  return p;
}

mesh::Box box_at(const Vec3& x, double half) {
  return {x - Vec3::Constant(half), x + Vec3::Constant(half)};
}

/// However small the box and however far the direction turns.
RC_GTEST_PROP(Strip, meets_every_box_that_a_point_of_it_is_in, ()) {
  const RelativePath path =
      any_path(*rc::gen::element(0.0, 0.1, 0.5), *rc::gen::element(0.0, 0.1, 0.4));
  const Strip strip(path, part);
  const double t = *battery::number(0.0, 1.0), half = *rc::gen::element(0.0, 1e-6, 0.1);
  const Vec3 x = strip.at(*battery::number(0.0, 1.0), t);
  RC_ASSERT(strip.meets(box_at(x, half)));
  RC_ASSERT(strip.up_to(t).meets(box_at(x, half)));
  RC_ASSERT(strip.up_to(t).meets({x, x + Vec3(half, 2.0 * half, half)}));
}

/// Without a way and a turn it is a line: it passes what is beside it, before it and beyond its end.
RC_GTEST_PROP(Strip, of_no_width_meets_no_box_beside_it, ()) {
  const Strip strip(any_path(0.0, 0.0), part);
  const Vec3 u = strip.at(0.0, 1.0) - strip.at(0.0, 0.0);
  const Vec3 beside =
      u.cross(Vec3::Unit(*battery::integer(0, 2)) + 0.1 * Vec3::Ones()).normalized();
  const double t = *battery::number(0.0, 1.0), half = *battery::number(0.001, 0.1);
  const double apart = 1.001 * std::sqrt(3.0) * half;  // half of its diagonal
  RC_ASSERT(!strip.meets(box_at(strip.at(0.0, t) + apart * beside, half)));
  RC_ASSERT(!strip.meets(box_at(strip.at(0.0, -apart), half)));
  RC_ASSERT(!strip.up_to(t).meets(box_at(strip.at(0.0, t + apart), half)));
  RC_ASSERT(strip.meets(box_at(strip.at(0.0, t + apart), half)));
}

/// It reaches beyond the part's box: what is there, it has passed.
RC_GTEST_PROP(Strip, ends_beyond_the_part, ()) {
  const Strip strip(any_path(0.5, 0.3), part);
  for (const double tau : {0.0, 0.5, 1.0}) {
    double t = 0.0;
    while (part.contains(strip.at(tau, t))) t += 0.01;
    RC_ASSERT(strip.meets(box_at(strip.at(tau, t - 0.01), 0.0)));
  }
}

/// A ray at any tau that hits the facet does so within an interval; and the level in the middle of each interval meets
/// the facet.
RC_GTEST_PROP(Strip, has_the_levels_that_meet_a_facet, ()) {
  const RelativePath path = any_path(*rc::gen::element(0.1, 0.5), *rc::gen::element(0.0, 0.1, 0.4));
  const Strip strip(path, part);
  const Vec3 near = strip.at(0.5, 0.8);
  const mesh::Facet f{near + *battery::point(0.5), near + *battery::point(0.5),
                      near + *battery::point(0.5)};
  RC_PRE((f.b - f.a).cross(f.c - f.a).norm() > 0.01);
  std::vector<double> ends;
  std::vector<Levels> intervals;
  strip.levels_that_meet(f, 1e-12, ends, intervals);
  RC_TAG(intervals.empty() ? "missed" : "met");
  for (int k = 0; k <= 50; ++k) {
    const double tau = k / 50.0;
    const Vec3 x = strip.at(tau, 0.0), u = strip.at(tau, 1.0) - x;
    const auto hit = mesh::meet(f, x, u);
    if (!hit || hit->margin < 0.0) continue;
    RC_ASSERT(std::ranges::any_of(intervals, [&](const Levels& i) {
      return hit->s >= i.lo - 1e-9 && hit->s <= i.hi + 1e-9;
    }));
  }
  for (const Levels& i : intervals) {
    if (i.hi - i.lo < 1e-6) continue;
    const double t = 0.5 * (i.lo + i.hi);
    const Vec3 from = strip.at(0.0, t), to = strip.at(1.0, t);
    const auto hit = mesh::meet(f, from, to - from);
    RC_ASSERT(hit.has_value());
    RC_ASSERT(hit->margin > -1e-9);
    RC_ASSERT(hit->s > -1e-9);
    RC_ASSERT(hit->s < 1.0 + 1e-9);
  }
}

}  // namespace tdbd::rock::strip_test
