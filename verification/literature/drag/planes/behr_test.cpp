#include "reference/literature/drag/planes/behr.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "battery/generators.hpp"
#include "core/error.hpp"
#include "literature/drag/planes/behr_runs.hpp"
#include "reference/literature/drag/plane/warren_sinor.hpp"

namespace tdbd::reference::behr_test {
namespace {

constexpr double pi = std::numbers::pi, mm = 1e-3, mm2 = 1e-6;

BehrOptions steady_options(int planes) {
  BehrOptions options;
  options.planes = planes;
  options.radius = example_gage;
  return options;
}

/// With the centre at rest and the same nodes, planes are the single plane: to rounding.
TEST(Behr, with_its_centre_at_rest_is_warren_and_sinors_plane) {
  const BitPath path = steady_path(example_speed, example_advance);
  for (const char letter : {'a', 'b', 'c'}) {
    const auto cutters = example_cutters(letter);
    BehrState state = behr_start(cutters, path(0.0), steady_options(72));
    behr_run(state, path, 0.0, 1e-3, 1500, rock_k(), steady_options(72));
    const BehrRun run = behr_run(state, path, 1.5, 1e-3, 500, rock_k(), steady_options(72));
    const WarrenSinorLoad plane = warren_sinor(
        cutters, example_advance, rock_k(),
        {.column = example_gage / 500 * (1 + 1e-9), .normal_ratio = {}, .flat_area = {}});
    constexpr double rounding = 1e-10;  // heights of 10 um out of depths of 50 mm
    for (std::size_t i = 0; i < cutters.size(); ++i)
      EXPECT_NEAR(run.mean_area(i), plane.cutters[i].area, rounding * plane.cutters[0].area)
          << letter << " " << i;
    constexpr double chord = 3e-8;  // when a tip crosses: on the chord of its way, not its arc
    EXPECT_NEAR(mean(run.weight), plane.weight, chord * plane.weight);
    EXPECT_NEAR(mean(run.torque), plane.torque, chord * plane.torque);
    EXPECT_NEAR(run.lateral_W.back().norm(), plane.imbalance_B().norm(),
                1e-6 * plane.weight);  // turns by 0.7 degrees in a step
    EXPECT_NEAR(run.removed(), plane.volume, rounding * plane.volume);
  }
}

/// Weight, torque, and the areas of a bit's cutters, as nodes at (k + offset) R/count show them.
struct OnNodes {
  double weight = 0.0, torque = 0.0;
  std::vector<double> area;
};

OnNodes on_nodes(const std::vector<bit::Cutter>& cutters, double count, double offset) {
  RadialOutlines o = radial_outlines(cutters, OutlineForm::planar, example_gage / count * 1.000001);
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    const RimEllipse e =
        rim_ellipse(cutter_rim(cutters[i], 0.0),
                    Vec3(std::cos(cutters[i].azimuth), std::sin(cutters[i].azimuth), 0.0));
    o.of_cutter[i].first = 0;
    o.of_cutter[i].depth.resize(o.columns + 1);
    for (std::size_t k = 0; k <= o.columns; ++k)
      o.of_cutter[i].depth[k] = depth_at(e, (static_cast<double>(k) + offset) * o.width);
  }
  ++o.columns;
  const PlanarCut cut = planar_cut(o, example_advance);
  OnNodes all{0.0, 0.0, cut.area};
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    all.weight += 80e6 * cut.area[i] * std::cos(cutters[i].profile_angle);
    for (std::size_t k = 0; k < o.columns; ++k)
      all.torque +=
          100e6 * cut.height[i][k] * o.width * (static_cast<double>(k) + offset) * o.width;
  }
  return all;
}

struct NodeErrors {
  double weight, torque, median, worst;  // of areas above 1 mm2
};

NodeErrors node_errors(double offset) {
  const auto cutters = example_cutters('a');
  const OnNodes exact = on_nodes(cutters, 10795, 0.5), coarse = on_nodes(cutters, 500, offset);
  std::vector<double> errors;
  for (std::size_t i = 0; i < cutters.size(); ++i)
    if (exact.area[i] > 1 * mm2) errors.push_back(std::abs(coarse.area[i] / exact.area[i] - 1.0));
  std::sort(errors.begin(), errors.end());
  return {std::abs(coarse.weight / exact.weight - 1.0),
          std::abs(coarse.torque / exact.torque - 1.0), errors[errors.size() / 2], errors.back()};
}

/// What 500 nodes on a plane cost against columns of 0.01 mm, bit A: at the centres of their cells,
/// as here, and from the axis on.
TEST(Behr, on_500_nodes_has_small_errors_but_in_thin_cuts) {
  const NodeErrors centres = node_errors(0.5), axis = node_errors(0.0);
  constexpr double hundredth = 1e-4;  // %: the last digit of what is known
  EXPECT_NEAR(centres.weight, 2 * hundredth, 0.5 * hundredth);
  EXPECT_LT(centres.torque, 0.5 * hundredth);
  EXPECT_NEAR(centres.median, 2 * hundredth, 0.5 * hundredth);
  EXPECT_NEAR(centres.worst, 0.043, 0.0005);
  EXPECT_NEAR(axis.weight, 10 * hundredth, 0.5 * hundredth);
  EXPECT_NEAR(axis.torque, 20 * hundredth, 0.5 * hundredth);
  EXPECT_NEAR(axis.worst, 0.031, 0.0005);
}

TEST(Behr, has_planes_far_apart_at_the_gage) {
  const auto spacing = [](int planes) {
    return spoke_spacing(flat_spokes(example_gage, 0.0, planes, 500), example_gage);
  };
  EXPECT_NEAR(spacing(72), 9.42 * mm, 0.005 * mm);
  EXPECT_NEAR(spacing(120), 5.65 * mm, 0.005 * mm);
  const double nodes = flat_spokes(example_gage, 0.0, 72, 500).node_spacing();
  EXPECT_NEAR(nodes, 0.216 * mm, 0.0005 * mm);
  EXPECT_NEAR(spacing(120) / nodes, 26.0, 0.5);
  EXPECT_NEAR(spacing(678), 1.0 * mm, 0.001 * mm);
}

bit::Cutter any_cutter() {
  bit::Cutter c;
  c.diameter = *battery::number(8.0, 25.0) * mm;
  c.tip_radius = *battery::number(10.0, 110.0) * mm;
  c.tip_height = *battery::number(-3.0, 20.0) * mm;
  c.azimuth = *battery::number(-7.0, 7.0);
  c.profile_angle = *battery::number(-0.5, 1.5);
  c.back_rake = *battery::number(0.0, 0.6);
  return c;
}

double depth_volume(const Spokes& rock) {
  double sum = 0.0;
  for (int k = 0; k < rock.spokes; ++k)
    for (int j = 0; j < rock.nodes; ++j)
      sum += rock.depth[at(k * rock.nodes + j)] * rock.node_radius(j);
  return sum * rock.node_spacing() * 2 * pi / rock.spokes;
}

/// Whatever the path: no node rises, and what is removed is what the bottom has lost.
RC_GTEST_PROP(Behr, removes_what_the_bottom_loses_on_any_path, ()) {
  std::vector<bit::Cutter> cutters(*rc::gen::inRange<std::size_t>(1, 5));
  for (bit::Cutter& c : cutters) c = any_cutter();
  BehrOptions options;
  options.planes = *battery::integer(1, 50);
  options.nodes = *battery::integer(1, 60);
  options.radius = 120 * mm;
  std::vector<BitPlace> places(1);
  for (int k = 0; k < 30; ++k) {
    BitPlace p = places.back();
    p.p_WB += *battery::point(3.0) * mm;
    p.angle += *battery::number(-0.1, 0.3);
    places.push_back(p);
  }
  BehrState state = behr_start(cutters, places.front(), options);
  const Spokes before = state.bottom;
  const BehrRun run = behr_run(state, places, 1e-3, rock_k(), options);
  for (std::size_t k = 0; k < before.depth.size(); ++k)
    RC_ASSERT(state.bottom.depth[k] >= before.depth[k]);
  const double lost = depth_volume(state.bottom) - depth_volume(before);
  RC_ASSERT(std::abs(run.removed() - lost) < 1e-13 * pi * 120 * 120 * 100 * mm * mm2);
}

/// A tip that goes round n times crosses every plane n times, and once each way when it returns.
RC_GTEST_PROP(Behr, crosses_each_plane_once_a_turn, ()) {
  const int planes = *battery::integer(1, 100), steps = *battery::integer(30, 200);
  BehrOptions options = steady_options(planes);
  options.nodes = 4;
  BehrState state = behr_start({any_cutter()}, {}, options);
  const BitPath there = steady_path(1.0, 1 * mm), back = steady_path(-1.0, 1 * mm);
  const double dt = 2 * pi * 3 / steps;
  const BehrRun run = behr_run(state, there, 0.0, dt, steps, rock_k(), options);
  RC_ASSERT(std::abs(run.cutters[0].crossings - 3 * planes) <= 1);
  RC_ASSERT(run.cutters[0].backward_crossings == 0);
  const int forward = run.cutters[0].crossings;
  const BehrRun other = behr_run(
      state, [&](double t) { return there(6 * pi - t); }, 0.0, dt, steps, rock_k(), options);
  RC_ASSERT(other.cutters[0].crossings == other.cutters[0].backward_crossings);
  RC_ASSERT(std::abs(other.cutters[0].crossings - forward) <= 1);
}

/// A whirl of 144 Hz in steps of 1 ms: the path's formula is followed between steps, as a dense
/// record of it would be.
TEST(Behr, follows_a_formula_between_steps_and_a_record_from_place_to_place) {
  const RollingWhirl whirl{example_gage, 1.5 * mm, example_speed};
  const BitPath path = whirl_path(whirl, example_advance);
  BehrOptions options = steady_options(72);
  options.radius = whirl.hole_radius();
  std::vector<BitPlace> places;
  for (int k = 0; k <= 5000; ++k) places.push_back(path(k * 2e-5));
  BehrState one = behr_start(example_cutters('b'), path(0.0), options), two = one;
  const BehrRun a = behr_run(one, path, 0.0, 1e-3, 100, rock_k(), options),
                b = behr_run(two, places, 2e-5, rock_k(), options);
  EXPECT_NEAR(a.removed(), b.removed(), 1e-3 * b.removed());
  EXPECT_NEAR(a.backward_share(), b.backward_share(), 1e-3);
  EXPECT_EQ(one.place.angle, two.place.angle);
}

/// The bit starts on a bottom that it touches all round, wherever it is.
TEST(Behr, starts_on_a_bottom_that_it_touches) {
  const auto cutters = example_cutters('b');
  BitPlace deep;
  deep.p_WB.z() = 7.0;
  const BehrState top = behr_start(cutters, {}, steady_options(3)),
                  low = behr_start(cutters, deep, steady_options(3));
  double deepest = no_depth, lowest_tip = no_depth;
  for (const double z : top.bottom.depth) deepest = std::max(deepest, z);
  for (const bit::Cutter& c : cutters) lowest_tip = std::max(lowest_tip, -c.tip_height);
  EXPECT_NEAR(deepest, lowest_tip, 0.05 * mm);  // an inclined rim is deeper than its tip
  for (std::size_t k = 0; k < top.bottom.depth.size(); ++k)
    EXPECT_NEAR(low.bottom.depth[k], top.bottom.depth[k] + 7.0, 1e-14);
}

/// Same case, same bytes.
TEST(Behr, does_the_same_again) {
  const BitPath path = whirl_path({example_gage, 1.5 * mm, example_speed}, example_advance);
  BehrOptions options = steady_options(72);
  BehrState one = behr_start(example_cutters('b'), path(0.0), options), two = one;
  const BehrRun a = behr_run(one, path, 0.0, 1e-3, 100, rock_k(), options),
                b = behr_run(two, path, 0.0, 1e-3, 100, rock_k(), options);
  EXPECT_EQ(a.weight, b.weight);
  EXPECT_EQ(one.bottom.depth, two.bottom.depth);
}

/// Two cutters on one radius, a tenth of a degree apart: the one ahead leaves the other a tenth of a
/// degree's sinking, though both cross a plane in one way, and whichever the table has first.
TEST(Behr, cuts_in_the_order_in_which_cutters_come) {
  bit::Cutter c;
  c.diameter = 16 * mm;
  c.tip_radius = 50 * mm;
  const double behind = pi / 1800;
  for (const std::size_t first : {0u, 1u}) {
    std::vector<bit::Cutter> cutters(2, c);
    cutters[first].azimuth = behind;
    const BitPath path = steady_path(example_speed, example_advance);
    BehrState state = behr_start(cutters, path(0.0), steady_options(72));
    behr_run(state, path, 0.0, 1e-3, 1000, rock_k(), steady_options(72));
    const BehrRun run = behr_run(state, path, 1.0, 1e-3, 500, rock_k(), steady_options(72));
    const double all = run.mean_area(0) + run.mean_area(1);
    EXPECT_NEAR(run.mean_area(1 - first), behind / (2 * pi) * all, 1e-9 * all) << first;
  }
}

/// A cutter that is dragged along +y at x = 80 mm by a bit whose axis is at x = 30 mm.
TEST(Behr, has_its_torque_about_the_bits_axis) {
  bit::Cutter c;
  c.diameter = 16 * mm;
  c.tip_radius = 50 * mm;
  const BitPath drag = [](double t) { return BitPlace{Vec3(30 * mm, 0.1 * t, 0.0), 0.0}; };
  DragRock rock = rock_k();
  rock.normal_ratio = 0.0;
  BehrState state = behr_start({c}, drag(0.0), steady_options(360));
  for (double& depth : state.bottom.depth) depth = -1 * mm;
  const BehrRun run = behr_run(state, drag, 0.0, 1e-3, 100, rock, steady_options(360));
  EXPECT_GT(run.torque.back(), 0.0);
  EXPECT_NEAR(run.torque.back(), -50 * mm * run.lateral_W.back().y(),
              1 * mm * -run.lateral_W.back().y());
  EXPECT_NEAR(run.cutters[0].force.cutting, run.cutters[0].force_W.norm(), 1e-9);
}

/// A face that goes backwards cuts nothing: without stress on what rubs, no force at all.
TEST(Behr, does_not_cut_with_the_back_of_a_face) {
  const BitPath back = [](double t) { return BitPlace{Vec3(0.0, 0.0, 2e-3 * t), -t}; };
  DragRock rock = rock_k();
  const BehrOptions options = steady_options(72);
  const auto weights = [&] {
    BehrState state = behr_start(example_cutters('b'), back(0.0), options);
    return behr_run(state, back, 0.0, 0.01, 100, rock, options);
  };
  const BehrRun sharp = weights();
  EXPECT_EQ(mean(sharp.weight), 0.0);
  EXPECT_EQ(sharp.backward_share(), 1.0);
  EXPECT_GT(sharp.removed(), 0.0);
  rock.contact_stress = 60e6;
  rock.friction = 0.5;
  const BehrRun rubbed = weights();
  EXPECT_GT(mean(rubbed.weight), 0.0);
  EXPECT_LT(mean(rubbed.torque), 0.0);  // friction is against the turn
}

/// The work of the cutting forces is eps times the volume that faces cut, if each crossing counts
/// for its own time: to rounding with the centre at rest.
TEST(Behr, does_the_work_of_cutting_on_the_way_from_plane_to_plane) {
  const BitPath path = steady_path(example_speed, example_advance);
  BehrOptions options = steady_options(120);
  options.force_time = ForceTime::crossing;
  BehrState state = behr_start(example_cutters('b'), path(0.0), options);
  const BehrRun run = behr_run(state, path, 0.0, 1e-3, 3000, rock_k(), options);
  const double work = mean(run.torque) * example_speed * 3.0;
  EXPECT_NEAR(work, 100e6 * run.removed(), 1e-9 * work);
}

/// In whirl, too, where the lateral force does most of it. There the force acts at the cut's arm,
/// its time is the tip's.
TEST(Behr, does_the_work_of_cutting_in_whirl) {
  const RollingWhirl whirl{example_gage, 3 * mm, example_speed};
  const BitPath path = whirl_path(whirl, example_advance);
  BehrOptions options;
  options.planes = 240;
  options.radius = whirl.hole_radius();
  options.force_time = ForceTime::crossing;
  DragRock rock = rock_k();
  rock.normal_ratio = 0.0;
  BehrState state = behr_start(example_cutters('b'), path(0.0), options);
  constexpr int steps = 8000;
  const double dt = 0.5 / steps;
  const BehrRun run = behr_run(state, path, 0.0, dt, steps, rock, options);
  double work = 0.0, turning = 0.0, rubbed = 0.0;
  for (int k = 0; k < steps; ++k) {
    const Vec3 way = path((k + 1) * dt).p_WB - path(k * dt).p_WB;
    turning += run.torque[at(k)] * example_speed * dt;
    work -= run.lateral_W[at(k)].dot(way.head<2>());
  }
  work += turning;
  for (const BehrCutter& c : run.cutters) rubbed += c.rubbed_volume;
  EXPECT_NEAR(work, 100e6 * (run.removed() - rubbed), 0.02 * work);
  EXPECT_LT(turning, 0.5 * work);
  RecordProperty("ratio", std::to_string(work / (100e6 * (run.removed() - rubbed))));
  RecordProperty("turning", std::to_string(turning / work));
  RecordProperty("rubbed", std::to_string(rubbed / run.removed()));
}

TEST(Behr, rejects_missing_input) {
  const BehrOptions options = steady_options(72);
  try {
    behr_start({}, {}, options);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "Behr et al.: found a bit without cutters, expected at least one cutter");
  }
  BehrOptions wrong = options;
  wrong.planes = 0;
  EXPECT_THROW(behr_start(example_cutters('a'), {}, wrong), InputError);
  wrong = BehrOptions{};
  EXPECT_THROW(behr_start(example_cutters('a'), {}, wrong), InputError);
  BehrState state = behr_start(example_cutters('a'), {}, options);
  EXPECT_THROW(behr_run(state, std::vector<BitPlace>(1), 1e-3, rock_k(), options), InputError);
  EXPECT_THROW(behr_run(state, steady_path(1.0, 0.0), 0.0, 0.0, 1, rock_k(), options), InputError);
}

}  // namespace
}  // namespace tdbd::reference::behr_test
