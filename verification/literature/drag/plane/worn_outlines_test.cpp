#include "reference/literature/drag/plane/worn_outlines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bit/cutter/cutter_table.hpp"
#include "core/angles.hpp"
#include "core/error.hpp"
#include "reference/literature/drag/plane/planar_outline.hpp"

namespace tdbd::reference::worn_outlines_test {
namespace {

std::vector<bit::Cutter> table(const std::string& bit) {
  return bit::read_cutter_table(TDBD_SOURCE_DIR "/cases/bits/" + bit + ".csv",
                                bit::CutterDefaults{});
}

bit::Cutter disc(double radius, double tip_radius, double azimuth, double profile_angle) {
  bit::Cutter c;
  c.diameter = 2.0 * radius;
  c.tip_radius = tip_radius;
  c.azimuth = azimuth;
  c.profile_angle = profile_angle;
  c.back_rake = 20.0 * degree;
  return c;
}

WornCut cut(const std::vector<bit::Cutter>& cutters, double column, const std::vector<double>& worn,
            double advance) {
  WornCut c;
  cut_worn(worn_outlines(cutters, column), worn, advance, c);
  return c;
}

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

/// planar_cut lets six revolutions pass and draws each outline anew; without wear nothing else differs.
TEST(WornOutlines, without_wear_are_those_of_the_planar_model) {
  constexpr double column = 0.05e-3, advance = 3e-3;
  for (const char* name : {"bit-a", "bit-b", "bit-c"}) {
    const auto cutters = table(name);
    const WornCut worn = cut(cutters, column, std::vector<double>(cutters.size()), advance);
    const PlanarCut planar = planar_cut(cutters, advance, column);
    for (std::size_t i = 0; i < cutters.size(); ++i) {
      EXPECT_NEAR(worn.area[i], planar.area[i], 1e-16) << name << " cutter " << i;      // m2
      EXPECT_NEAR(worn.volume[i], planar.volume[i], 1e-16) << name << " cutter " << i;  // m3
    }
  }
}

TEST(WornOutlines, two_equal_cutters_share_by_the_turn_between_them) {
  const double advance = 1e-3;
  const auto shares = [&](double degrees) {
    const std::vector<bit::Cutter> two{disc(8e-3, 20e-3, 0.0, 0.0),
                                       disc(8e-3, 20e-3, degrees * degree, 0.0)};
    const WornCut c = cut(two, 0.05e-3, {0.0, 0.0}, advance);
    return c.area[1] / sum(c.area);
  };
  EXPECT_NEAR(shares(180.0), 0.5, 1e-12);
  EXPECT_NEAR(shares(90.0), 0.75, 1e-12);
}

TEST(WornOutlines, a_flat_has_the_chord_of_its_height) {
  const double a = 8e-3, worn = 1e-3, column = 1e-6;
  const WornCut c = cut({disc(a, 20e-3, 0.0, 0.0)}, column, {worn * std::cos(20.0 * degree)}, 1e-3);
  const double deepest = *std::max_element(c.bottom.begin(), c.bottom.end());
  EXPECT_NEAR(deepest, 2e-3 - worn * std::cos(20.0 * degree), 1e-15);
  const auto flat = std::count(c.bottom.begin(), c.bottom.end(), deepest);
  EXPECT_NEAR(static_cast<double>(flat) * column, 2.0 * std::sqrt(worn * (2.0 * a - worn)),
              2.0 * column);
}

TEST(WornOutlines, wear_of_a_gage_cutter_makes_the_hole_smaller) {
  const double column = 0.01e-3, tip = 100e-3, worn = 0.5e-3;
  const auto radius = [&](double lost) {
    const WornCut c = cut({disc(8e-3, tip, 0.0, right_angle)}, column, {lost}, 1e-3);
    const auto last =
        std::find_if(c.bottom.rbegin(), c.bottom.rend(), [](double z) { return std::isfinite(z); });
    return static_cast<double>(c.bottom.rend() - last) * column;
  };
  EXPECT_NEAR(radius(0.0), tip, column);
  EXPECT_NEAR(radius(worn), tip - worn, column);
}

/// What is cut in a turn is the area to the gage, whatever the wear; only who cuts it changes.
TEST(WornOutlines, what_worn_cutters_leave_others_cut) {
  const auto cutters = table("bit-b");
  const double column = 0.02e-3, advance = 3e-3;
  std::vector<double> worn(cutters.size());
  const WornCut sharp = cut(cutters, column, worn, advance);
  worn[10] = 1e-3;
  const WornCut blunt = cut(cutters, column, worn, advance);
  EXPECT_NEAR(sum(blunt.area), sum(sharp.area), 1e-12 * sum(sharp.area));
  EXPECT_LT(blunt.area[10], 0.9 * sharp.area[10]);
}

TEST(WornOutlines, need_cutters_with_a_diameter_and_columns) {
  EXPECT_THROW(worn_outlines({}, 1e-5), InputError);
  EXPECT_THROW(worn_outlines({bit::Cutter{}}, 1e-5), InputError);
  EXPECT_THROW(worn_outlines({disc(8e-3, 20e-3, 0.0, 0.0)}, 0.0), InputError);
}

}  // namespace
}  // namespace tdbd::reference::worn_outlines_test
