#include "reference/literature/drag/plane/planar_outline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "battery/generators.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "core/error.hpp"
#include "core/types.hpp"
#include "literature/drag/example_cutters.hpp"
#include "reference/literature/drag/plane/cutter_rim.hpp"
#include "reference/literature/drag/plane/worn_outlines.hpp"

namespace tdbd::reference::planar_outline_test {

constexpr double rounding = 1e-13;  // of sums over 10 000 columns, relative
constexpr double mm = 1e-3, mm2 = 1e-6;

double total(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

bit::Cutter any_cutter(double least_radius, double most_radius) {
  bit::Cutter c;
  c.diameter = *battery::number(8.0, 25.0) * mm;
  c.tip_radius = *battery::number(least_radius, most_radius) * mm;
  c.tip_height = *battery::number(-3.0, 20.0) * mm;
  c.azimuth = *battery::number(-7.0, 7.0);
  c.profile_angle = *battery::number(-0.5, 1.5);
  c.back_rake = *battery::number(0.0, 0.6);
  return c;
}

/// What is cut in a turn is all that the bit touches, d high: sum A = d x width, sum V = d x area.
RC_GTEST_PROP(PlanarOutline, of_any_layout_cuts_in_a_turn_all_that_it_touches, ()) {
  std::vector<bit::Cutter> cutters(*rc::gen::inRange<std::size_t>(1, 13));
  for (bit::Cutter& c : cutters) c = any_cutter(0.0, 110.0);
  const double advance = *battery::number(0.01, 20.0) * mm;
  const OutlineForm form = *rc::gen::element(OutlineForm::planar, OutlineForm::turned);
  const RadialOutlines outlines = radial_outlines(cutters, form, 0.1 * mm);
  const PlanarCut cut = planar_cut(outlines, advance);
  double width = 0.0, moment = 0.0;
  for (std::size_t k = 0; k < outlines.columns; ++k)
    if (cut.bottom[k] != no_depth) {
      width += outlines.width;
      moment += outlines.width * (static_cast<double>(k) + 0.5) * outlines.width;
    }
  const double scale = 200 * mm / advance * 1e-15;  // depths of 200 mm, heights of an advance
  const double allowed = rounding + 100 * scale;
  RC_ASSERT(std::abs(total(cut.area) / (advance * width) - 1.0) < allowed);
  RC_ASSERT(std::abs(total(cut.volume) / (2 * std::numbers::pi * advance * moment) - 1.0) <
            allowed);
}

/// With the centre cut and no gap: sum A = R d, sum V = pi R^2 d.
TEST(PlanarOutline, cuts_a_whole_disc_in_a_turn) {
  const double d = 3 * mm, R = example_gage;
  for (const char letter : {'a', 'b', 'c'}) {
    const PlanarCut cut = planar_cut(example_cutters(letter), d, 0.01 * mm);
    EXPECT_EQ(cut.revolutions, 3) << letter;  // steady in the second, the third agrees
    EXPECT_NEAR(total(cut.area), R * d, 1e-11 * R * d) << letter;
    EXPECT_NEAR(total(cut.volume), std::numbers::pi * R * R * d,
                1e-11 * std::numbers::pi * R * R * d)
        << letter;
  }
}

TEST(PlanarOutline, has_the_areas_of_bit_a) {
  const PlanarCut cut = planar_cut(example_cutters('a'), 3 * mm, 0.01 * mm);
  const std::vector<double> first{22.374, 17.858, 14.098, 17.858, 14.098,
                                  12.715, 19.239, 17.858, 14.098, 17.753};
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_NEAR(cut.area[i], first[i] * mm2, 5e-4 * first[i] * mm2) << "cutter " << i + 1;
  for (std::size_t i = 30; i < 36; ++i) EXPECT_NEAR(cut.area[i], 0.030 * mm2, 5e-4 * mm2) << i;
}

/// Turned about the axis, without side rake as the plane, the rim of cutter 1 misses a core: it
/// loses 1.6 mm2, no other cutter 0.01.
TEST(PlanarOutline, turned_about_the_axis_leaves_a_core) {
  const auto cutters = without_side_rake(example_cutters('a'));
  const RadialOutlines turned = radial_outlines(cutters, OutlineForm::turned, 0.01 * mm);
  const PlanarCut cut = planar_cut(turned, 3 * mm), plane = planar_cut(cutters, 3 * mm, 0.01 * mm);
  EXPECT_NEAR(cut.area[0], 20.795 * mm2, 5e-4 * 20.795 * mm2);
  EXPECT_NEAR(total(cut.area), 322.26 * mm2, 5e-4 * 322.26 * mm2);
  std::size_t core = 0;
  while (cut.bottom[core] == no_depth) ++core;
  EXPECT_NEAR(static_cast<double>(core) * turned.width, 0.5 * mm, 0.05 * mm);
  for (std::size_t i = 1; i < cutters.size(); ++i)
    EXPECT_NEAR(cut.area[i], plane.area[i], 0.01 * mm2) << "cutter " << i + 1;
}

/// Two flat-bottomed cutters that cover 0 to R, computed manually: opposite each other they share R
/// d evenly; a quarter turn apart the one at 90 degrees, which comes a quarter turn before that at
/// 0, has had three quarters of a turn to sink.
TEST(PlanarOutline, of_two_flat_cutters_is_the_one_computed_manually) {
  RadialOutlines flat;
  flat.columns = 1000;
  flat.width = 0.1 * mm;
  flat.reach = 100 * mm;
  flat.order = {1, 0};
  const double d = 2 * mm, all = flat.reach * d;
  for (const auto& [share, second] : {std::pair{0.5, 0.5}, {0.25, 0.75}}) {
    flat.of_cutter = {{0, std::vector<double>(1000), 0.0}, {0, std::vector<double>(1000), share}};
    const PlanarCut cut = planar_cut(flat, d);
    EXPECT_NEAR(cut.area[1], second * all, 1e-12 * all);
    EXPECT_NEAR(cut.area[0], (1.0 - second) * all, 1e-12 * all);
    EXPECT_NEAR(cut.arm(0), flat.reach / 2, 1e-12 * flat.reach);
  }
}

/// The flat removes what lies beyond it, in both forms: a worn cutter alone touches a chord.
TEST(PlanarOutline, of_a_worn_cutter_ends_at_its_flat) {
  bit::Cutter c;
  c.diameter = 16 * mm;
  c.tip_radius = 500 * mm;
  c.wear = 1 * mm;
  const double chord = 2 * std::sqrt(15.0) * mm;  // 2 sqrt(2 a w - w^2)
  for (const OutlineForm form : {OutlineForm::planar, OutlineForm::turned}) {
    const RadialOutlines o = radial_outlines({c}, form, 0.01 * mm);
    double deepest = no_depth, level = 0.0;
    for (const double z : o.of_cutter[0].depth) deepest = std::max(deepest, z);
    for (const double z : o.of_cutter[0].depth) level += z > deepest - 1e-9 ? o.width : 0.0;
    EXPECT_NEAR(deepest, -1 * mm, 1e-12);
    EXPECT_NEAR(level, chord, 0.1 * mm);
  }
}

TEST(PlanarOutline, needs_cutters_and_columns) {
  EXPECT_THROW(planar_cut(std::vector<bit::Cutter>{}, 1 * mm, 0.1 * mm), InputError);
  EXPECT_THROW(planar_cut(example_cutters('a'), 1 * mm, 0.0), InputError);
}

}  // namespace tdbd::reference::planar_outline_test

namespace tdbd::reference::worn_outlines_test {

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

/// planar_cut simulates six revolutions and computes each outline again; without wear there is no
/// other difference.
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

}  // namespace tdbd::reference::worn_outlines_test
