#include "bit/profile/bit_analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bit/generate.hpp"

/// Numbers of small bits, by hand.
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
  RC_ASSERT(std::abs(planar_imbalance(turned, scaled, 0.8) - found) < 1e-14 * (1.0 + found));
}

/// Opposite ones balance; without cutters, or with such as push down, there is no weight.
TEST(PlanarImbalance, is_none_of_opposite_cutters_and_no_number_without_weight) {
  const Cutter a = cutter_at(0.0, 30 * degree), b = cutter_at(pi, 30 * degree);
  EXPECT_NEAR(planar_imbalance({a, b}, {3.0, 3.0}, 0.8), 0.0, 1e-15);
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

}  // namespace tdbd::bit::bit_analysis_test
