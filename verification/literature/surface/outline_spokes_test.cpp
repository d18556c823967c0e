#include "reference/literature/surface/outline_spokes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/observed_order.hpp"
#include "reference/literature/surface/outline_nodes.hpp"
#include "reference/literature/surface/planar_boolean.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::reference::outline_spokes_test {

constexpr double pi = std::numbers::pi;

/// Rounding to the grid moves each edge by at most its length in metres times this, m2.
constexpr double on_the_grid = 2.0 * planar_grid;

Pose turned(double azimuth) {
  return {Eigen::AngleAxisd(azimuth, Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()};
}

/// A thin upright disc of so many corners in the half-plane y = 0, x > 0.
mesh::TriangleMesh disc_B(double radius, const Vec3& middle, int sides) {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = Vec3::UnitZ();
  X.R.col(2) = -Vec3::UnitY();
  X.p = middle;
  return battery::placed(X, battery::cylinder(radius, 1e-6, sides));
}

double polygon_area(double radius, int sides) {
  return sides / 2.0 * radius * radius * std::sin(2.0 * pi / sides);
}

/// A box over the axis: in each spoke a rectangle, of which the sector's volume is known.
TEST(OutlineSpokes, a_box_on_the_axis_leaves_its_section_in_every_spoke) {
  constexpr double half = 0.1, depth = 0.025;
  OutlineSpokes rock = flat_outline_spokes({0.2, 0.3}, 0.0, 16, 1e-3);
  const double before = volume(rock);
  const auto box = battery::box({-half, -half, -half}, {half, half, depth});
  const OutlineCut cut = cut_sweep(rock, {swept_body(box, {})}, {});
  double expected = 0.0;
  for (int k = 0; k < 16; ++k) {
    const SpokePlane plane = spoke_plane(k, 16);
    const double side = half / std::max(std::abs(plane.cosine), std::abs(plane.sine));
    expected += depth * side * side / 2.0 * 2.0 * pi / 16;
    EXPECT_NEAR(area({rock.rock[static_cast<std::size_t>(k)]}), 0.2 * 0.3 - depth * side,
                on_the_grid);
  }
  EXPECT_NEAR(cut.removed, expected, on_the_grid);
  EXPECT_NEAR(before - cut.removed + cut.respaced, volume(rock), 1e-12 * before);
}

/// Half of a disc in a flat rock: the half of a regular polygon, and nothing in other spokes.
TEST(OutlineSpokes, a_disc_in_the_plane_of_a_spoke_leaves_its_own_outline) {
  constexpr double a = 8e-3;
  OutlineSpokes rock = flat_outline_spokes({0.1, 0.1}, 0.0, 8, 0.2e-3);
  const PlanarFace untouched = rock.rock[1];
  const double before = area({rock.rock[0]});
  cut_sweep(rock, {swept_body(disc_B(a, Vec3(0.05, 0, 0), 64), {})}, {});
  // m2: corners rounded to the grid.
  EXPECT_NEAR(before - area({rock.rock[0]}), polygon_area(a, 64) / 2.0, 1.8e-12);
  EXPECT_EQ(rock.rock[1].border, untouched.border);
}

/// A step without turn sweeps the hull of both ends: a disc that goes 30 mm along its own plane.
TEST(OutlineSpokes, a_step_takes_all_between_its_ends) {
  constexpr double a = 8e-3, way = 30e-3;
  OutlineSpokes rock = flat_outline_spokes({0.1, 0.1}, 0.0, 8, 0.2e-3);
  const double before = area({rock.rock[0]});
  const SweptBody body =
      swept_body(disc_B(a, Vec3(0.07, 0, 0), 64), {Mat3::Identity(), Vec3(-way, 0, 0)});
  cut_sweep(rock, {body}, {});
  // m2: corners rounded to the grid.
  EXPECT_NEAR(before - area({rock.rock[0]}), polygon_area(a, 64) / 2.0 + way * a, 9e-13);
}

/// The cutter of `one_depth_for_each_node_takes_the_rock_above_an_undercut` (spokes_test): half a
/// disc out of an upright wall, 50 mm below its top.
TEST(OutlineSpokes, an_undercut_is_kept) {
  constexpr double r = 6.7e-3, below = 50e-3, wall = 0.1, spacing = 0.5e-3;
  OutlineSpokes rock = flat_outline_spokes({0.12, 0.2}, 0.0, 8, spacing);
  for (int k = 0; k < 8; ++k)  // the hole
    cut_spoke(rock, k, {{-1e-3, -1e-3}, {wall, -1e-3}, {wall, 0.15}, {-1e-3, 0.15}});
  const double before = area({rock.rock[0]});
  const auto disc = disc_B(r, Vec3(wall, 0, below), 256);
  cut_sweep(rock, {swept_body(disc, {})}, {});
  const double taken = before - area({rock.rock[0]}), half_disc = pi * r * r / 2.0;
  EXPECT_NEAR(taken, half_disc, 2e-3 * half_disc);
  EXPECT_TRUE(encloses(rock.rock[0], Vec2(wall + 1e-3, 0.02)));  // the rock above
  EXPECT_FALSE(encloses(rock.rock[0], Vec2(wall + 1e-3, below)));

  const Spokes seen = deepest(rock, 0.12, 24000);  // as one depth for each radius sees it
  double shadow = 0.0;
  for (int j = 0; j < seen.nodes; ++j)
    if (seen.node_radius(j) > wall)
      shadow += seen.depth[static_cast<std::size_t>(j)] * seen.node_spacing();
  EXPECT_NEAR(shadow / half_disc, 5.25, 0.02);
}

/// Rock cut off from the rest falls out with what cut it off.
TEST(OutlineSpokes, a_loose_chip_is_removed) {
  OutlineSpokes rock = flat_outline_spokes({0.1, 0.1}, 0.0, 4, 1e-3);
  const double before = area({rock.rock[0]});
  cut_spoke(rock, 0, {{0.06, -0.01}, {0.061, -0.01}, {0.061, 0.02}, {0.06, 0.02}});
  cut_spoke(rock, 0, {{0.04, 0.019}, {0.061, 0.019}, {0.061, 0.02}, {0.04, 0.02}});
  EXPECT_NEAR(before - area({rock.rock[0]}), 0.001 * 0.02 + 0.02 * 0.001, 1e-12 * before);
  cut_spoke(rock, 0, {{0.04, -0.01}, {0.041, -0.01}, {0.041, 0.02}, {0.04, 0.02}});
  EXPECT_NEAR(before - area({rock.rock[0]}), 0.021 * 0.02, 1e-12 * before);
}

TEST(OutlineSpokes, a_tool_within_the_rock_leaves_a_cavity) {
  OutlineSpokes rock = flat_outline_spokes({0.1, 0.1}, 0.0, 4, 1e-3);
  const double before = area({rock.rock[0]});
  const Outline box{{0.04, 0.04}, {0.06, 0.04}, {0.06, 0.05}, {0.04, 0.05}};
  cut_spoke(rock, 0, box);
  ASSERT_EQ(rock.rock[0].cavities.size(), 1U);
  EXPECT_NEAR(before - area({rock.rock[0]}), 0.02 * 0.01, 1e-12);
  EXPECT_EQ(cut_spoke(rock, 0, box).removed, 0.0);  // there is nothing left to cut
}

/// All steps' sections taken away at once are what they are one by one, as far as respacing changes
/// the rock between the steps.
TEST(OutlineSpokes, steps_may_be_taken_away_at_once) {
  constexpr double step = 2.0 * pi / 360, spacing = 0.05e-3;
  OutlineSpokes one_by_one = flat_outline_spokes({15e-3, 20e-3}, 0.0, 5, spacing),
                at_once = one_by_one;
  const auto bodies =
      swept_bodies({{0, {}, 0.0, disc_B(3e-3, Vec3(8e-3, 0, -1e-3), 64)}}, turned(-step));
  SpokeSections sections;
  double removed = 0.0, respaced = 0.0;
  for (int i = 0; i < 90; ++i) {
    const OutlineCut cut = cut_sweep(one_by_one, bodies, turned(i * step));
    removed += cut.removed;
    respaced += std::abs(cut.respaced);
    add_sections(sections, at_once, bodies, turned(i * step));
  }
  const OutlineCut cut = cut_sections(at_once, sections);
  EXPECT_GT(cut.removed, 0.0);
  EXPECT_NEAR(cut.removed, removed, respaced + 1e-15);
  EXPECT_TRUE(std::ranges::all_of(sections, [](const auto& s) { return s.empty(); }));
}

/// Discs from above, which leave a height field: both surfaces are the same to the spacing's
/// second order, and where the arcs end, upright, to the first.
TEST(OutlineSpokes, agree_with_langevelds_on_a_height_field) {
  constexpr double spacing = 0.05e-3;
  constexpr int spokes = 7;
  OutlineSpokes ours = flat_outline_spokes({15e-3, 20e-3}, 0.0, spokes, spacing);
  Spokes theirs = flat_spokes(15e-3, 0.0, spokes, 300);
  constexpr double step = 2.0 * pi / 360;
  for (int i = 0; i < 360; ++i)
    for (const double r : {6e-3, 10e-3}) {
      const auto disc = disc_B(3e-3, Vec3(r, 0, -2e-3 - 0.05 * r + 1e-6 * i), 128);
      const CutterHull hull{0, {}, 0.0, disc};
      cut_sweep(ours, swept_bodies({hull}, turned(-step)), turned(i * step));
      cut_sweep(theirs, ruled_tools({hull}, turned(-step)), turned(i * step));
    }
  const Spokes seen = deepest(ours, 15e-3, 300);
  double sum = 0.0, worst = 0.0;
  for (std::size_t n = 0; n < seen.depth.size(); ++n) {
    const double off = std::abs(seen.depth[n] - theirs.depth[n]);
    sum += off;
    worst = std::max(worst, off);
  }
  EXPECT_LE(sum / static_cast<double>(seen.depth.size()), 8e-4 * spacing);
  EXPECT_LE(worst, 0.55 * spacing);
}

const std::vector<int> spoke_counts{30, 60, 120, 240, 480};

std::vector<double> angles_between(const std::vector<int>& counts) {
  std::vector<double> angles;
  angles.reserve(counts.size());
  for (const int spokes : counts) angles.push_back(2.0 * pi / spokes);
  return angles;
}

/// Rock cut down to a tilted plane. Every spoke holds its line; between two of them depths are
/// linear in the angle where the plane's are a cosine: second order.
TEST(OutlineSpokes, see_a_tilted_plane_with_second_order_in_the_number_of_spokes) {
  constexpr double radius = 0.1, level = 20e-3, slope = 0.15;
  std::vector<double> errors;
  for (const int spokes : spoke_counts) {
    OutlineSpokes rock = flat_outline_spokes({radius, 60e-3}, 0.0, spokes, 2e-3);
    for (int k = 0; k < spokes; ++k) {
      const double down = slope * spoke_plane(k, spokes).cosine, r = 1.1 * radius;
      cut_spoke(rock, k, {{-r, -0.1}, {r, -0.1}, {r, level + down * r}, {-r, level - down * r}});
    }
    const Spokes seen = deepest(rock, radius, 500);
    double sum = 0.0;
    constexpr int samples = 3600;
    for (int i = 0; i < samples; ++i) {
      const double azimuth = 2.0 * pi * (i + 0.5) / samples, x = 0.08 * std::cos(azimuth);
      sum += std::abs(depth_at(seen, x, 0.08 * std::sin(azimuth)) - level - slope * x) / samples;
    }
    errors.push_back(sum);
  }
  EXPECT_NEAR(least_squares_order(angles_between(spoke_counts), errors), 2.0, 2e-4);
  EXPECT_LT(errors.back(), 2e-7);
}

/// A ball's dent beside the axis. Its sections shrink as the power 3/2 of the distance from the
/// rim, so that their sum over equal angles comes to the volume with the order 5/2, up or down as
/// the outermost spokes happen to lie.
TEST(OutlineSpokes, find_a_balls_volume_with_order_two_or_better_in_the_number_of_spokes) {
  constexpr double radius = 15e-3, under = 12e-3, centre = 40e-3;
  const Vec3 middle(centre, 0, under - radius);
  std::vector<double> errors;
  for (const int spokes : spoke_counts) {
    OutlineSpokes rock = flat_outline_spokes({60e-3, 20e-3}, 0.0, spokes, 0.2e-3);
    double removed = 0.0;
    for (int k = 0; k < spokes; ++k) {
      const SpokePlane plane = spoke_plane(k, spokes);
      const double square = radius * radius - std::pow(plane.beside(middle), 2);
      if (square <= 0.0 || plane.foot(middle).x() < 0.0) continue;
      Outline circle;
      circle.reserve(800);
      for (int i = 0; i < 800; ++i)
        circle.push_back(plane.foot(middle) +
                         std::sqrt(square) *
                             Vec2(std::cos(2.0 * pi * i / 800), std::sin(2.0 * pi * i / 800)));
      removed += cut_spoke(rock, k, circle).removed;
    }
    errors.push_back(std::abs(removed / (pi * under * under * (radius - under / 3.0)) - 1.0));
  }
  EXPECT_GE(least_squares_order(angles_between(spoke_counts), errors), 2.0);
  EXPECT_LT(errors.back(), 9.5e-5);
}

/// A spoke that is cut any number of times anywhere has the number of nodes that its length
/// requires, and the balance of volume closes.
RC_GTEST_PROP(OutlineSpokes, keep_their_nodes_few, ()) {
  constexpr double spacing = 2e-3;
  OutlineSpokes rock = flat_outline_spokes({0.1, 0.1}, 0.0, 1, spacing);
  const double before = volume(rock);
  OutlineCut sum;
  for (int i = 0; i < 12; ++i) {
    std::vector<Vec2> corners;
    const Vec2 middle(*battery::number(0.0, 0.1), *battery::number(-0.01, 0.05));
    for (int j = 0; j < 8; ++j)
      corners.push_back(middle +
                        Vec2(*battery::number(-0.01, 0.01), *battery::number(-0.01, 0.01)));
    const OutlineCut cut = cut_spoke(rock, 0, convex_outline(corners));
    RC_ASSERT(cut.removed >= 0.0);
    sum.removed += cut.removed;
    sum.respaced += cut.respaced;
    double length = 0.0;
    std::size_t nodes = 0;
    const auto measure = [&](const Outline& o) {
      nodes += o.size();
      for (std::size_t k = 0; k < o.size(); ++k) length += (o[(k + 1) % o.size()] - o[k]).norm();
    };
    measure(rock.rock[0].border);
    for (const Outline& cavity : rock.rock[0].cavities) measure(cavity);
    constexpr double corners_of_the_frame = 8;
    // wide: the bound that outline_nodes.hpp promises of any cuts
    RC_ASSERT(static_cast<double>(nodes) <=
              3.0 * length / (widest_spacing * spacing) + corners_of_the_frame);
  }
  RC_ASSERT(std::abs(before - sum.removed + sum.respaced - volume(rock)) <= 1e-12 * before);
}

}  // namespace tdbd::reference::outline_spokes_test

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
TEST(OutlineNodes, remove_the_node_of_least_error_first) {
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
TEST(OutlineNodes, lose_area_of_second_order_on_a_curved_surface) {
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
RC_GTEST_PROP(OutlineNodes, are_about_equally_spaced, ()) {
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
