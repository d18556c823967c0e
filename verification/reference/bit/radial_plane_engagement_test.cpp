#include "reference/bit/radial_plane_engagement.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "reference/bit/scalloped_wall.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::radial_plane_engagement_test {

constexpr double pi = std::numbers::pi;
constexpr double spacing = 2e-5;  // m
constexpr double advance = 2e-3;  // m per revolution
constexpr double cutter_radius = 8e-3;

/// A thin disc that faces along its path: its axis along the circle about the bit's axis.
void add_disc(bit::Bit& bit, double radius, double azimuth, double z, int sides = 256) {
  const Mat3 turned = Eigen::AngleAxisd(azimuth, Vec3::UnitZ()).toRotationMatrix();
  const Mat3 z_to_y = Eigen::AngleAxisd(-pi / 2, Vec3::UnitX()).toRotationMatrix();
  bit::Part part;
  part.kind = bit::PartKind::face;
  part.X_BP = {turned * z_to_y, turned * Vec3(radius, 0, z)};
  part.mesh_P = battery::cylinder(cutter_radius, 1e-6, sides);
  part.cutter = static_cast<int>(bit.cutters.size());
  bit::Cutter cutter;
  cutter.azimuth = azimuth;
  bit.parts.push_back(part);
  bit.cutters.push_back(cutter);
}

double ring(double inner, double outer) { return pi * (outer * outer - inner * inner); }

TEST(RadialPlaneEngagement, of_a_single_cutter_is_its_ring_times_the_advance) {
  bit::Bit bit;
  add_disc(bit, 0.05, 1.0, 0.0);
  const Engagement e = radial_plane_engagement(bit, advance, spacing);
  EXPECT_NEAR(e.reach, 0.058, 6e-12);
  EXPECT_NEAR(e.total, advance * ring(0.042, 0.058), 8.5e-4 * e.total);
  EXPECT_NEAR(e.mean_area[0], advance * 0.016, 2e-3 * e.mean_area[0]);
  EXPECT_EQ(e.total, e.volume_per_revolution[0]);
}

TEST(RadialPlaneEngagement, of_opposite_twins_is_half_each) {
  bit::Bit bit;
  add_disc(bit, 0.05, 0.5, 0.0);
  add_disc(bit, 0.05, 0.5 + pi, 0.0);
  const Engagement e = radial_plane_engagement(bit, advance, spacing);
  EXPECT_NEAR(e.volume_per_revolution[0], 0.5 * e.total, 1e-9 * e.total);
  EXPECT_NEAR(e.volume_per_revolution[1], 0.5 * e.total, 1e-9 * e.total);
}

/// A quarter turn behind its twin, a cutter follows in the fresh cut and takes a quarter.
/// The bit turns about +z, so the cutter at the smaller azimuth follows.
TEST(RadialPlaneEngagement, gives_the_follower_the_part_of_the_turn_since_its_leader) {
  bit::Bit bit;
  add_disc(bit, 0.05, pi / 2, 0.0);
  add_disc(bit, 0.05, 0.0, 0.0);
  const Engagement e = radial_plane_engagement(bit, advance, spacing);
  EXPECT_NEAR(e.volume_per_revolution[1], 0.25 * e.total, 1e-9 * e.total);
}

/// Every point passes at its own azimuth; the table's azimuth only counts its turns.
TEST(RadialPlaneEngagement, takes_azimuths_from_the_points_and_not_from_the_table) {
  bit::Bit bit;
  add_disc(bit, 0.05, pi / 2, 0.0);
  add_disc(bit, 0.05, 0.0, 0.0);
  bit.cutters[1].azimuth = 0.5;
  const Engagement e = radial_plane_engagement(bit, advance, spacing);
  EXPECT_NEAR(e.volume_per_revolution[1], 0.25 * e.total, 1e-9 * e.total);
}

/// Of opposite twins, the one that stands proud by h takes advance / 2 + h, the other the rest.
TEST(RadialPlaneEngagement, gives_a_proud_cutter_more) {
  bit::Bit bit;
  const double h = 0.1 * advance;
  add_disc(bit, 0.05, 0.0, h);
  add_disc(bit, 0.05, pi, 0.0);
  const Engagement e = radial_plane_engagement(bit, advance, spacing);
  EXPECT_NEAR(e.mean_area[0] / (e.mean_area[0] + e.mean_area[1]), 0.6, 1e-12);
}

TEST(RadialPlaneEngagement, gives_nothing_to_a_cutter_that_is_too_high) {
  bit::Bit bit;
  add_disc(bit, 0.05, 0.0, 0.0);
  add_disc(bit, 0.05, pi, -0.51 * advance);
  const Engagement e = radial_plane_engagement(bit, advance, spacing);
  EXPECT_EQ(e.volume_per_revolution[1], 0.0);
}

TEST(RadialPlaneEngagement, ignores_parts_that_never_cut) {
  bit::Bit bit;
  add_disc(bit, 0.05, 0.0, 0.0);
  add_disc(bit, 0.09, 0.0, 0.0);
  bit.parts[1].cutting = bit::Cutting::never;
  const Engagement e = radial_plane_engagement(bit, advance, spacing);
  EXPECT_NEAR(e.reach, 0.058, 6e-12);
  EXPECT_EQ(e.volume_per_revolution[1], 0.0);
}

/// Cutters that leave no radius uncut, at any azimuths and heights: a hole of the bit's reach.
RC_GTEST_PROP(RadialPlaneEngagement, adds_up_to_the_hole, ()) {
  bit::Bit bit;
  for (double radius = cutter_radius; radius < 0.06; radius += cutter_radius)
    add_disc(bit, radius, *battery::number(-10.0, 10.0), 0.01 * *battery::number(-1.0, 1.0), 32);
  const Engagement e = radial_plane_engagement(bit, advance, 1e-4);
  const double hole = ring(0.0, e.reach) * advance;
  RC_ASSERT(std::abs(e.total - hole) < 1e-12 * hole);
  const auto& v = e.volume_per_revolution;
  RC_ASSERT(std::abs(std::accumulate(v.begin(), v.end(), 0.0) - e.total) < 1e-12 * hole);
}

/// The bit's own zero of azimuth means nothing.
RC_GTEST_PROP(RadialPlaneEngagement, does_not_depend_on_where_azimuth_starts, ()) {
  const double shift = *battery::number(0.0, 6.0);
  bit::Bit here, there;
  for (int i = 0; i < 4; ++i) {
    add_disc(here, 0.02 + 0.007 * i, 2.4 * i, 2e-4 * i, 32);
    add_disc(there, 0.02 + 0.007 * i, 2.4 * i + shift, 2e-4 * i, 32);
  }
  const Engagement a = radial_plane_engagement(here, advance, 1e-4);
  const Engagement b = radial_plane_engagement(there, advance, 1e-4);
  for (std::size_t c = 0; c < 4; ++c)
    RC_ASSERT(std::abs(a.volume_per_revolution[c] - b.volume_per_revolution[c]) < 1e-12 * a.total);
}

}  // namespace tdbd::reference::radial_plane_engagement_test

namespace tdbd::reference::scalloped_wall_test {

constexpr double pi = std::numbers::pi;
constexpr double a = 8e-3, middle = 0.05, advance = 2e-3;  // m

/// Thin discs in half-planes of the axis, so many at equal angles.
bit::Bit discs(int count) {
  bit::Bit bit;
  for (int i = 0; i < count; ++i) {
    const Mat3 turned =
        Eigen::AngleAxisd(0.7 + 2.0 * pi * i / count, Vec3::UnitZ()).toRotationMatrix();
    bit::Part part;
    part.X_BP.R.col(0) = turned * Vec3::UnitX();
    part.X_BP.R.col(1) = Vec3::UnitZ();
    part.X_BP.R.col(2) = -(turned * Vec3::UnitY());
    part.X_BP.p = turned * Vec3(middle, 0, 0);
    part.mesh_P = battery::cylinder(a, 1e-7, 256);
    bit.parts.push_back(part);
  }
  return bit;
}

/// Of a disc that passes every `pitch`: pi times the mean of (R + sqrt(a^2 - z^2))^2.
double volume(double pitch) {
  double sum = 0.0;
  constexpr int parts = 10000;
  for (int i = 0; i < parts; ++i) {
    const double z = pitch * ((i + 0.5) / parts - 0.5);
    sum += std::pow(middle + std::sqrt(a * a - z * z), 2) / parts;
  }
  return pi * advance * sum;
}

/// Three discs at equal angles pass every third of the advance: their scallops are a ninth as deep.
TEST(ScallopedWall, of_discs_is_their_arcs_side_by_side) {
  for (const int count : {1, 3}) {
    const ScallopedWall wall = scalloped_wall(discs(count), advance, 1000);
    const double pitch = advance / count;
    EXPECT_NEAR(wall.reach, middle + a, 1e-12);
    EXPECT_NEAR(wall.volume, volume(pitch), 3e-5 * wall.volume);
    const double cusp = middle + std::sqrt(a * a - 0.25 * pitch * pitch);
    EXPECT_NEAR(*std::ranges::min_element(wall.radius), cusp, 1.4e-6);
  }
}

}  // namespace tdbd::reference::scalloped_wall_test
