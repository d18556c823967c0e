#include "reference/literature/surface/spokes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "reference/literature/surface/z_map_sweep.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::spokes_test {

constexpr double pi = std::numbers::pi;
constexpr double a = 3e-3, centre_radius = 10e-3;  // m, of the disc

/// A thin disc whose plane holds the axis, its middle at `centre_radius` and height z.
mesh::TriangleMesh disc_B(double z) {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = Vec3::UnitZ();
  X.R.col(2) = -Vec3::UnitY();
  X.p = Vec3(centre_radius, 0, z);
  return battery::placed(X, battery::cylinder(a, 1e-6, 512));
}

/// Hull of the disc over a small turn, its lower facets.
mesh::TriangleMesh lower_sweep_B(double turn, double z) {
  bit::Bit bit;
  bit.cutters.resize(1);
  bit.cutters[0].X_BC.p = Vec3(centre_radius, 0, z);
  bit.cutters[0].X_BC.R = Eigen::AngleAxisd(pi, Vec3::UnitX()).toRotationMatrix();
  bit.parts.resize(1);
  bit.parts[0].cutter = 0;
  bit.parts[0].mesh_P = disc_B(z);
  const Pose back{Eigen::AngleAxisd(-turn, Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()};
  return sweep_tools(cutter_hulls(bit), back, 1.0).front().lower_B;
}

Spokes turned_once(Spokes rock, double z) {
  constexpr int steps = 1440;
  const auto lower = lower_sweep_B(2.0 * pi / steps, z);
  for (int i = 1; i <= steps; ++i)
    cut_sweep(
        rock, lower,
        {Eigen::AngleAxisd(2.0 * pi * i / steps, Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()});
  return rock;
}

/// A turn of the disc leaves a groove with the disc's circle in every half-plane.
TEST(Spokes, a_turning_disc_leaves_its_circle_at_every_node) {
  const Spokes rock = turned_once(flat_spokes(15e-3, 0.0, 37, 301), 0.0);
  for (int k = 0; k < rock.spokes; ++k)
    for (int j = 0; j < rock.nodes; ++j) {
      const double off = rock.node_radius(j) - centre_radius;
      const double expected = std::abs(off) < a ? std::sqrt(a * a - off * off) : 0.0;
      if (std::abs(std::abs(off) - a) < 1e-5) continue;  // the rim, where the circle is upright
      ASSERT_NEAR(rock.depth[static_cast<std::size_t>(k * rock.nodes + j)], expected, 1.1e-6)
          << "spoke " << k << " node " << j;
    }
}

/// Pappus: half a disc's area on its way about the axis.
TEST(Spokes, a_turning_disc_removes_its_half_circle_times_its_way) {
  Spokes rock = flat_spokes(15e-3, 0.0, 60, 600);
  const double exact = pi * a * a / 2.0 * 2.0 * pi * centre_radius;
  const double before = rock.depth.front();
  double removed = 0.0;
  const Spokes after = turned_once(rock, before);
  for (int k = 0; k < after.spokes; ++k)
    for (int j = 0; j < after.nodes; ++j)
      removed += after.depth[static_cast<std::size_t>(k * after.nodes + j)] * after.node_radius(j) *
                 after.node_spacing() * 2.0 * pi / after.spokes;
  EXPECT_NEAR(removed, exact, 1.7e-4 * exact);
}

/// A box over the axis: every spoke starts inside it.
TEST(Spokes, a_box_on_the_axis_is_seen_by_every_spoke) {
  Spokes rock = flat_spokes(2.0, 0.0, 16, 400);
  auto box = battery::box({-1, -1, -1}, {1, 1, 0.25});
  std::erase_if(box.triangles, [&](const mesh::Triangle& t) {
    const Vec3 &p = box.positions[t[0]], &q = box.positions[t[1]], &r = box.positions[t[2]];
    return (q - p).cross(r - p).z() <= 0.0;
  });
  const double removed = cut_sweep(rock, box, {});
  for (int k = 0; k < rock.spokes; ++k) {
    EXPECT_EQ(rock.depth[static_cast<std::size_t>(k) * rock.nodes], 0.25);
    const double side =
        1.0 / std::max(std::abs(std::cos(rock.azimuth(k))), std::abs(std::sin(rock.azimuth(k))));
    const int last = static_cast<int>(side / rock.node_spacing() - 0.5);
    EXPECT_EQ(rock.depth[static_cast<std::size_t>(k) * rock.nodes + last - 1], 0.25);
    EXPECT_EQ(rock.depth[static_cast<std::size_t>(k) * rock.nodes + last + 2], 0.0);
  }
  // The square by 16 sectors: 2 pi / 16 times half the sum of side^2.
  double sectors = 0.0;
  for (int k = 0; k < 16; ++k)
    sectors += 0.5 *
               std::pow(1.0 / std::max(std::abs(std::cos(rock.azimuth(k))),
                                       std::abs(std::sin(rock.azimuth(k)))),
                        2) *
               2.0 * pi / 16;
  EXPECT_NEAR(removed, 0.25 * sectors, 0.0047);
}

TEST(Spokes, depth_between_nodes_is_exact_for_a_cone) {
  Spokes rock = flat_spokes(1.0, 0.0, 12, 50);
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 50; ++j)
      rock.depth[static_cast<std::size_t>(k) * 50 + j] = 0.3 * rock.node_radius(j);
  for (const double azimuth : {0.1, 1.7, 3.1, 5.9, 6.27})
    EXPECT_NEAR(depth_at(rock, 0.61 * std::cos(azimuth), 0.61 * std::sin(azimuth)), 0.3 * 0.61,
                1e-12);
}

/// Figure 2.1: at the gage the spokes are as far apart as the radius makes them.
TEST(Spokes, spread_with_the_radius) {
  const Spokes langeveld = flat_spokes(107.95e-3, 0.0, 120, 500);
  EXPECT_NEAR(spoke_spacing(langeveld, 107.95e-3), 5.65225e-3, 3e-9);
  EXPECT_DOUBLE_EQ(langeveld.node_spacing(), 0.2159e-3);
}

/// A cutter takes a half disc out of an upright wall, 50 mm below its top. The hole grows by half
/// the disc's area for each metre of its way; one depth for each place takes all rock above as
/// well.
TEST(Spokes, one_depth_for_each_node_takes_the_rock_above_an_undercut) {
  const double r = 6.7e-3, below = 50e-3, wall = 100e-3;
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = Vec3::UnitZ();
  X.R.col(2) = -Vec3::UnitY();
  X.p = Vec3(wall, 0, below);
  auto disc = battery::placed(X, battery::cylinder(r, 1e-3, 256));
  std::erase_if(disc.triangles, [&](const mesh::Triangle& t) {
    const Vec3 &p = disc.positions[t[0]], &q = disc.positions[t[1]], &s = disc.positions[t[2]];
    return (q - p).cross(s - p).z() <= 0.0;
  });
  Spokes rock = flat_spokes(120e-3, 1.0, 8, 24000);  // the hole: nothing to take
  double area = 0.0;
  for (int j = 0; j < rock.nodes; ++j)
    if (rock.node_radius(j) > wall) rock.depth[static_cast<std::size_t>(j)] = 0.0;
  cut_sweep(rock, disc, {});
  for (int j = 0; j < rock.nodes; ++j)
    if (rock.node_radius(j) > wall)
      area += rock.depth[static_cast<std::size_t>(j)] * rock.node_spacing();
  EXPECT_NEAR(area, below * r + pi * r * r / 4.0, 2.7e-5 * area);
  EXPECT_NEAR(area / (pi * r * r / 2.0), 5.25, 0.0025);
}

}  // namespace tdbd::reference::spokes_test
