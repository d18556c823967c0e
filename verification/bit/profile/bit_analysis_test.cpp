#include "bit/profile/bit_analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "bit/cutter/cutter.hpp"
#include "bit/generate.hpp"
#include "bit/generate_design.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "reference/bit/radial_plane_engagement.hpp"

/// Numbers of small bits, computed manually.
namespace tdbd::bit::bit_analysis_test {

/// A cutter of 20 mm with its tip at a radius of 50 mm.
Cutter cutter_at(double azimuth, double profile_angle) {
  Cutter c;
  c.diameter = 0.02;
  c.tip_radius = 0.05;
  c.azimuth = azimuth;
  c.profile_angle = profile_angle;
  return c;
}

TEST(Imbalance, is_the_lateral_part_of_what_cutters_push) {
  const Cutter a = cutter_at(0.0, pi / 2), b = cutter_at(pi / 2, pi / 2);
  EXPECT_NEAR(imbalance({a}, {2.0}), 1.0, 1e-15);
  EXPECT_NEAR(imbalance({a, b}, {3.0, 4.0}), 5.0 / 7.0, 1e-15);
  const Vec3 expected(3.0 / 7.0, 4.0 / 7.0, 0.0);
  EXPECT_LT((imbalance_vector({a, b}, {3.0, 4.0}) - expected).norm(), 1e-15);
  EXPECT_EQ(imbalance_vector({}, {}).norm(), 0.0);
  EXPECT_NEAR(imbalance({a, cutter_at(pi, pi / 2)}, {3.0, 3.0}), 0.0, 1e-15);
  EXPECT_NEAR(imbalance({cutter_at(0.0, 30 * degree)}, {1.0}), 0.5, 1e-15);
}

/// Drag along the way of one, pushed back by the ratio along a normal of 30 degrees: (ratio / 2, 1)
/// over ratio cos 30 degrees.
TEST(PlanarImbalance, of_one_cutter_has_drag_and_normal_force) {
  const double ratio = 0.8;
  EXPECT_NEAR(planar_imbalance({cutter_at(0.0, 30 * degree)}, {2.0}, ratio),
              std::hypot(0.5 * ratio, 1.0) / (ratio * std::cos(30 * degree)), 2e-15);
}

RC_GTEST_PROP(PlanarImbalance, is_the_same_of_a_turned_bit_and_of_any_unit_of_area, ()) {
  std::vector<Cutter> cutters, turned;
  std::vector<double> areas, scaled;
  const double turn = number(-3.0, 3.0), unit = number(0.1, 10.0);
  for (int k = 0; k < 5; ++k) {
    cutters.push_back(cutter_at(number(-3.0, 3.0), number(-0.3, 1.2)));
    turned.push_back(cutters.back());
    turned.back().azimuth += turn;
    areas.push_back(number(1.0, 2.0));
    scaled.push_back(unit * areas.back());
  }
  const double found = planar_imbalance(cutters, areas, 0.8);
  const PlanarBalance parts = planar_balance(cutters, areas, 0.8);
  RC_ASSERT(std::abs((parts.normal + parts.drag).norm() / parts.weight - found) <
            1e-14 * (1.0 + found));
  RC_ASSERT(std::abs(planar_imbalance(turned, scaled, 0.8) - found) < 1e-14 * (1.0 + found));
}

/// Opposite ones balance; without cutters, or with such as push down, there is no weight.
TEST(PlanarImbalance, is_none_of_opposite_cutters_and_no_number_without_weight) {
  const Cutter a = cutter_at(0.0, 30 * degree), b = cutter_at(pi, 30 * degree);
  EXPECT_NEAR(planar_imbalance({a, b}, {3.0, 3.0}, 0.8), 0.0, 1e-15);
  const PlanarBalance one = planar_balance({cutter_at(0.0, 30 * degree)}, {2.0}, 0.8);
  EXPECT_NEAR(one.weight, 0.8 * 2.0 * std::cos(30 * degree), 1e-15);
  EXPECT_NEAR((one.normal - Vec3(-0.8, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((one.drag - Vec3(0, -2, 0)).norm(), 0.0, 1e-15);
  EXPECT_TRUE(std::isnan(planar_imbalance({}, {}, 0.8)));
  EXPECT_TRUE(std::isnan(planar_imbalance({cutter_at(0.0, 100 * degree)}, {1.0}, 0.8)));
  EXPECT_TRUE(std::isnan(planar_imbalance({a}, {1.0}, 0.0)));
}

/// Back-ups have no neighbours; the last one has none behind it.
TEST(Overlaps, are_of_neighbours_on_the_profile) {
  const Cutter a = cutter_at(0.0, 30 * degree);
  Cutter b = a, backup = a;
  b.tip_radius = 0.053;
  b.tip_height = 0.004;
  backup.under_exposure = 1e-3;
  const std::vector<double> overlap = overlaps({b, backup, a});
  EXPECT_NEAR(overlap[2], 0.75, 1e-14);
  EXPECT_TRUE(std::isnan(overlap[0]) && std::isnan(overlap[1]));
}

TEST(MeanRedundancy, counts_rings_by_their_area) {
  EXPECT_NEAR(mean_redundancy({1, 3}), (1.0 + 3 * 3.0) / 4.0, 1e-15);
  EXPECT_EQ(mean_redundancy({}), 0.0);
}

constexpr double advance = 5e-3;
/// m: a hair above a 1200th of 60 mm, so that rounding adds no column
constexpr double width = 0.0500001e-3;

/// A flat, sharp cutter of 20 mm, tip at radius 50 mm, straight down.
Cutter flat_cutter(double azimuth, double height = 0.0) {
  Cutter c;
  c.diameter = 0.02;
  c.length = 0.01;
  c.tip_radius = 0.05;
  c.tip_height = height;
  c.azimuth = azimuth;
  c.X_BC = cutter_pose(c);
  return c;
}

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

/// One cutter removes the advance over its whole width, except for the change of the radius across
/// its face: sqrt(50^2 + y^2) hardly differs, because the face is in the half-plane.
TEST(Engagement, of_one_cutter_is_its_width_times_the_advance) {
  const Engagement e = engagement({flat_cutter(0.3)}, advance, width);
  EXPECT_NEAR(e.area[0], 0.02 * advance, 1e-12 * 0.02 * advance);
  EXPECT_NEAR(e.volume[0], 2 * pi * 0.05 * 0.02 * advance, 1e-12 * e.volume[0]);
}

/// The lower half of its rim cuts, but for the first column at either end, where the rim is upright.
TEST(Engagement, of_one_cutter_has_half_its_rim_as_edge) {
  const Engagement e = engagement({flat_cutter(0.3)}, advance, width);
  EXPECT_NEAR(e.edge[0] / (pi * 0.01), 1.0, 0.06);
  const Engagement finer = engagement({flat_cutter(0.3)}, advance, 0.1 * width);
  EXPECT_NEAR(finer.edge[0] / (pi * 0.01), 1.0, 0.02);
  EXPECT_EQ(engagement({flat_cutter(0.0), flat_cutter(pi, 2.0 * advance)}, advance, width).edge[1],
            0.0);
}

/// A cutter a quarter turn behind another takes a quarter of the advance, the other the rest.
TEST(Engagement, of_two_equal_cutters_is_shared_by_the_angle_before_them) {
  const Engagement e = engagement({flat_cutter(0.0), flat_cutter(pi / 2)}, advance, width);
  EXPECT_NEAR(e.area[0] / e.area[1], 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(mean_redundancy(e.cutting), 2.0 * (0.06 * 0.06 - 0.04 * 0.04) / (0.06 * 0.06), 1e-12);
}

/// Half a turn behind, a back-up joins once half the advance exceeds its under-exposure.
TEST(Engagement, of_a_backup_begins_at_its_under_exposure) {
  const auto areas = [](double under) {
    return engagement({flat_cutter(0.0), flat_cutter(pi, under)}, advance, width).area;
  };
  EXPECT_EQ(areas(0.51 * advance)[1], 0.0);
  EXPECT_NEAR(areas(0.3 * advance)[1] / areas(0.3 * advance)[0], 0.2 / 0.8, 1e-12);
}

TEST(Engagement, of_no_cutters_has_no_columns) {
  const Engagement e = engagement({}, advance, width);
  EXPECT_TRUE(e.area.empty() && e.cutting.empty());
  EXPECT_EQ(mean_redundancy(e.cutting), 0.0);
}

RC_GTEST_PROP(Engagement, adds_up_to_the_whole_hole, ()) {
  const PdcDesign d = any_design();
  const Engagement e = engagement(laid_out(d), advance, width);
  const double reach = e.column_width * static_cast<double>(e.cutting.size());
  const long uncut = std::ranges::count(e.cutting, 0);
  RC_ASSERT(uncut ==
            std::ranges::find_if(e.cutting, [](int n) { return n > 0; }) - e.cutting.begin());
  const double hole = pi * reach * reach * advance;
  const double core = pi * std::pow(e.column_width * static_cast<double>(uncut), 2) * advance;
  RC_ASSERT(std::abs(sum(e.volume) - (hole - core)) < 1e-11 * hole);
}

/// The twin simulates passes of all mesh edges, here the rims pass in closed form: 0.5 % of the
/// mean cutter's volume, and the hole to the columns' width over the radius. The twin's rims have
/// 512 corners: with 64 they miss 10 micrometres, much for a cutter that cuts 0.3 mm at the gage.
TEST(Engagement, is_what_the_twin_finds) {
  for (const char letter : {'a', 'b', 'c'}) {
    PdcOptions options;
    options.meshing.rim_segments = 512;
    const Bit bit = example_bit(letter, options);
    const Engagement e = engagement(bit.cutters, advance, width);
    const auto twin = reference::radial_plane_engagement(bit, advance, width);
    const double mean = twin.total / static_cast<double>(bit.cutters.size());
    EXPECT_NEAR(sum(e.volume) / twin.total, 1.0, 0.3 * width / bit.gage_radius);
    for (std::size_t k = 0; k < bit.cutters.size(); ++k)
      EXPECT_NEAR(e.volume[k], twin.volume_per_revolution[k], 5e-3 * mean) << letter << k + 1;
  }
}

TEST(Engagement, of_a_worn_cutter_is_cut_short) {
  Cutter c = flat_cutter(0.0);
  c.wear = 2e-3;
  double deepest = -1.0;
  for (const Vec3& p : turned_outline(c, 360)) deepest = std::max(deepest, p.z());
  EXPECT_NEAR(deepest, -2e-3, 1e-15);
}

std::vector<Part> parts_of_cutter(const Bit& bit, int cutter) {
  std::vector<Part> parts;
  for (const Part& part : bit.parts)
    if (part.cutter == cutter) parts.push_back(part);
  return parts;
}

/// Where the frame is known, both ways lead along the profile: a few degrees apart where the
/// profile bends or ends.
TEST(ProfileDirection, is_nearly_that_of_the_cutters_frame) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Bit bit = example_bit(letter);
    const auto profile = exposure_profile(bit.parts, 0.5e-3);
    for (int i = 0; i < static_cast<int>(bit.cutters.size()); ++i) {
      const Vec3 u = profile_direction(profile, parts_of_cutter(bit, i), DirectionRule::hybrid,
                                       InsideRule::down);
      const Vec3 expected =
          update_direction(bit.cutters[i].X_BC, DirectionRule::hybrid, InsideRule::down);
      EXPECT_GT(u.dot(expected), std::cos(8.0 * degree)) << letter << bit.cutters[i].id;
    }
  }
}

/// A part 10 mm wide at r = 50 mm.
Part ball() {
  Part part;
  part.X_BP.p = Vec3(30e-3, 40e-3, 0.0);
  part.mesh_P.positions = {{-5e-3, 0, 0}, {5e-3, 0, 0}, {0, 0, -5e-3}, {0, 0, 5e-3}};
  return part;
}

TEST(ProfileDirection, is_the_normal_of_a_straight_profile) {
  const auto along = [](const ProfilePoint& from, const ProfilePoint& to) {
    std::vector<ProfilePoint> line;
    for (int k = 0; k <= 100; ++k)
      line.push_back({std::lerp(from.r, to.r, k / 100.0), std::lerp(from.z, to.z, k / 100.0)});
    return profile_direction(line, {ball()}, DirectionRule::hybrid, InsideRule::minus_x);
  };
  const Vec3 slope = Vec3(1, 0, 1).normalized();
  EXPECT_LT((along({45e-3, 0.01}, {65e-3, -0.01}) - slope).norm(), 1e-12);
  EXPECT_LT((along({50e-3, 0.01}, {50e-3, -0.02}) - Vec3(1, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(along({0, 0.01}, {0.1, 0.01}), Vec3(-1, 0, 0));
}

/// A profile that is flat up to some way outside of the part's middle and rises there, as points
/// 0.3 mm apart. The part is 10 mm high: the first points 5 mm away are at 5.1 mm.
TEST(ProfileDirection, looks_as_far_to_both_sides_as_the_part_is_large) {
  const auto flat_up_to = [](double flat) {
    const double middle = 0.5 * (std::hypot(25e-3, 40e-3) + std::hypot(35e-3, 40e-3));
    std::vector<ProfilePoint> line;
    for (int k = -40; k <= 40; ++k)
      line.push_back({middle + 0.3e-3 * k, 0.01 - std::max(0.0, 0.3e-3 * k - flat)});
    return profile_direction(line, {ball()}, DirectionRule::along_profile, InsideRule::down);
  };
  EXPECT_LT((flat_up_to(5.2e-3) - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((flat_up_to(4.9e-3) - Vec3(0.2, 0.0, 10.2).normalized()).norm(), 1e-12);
}

/// Saw teeth of 45 degrees, 2 mm apart, on a flat profile: their own normals are far from down.
TEST(ProfileDirection, averages_scallops_out) {
  std::vector<ProfilePoint> line;
  for (int k = 0; k <= 400; ++k) line.push_back({k * 0.25e-3, 0.01 + 0.25e-3 * (k % 8)});
  const Vec3 u = profile_direction(line, {ball()}, DirectionRule::along_profile, InsideRule::down);
  EXPECT_GT(u.z(), std::cos(12.0 * degree));
}

}  // namespace tdbd::bit::bit_analysis_test
