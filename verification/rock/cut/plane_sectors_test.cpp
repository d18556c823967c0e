#include "rock/cut/plane_sectors.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

#include "verification/battery/generators.hpp"
#include "verification/rock/cut/round_solids.hpp"

namespace tdbd::rock::plane_sectors_test {

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

}  // namespace tdbd::rock::plane_sectors_test
