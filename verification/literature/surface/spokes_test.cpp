#include "reference/literature/surface/spokes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/literature/surface/planar_boolean.hpp"
#include "reference/literature/surface/range_search.hpp"
#include "reference/literature/surface/surface_error.hpp"
#include "reference/literature/surface/z_map_sweep.hpp"
#include "rock/index/vertex_grid.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/rock/index/grid_query.hpp"

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

namespace tdbd::reference::planar_boolean_test {

const Outline square{{0, 0}, {0.4, 0}, {0.4, 0.4}, {0, 0.4}};

TEST(PlanarBoolean, a_corner_is_taken_off_exactly) {
  const PlanarRegion left =
      without({{square, {}}}, {{0.3, 0.3}, {0.5, 0.3}, {0.5, 0.5}, {0.3, 0.5}});
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].border.size(), 6U);
  EXPECT_NEAR(area(left), 0.15, 1e-15);
  // Pappus: 0.4^2/2 * 0.4 without 0.1 * (0.4^2 - 0.3^2)/2.
  EXPECT_NEAR(moment(left), 0.032 - 0.0035, 1e-16);
}

TEST(PlanarBoolean, what_lies_within_is_a_cavity_and_what_is_cut_through_has_two_pieces) {
  const PlanarRegion holed =
      without({{square, {}}}, {{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.1, 0.2}});
  ASSERT_EQ(holed.size(), 1U);
  ASSERT_EQ(holed[0].cavities.size(), 1U);
  EXPECT_NEAR(area(holed), 0.15, 1e-15);
  const PlanarRegion halves = without(holed, {{0.14, -1}, {0.16, -1}, {0.16, 1}, {0.14, 1}});
  EXPECT_EQ(halves.size(), 2U);
  EXPECT_NEAR(area(halves), 0.15 - 0.02 * 0.3, 1e-15);
}

/// Regularised: common edges leave no lines, either way round, and rims are no area.
TEST(PlanarBoolean, touching_takes_nothing) {
  const Outline beside{{0.4, 0}, {0.4, 0.4}, {0.6, 0.4}, {0.6, 0}};
  const PlanarRegion left = without({{square, {}}}, beside);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].border.size(), 4U);
  EXPECT_EQ(area(left), area({{square, {}}}));
  EXPECT_TRUE(within({{square, {}}}, beside).empty());
  EXPECT_TRUE(without({{square, {}}}, square).empty());
}

TEST(PlanarBoolean, rejects_what_the_grid_does_not_contain) {
  EXPECT_THROW(without({{square, {}}}, {{0, 0}, {2.5, 0}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(without({{square, {}}}, {{0, 0}, {NAN, 0}, {0, 1}}), std::invalid_argument);
}

Outline any_star() {
  const Vec2 middle(*battery::number(-0.3, 0.3), *battery::number(-0.3, 0.3));
  const int corners = *rc::gen::inRange(3, 12);
  Outline star;
  for (int i = 0; i < corners; ++i)
    star.push_back(middle + *battery::number(0.1, 0.6) *
                                Vec2(std::cos(2.0 * std::numbers::pi * i / corners),
                                     std::sin(2.0 * std::numbers::pi * i / corners)));
  return star;
}

bool holds(const PlanarRegion& region, const Vec2& x) {
  for (const PlanarFace& face : region)
    if (encloses(face, x)) return true;
  return false;
}

/// Of two random stars, what is without and what is within add up, and any point is where it
/// belongs.
RC_GTEST_PROP(PlanarBoolean, parts_what_it_cuts, ()) {
  const PlanarRegion rock{{any_star(), {}}};
  const Outline tool = any_star();
  const PlanarRegion out = without(rock, tool), in = within(rock, tool);
  const double rounding = 20.0 * planar_grid;  // m2: twice a perimeter of some metres
  RC_ASSERT(std::abs(area(out) + area(in) - area(rock)) < rounding);
  for (int i = 0; i < 50; ++i) {
    const Vec2 x(*battery::number(-1.0, 1.0) + 3.3e-4, *battery::number(-1.0, 1.0) + 1.7e-4);
    RC_ASSERT(holds(out, x) == (holds(rock, x) && !encloses(tool, x)));
    RC_ASSERT(holds(in, x) == (holds(rock, x) && encloses(tool, x)));
  }
}

std::vector<Vec3> any_points(int most) {
  std::vector<Vec3> points;
  const int count = *battery::integer(0, most);
  for (int i = 0; i < count; ++i) points.push_back(*battery::point(1.0));
  return points;
}

/// Between two places, of which either may be a point of the set: its sides then hold points.
SearchBox any_box(const std::vector<Vec3>& points) {
  const auto corner = [&] {
    if (points.empty() || *rc::gen::arbitrary<bool>()) return *battery::point(1.2);
    return points[at(*battery::integer(0, static_cast<int>(points.size()) - 1))];
  };
  const Vec3 a = corner(), b = corner();
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

std::vector<int> found_in_order(const RangeSearch& search, const SearchBox& box) {
  std::vector<int> found;
  search.find(box, found);
  std::ranges::sort(found);
  return found;
}

/// What our index finds in the box: it offers what may be inside.
std::vector<int> found_by_our_index(const std::vector<Vec3>& points, const SearchBox& box) {
  std::vector<int> all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  rock::VertexGrid grid({Vec3::Constant(-0.8), Vec3::Constant(0.8)}, 0.3);
  grid.insert_all(points, all);
  const mesh::Box ours{box.lo, box.hi};
  std::vector<int> found;
  rock::visit_vertices(grid, {ours, {}}, [&](int v) {
    if (ours.contains(points[at(v)])) found.push_back(v);
  });
  std::ranges::sort(found);
  return found;
}

std::vector<int> found_one_by_one(const std::vector<Vec3>& points, const SearchBox& box) {
  std::vector<int> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((points[i].array() >= box.lo.array()).all() && (points[i].array() <= box.hi.array()).all())
      found.push_back(static_cast<int>(i));
  return found;
}

RC_GTEST_PROP(RangeSearch, finds_what_the_index_of_tdbd_finds, ()) {
  const std::vector<Vec3> points = any_points(300);
  const RangeSearch search(points);
  for (int i = 0; i < 10; ++i) {
    const SearchBox box = any_box(points);
    const std::vector<int> found = found_in_order(search, box);
    RC_ASSERT(found == found_by_our_index(points, box));
    RC_ASSERT(found == found_one_by_one(points, box));
  }
}

RC_GTEST_PROP(RangeSearch, finds_points_where_they_have_moved, ()) {
  std::vector<Vec3> points = any_points(100);
  RangeSearch search(points);
  for (Vec3& x : points) x += *battery::point(0.5);
  search.refit(points);
  const SearchBox box = any_box(points);
  RC_ASSERT(found_in_order(search, box) == found_one_by_one(points, box));
}

TEST(RangeSearch, takes_points_in_one_place) {
  const std::vector<Vec3> points(100, Vec3(1, 2, 3));
  const RangeSearch search(points);
  std::vector<int> found;
  search.find({{1, 2, 3}, {1, 2, 3}}, found);
  EXPECT_EQ(found.size(), 100U);
  search.find({{0, 0, 0}, {1, 2, 2.9}}, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace tdbd::reference::planar_boolean_test

namespace tdbd::reference::surface_error_test {

constexpr double pi = std::numbers::pi;

/// A cone of 30 degrees: cosine sqrt(3)/2 everywhere.
ProfileCosine cone() { return {{0.2, 0.9}, {pi / 6, pi / 6}}; }

ZMap raised(double by) {
  ZMap map = flat_z_map(1.0, 0.5, 400);
  for (double& z : map.height) z += by;
  return map;
}

TEST(SurfaceError, of_a_shifted_surface_is_the_shift_along_the_normal) {
  const auto e = surface_errors(raised(0.0), raised(-0.01), cone(), {0.3, 0.6, 0.9});
  ASSERT_EQ(e.size(), 2U);
  for (const SurfaceError& ring : e) {
    EXPECT_NEAR(ring.mean_signed, -0.01 * std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(ring.mean, 0.01 * std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(ring.p95, ring.mean, 1e-12);
    EXPECT_NEAR(ring.rms, ring.mean, 1e-12);
    const double area = pi * (ring.r_hi * ring.r_hi - ring.r_lo * ring.r_lo);
    EXPECT_NEAR(ring.volume, -0.01 * area, 0.01 * 9e-4 * area);  // cells on the rim
  }
}

/// A ramp in x: distances are uniform over the disc's chords, the largest twentieth beyond p95.
TEST(SurfaceError, percentiles_are_those_of_the_distances) {
  ZMap ramp = raised(0.0);
  for (int i = 0; i < ramp.cells * ramp.cells; ++i)
    ramp.height[static_cast<std::size_t>(i)] += -1.0 + (i % ramp.cells + 0.5) * ramp.cell();
  const ProfileCosine flat{{0.0, 1.0}, {0.0, 0.0}};
  const auto e = surface_errors(raised(0.0), ramp, flat, {0.0, 0.9}).front();
  // |x| <= c on a share (2/pi) (c sqrt(1 - c^2) + asin c) of a unit disc: 0.95 at c = 0.8783.
  EXPECT_NEAR(e.p95, 0.8783 * 0.9, 0.005);
  EXPECT_NEAR(e.rms, 0.45, 5e-5);                       // R/2
  EXPECT_NEAR(e.mean, 4.0 * 0.9 / (3.0 * pi), 5.5e-5);  // 4 R/(3 pi)
  EXPECT_NEAR(e.mean_signed, 0.0, 1e-12);
}

TEST(SurfaceError, rejects_other_cells) {
  EXPECT_THROW(surface_errors(raised(0.0), flat_z_map(1.0, 0.0, 10), cone(), {0.0, 1.0}),
               std::invalid_argument);
}

}  // namespace tdbd::reference::surface_error_test
