#include "reference/literature/surface/outline_nodes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/battery/generators.hpp"

namespace tdbd::reference::outline_nodes_test {

constexpr SpokeFrame frame{0.1, 0.1};

/// Rock below a line of points from the axis to the end of the spoke.
PlanarFace below(Outline line) {
  line.emplace_back(frame.radius, frame.floor);
  line.emplace_back(0.0, frame.floor);
  return {line, {}};
}

double edge(const Outline& outline, std::size_t i) {
  return (outline[(i + 1) % outline.size()] - outline[i]).norm();
}

bool is_on_frame(const Vec2& x) {
  return x.x() == 0.0 || x.x() == frame.radius || x.y() == frame.floor;
}

TEST(OutlineNodes, part_long_edges_evenly_and_leave_the_frames_alone) {
  const PlanarFace even = respaced(below({{0, 0}, {0.1, 0}}), frame, 0.01);
  ASSERT_EQ(even.border.size(), 7U + 1U + 2U);  // seven parts of 14.3 mm, at most 15
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(edge(even.border, i), 0.1 / 7, 2e-9);
  EXPECT_NEAR(area({even}), 0.01, 1e-16);
}

TEST(OutlineNodes, drop_what_the_frames_own_edges_hold) {
  const PlanarFace face{
      {{0, 0}, {0.1, 0}, {0.1, 0.03}, {0.1, 0.1}, {0.04, 0.1}, {0, 0.1}, {0, 0.01}}, {}};
  EXPECT_EQ(respaced(face, frame, 1.0).border.size(), 4U);
}

/// Of nodes that stand too close, the one on a straight goes, the corner beside it stays.
TEST(OutlineNodes, drop_first_what_costs_least) {
  const PlanarFace even = respaced(
      below({{0, 0}, {0.048, 0}, {0.05, 0.01}, {0.0505, 0.01}, {0.056, 0.01}, {0.1, 0.01}}), frame,
      0.01);
  const auto has = [&](const Vec2& x) {
    return std::ranges::find(even.border, x) != even.border.end();
  };
  EXPECT_TRUE(has(Vec2(0.05, 0.01)));
  EXPECT_FALSE(has(Vec2(0.0505, 0.01)));
}

TEST(OutlineNodes, drop_cavities_below_a_triangle) {
  PlanarFace face = below({{0, 0}, {0.1, 0}});
  face.cavities = {{{0.05, 0.05}, {0.051, 0.05}, {0.051, 0.051}, {0.05, 0.051}},
                   {{0.02, 0.05}, {0.04, 0.05}, {0.04, 0.07}, {0.02, 0.07}}};
  EXPECT_EQ(respaced(face, frame, 0.01).cavities.size(), 1U);
}

/// A circle's arc by far too many nodes comes to a polygon of the spacing: area to second order.
TEST(OutlineNodes, cost_a_curved_surface_area_of_second_order) {
  Outline arc;
  arc.reserve(2001);
  for (int i = 0; i <= 2000; ++i) {
    const double t = std::numbers::pi * i / 2000;
    arc.emplace_back(0.05 - 0.05 * std::cos(t), 0.05 * std::sin(t));
  }
  arc.front().x() = 0.0;
  arc.back() = {frame.radius, 0.0};
  const PlanarFace fine = below(arc);
  for (const double spacing : {2e-3, 1e-3}) {
    const double lost = std::abs(area({respaced(fine, frame, spacing)}) - area({fine}));
    // chords of at most the widest spacing: sagitta two thirds of w^2 / (8 R), over the arc
    const double widest = widest_spacing * spacing;
    EXPECT_LE(lost, std::numbers::pi * widest * widest / 12.0);
    EXPECT_GT(lost, 0.0);
  }
}

/// Two edges that meet off the frame are together longer than half the widest spacing, and none is
/// longer than it.
RC_GTEST_PROP(OutlineNodes, stand_about_equally_far_apart, ()) {
  constexpr double spacing = 5e-3, widest = widest_spacing * spacing, rounding = 4e-9;
  const int corners = *rc::gen::inRange(2, 40);
  Outline line{{0.0, 0.0}};
  for (int i = 1; i < corners; ++i)
    line.emplace_back(frame.radius * i / corners, *battery::number(-0.01, 0.01));
  line.emplace_back(frame.radius, 0.0);
  const Outline even = respaced(below(line), frame, spacing).border;
  for (std::size_t i = 0; i < even.size(); ++i) {
    const std::size_t next = (i + 1) % even.size();
    if (is_on_frame(even[i]) && is_on_frame(even[next])) continue;
    RC_ASSERT(edge(even, i) <= widest + rounding);
    if (!is_on_frame(even[next]))
      RC_ASSERT(edge(even, i) + edge(even, next) > widest / 2.0 - rounding);
  }
}

}  // namespace tdbd::reference::outline_nodes_test
