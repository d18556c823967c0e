#include "bit/profile/engagement.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "bit/cutter/rim_reach.hpp"
#include "bit/generate_design.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "reference/bit/radial_plane_engagement.hpp"

namespace tdbd::bit::engagement_test {

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

/// One cutter removes the advance over its whole width, but for the bend of radii across its face:
/// sqrt(50^2 + y^2) hardly differs, as the face stands in the half-plane.
TEST(Engagement, of_one_cutter_is_its_width_times_the_advance) {
  const Engagement e = engagement({flat_cutter(0.3)}, advance, width);
  EXPECT_NEAR(e.area[0], 0.02 * advance, 1e-12 * 0.02 * advance);
  EXPECT_NEAR(e.volume[0], 2 * pi * 0.05 * 0.02 * advance, 1e-12 * e.volume[0]);
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

}  // namespace tdbd::bit::engagement_test
