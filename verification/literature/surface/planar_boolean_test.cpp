#include "reference/literature/surface/planar_boolean.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/battery/generators.hpp"

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

TEST(PlanarBoolean, refuses_what_the_grid_does_not_hold) {
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

}  // namespace tdbd::reference::planar_boolean_test
