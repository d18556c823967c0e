#include <gtest/gtest.h>

#include "calibration/cuts/cut_run.hpp"
#include "calibration/fit/problem.hpp"
#include "forces/generate.hpp"
#include "forces/laws/laws.hpp"
#include "reference/forces/groove_by_strips.hpp"

namespace tdbd::calibration::groove_cut_test {
namespace {

/// No rake is nearly 0: the angle between face and motion loses digits there.
SingleCutter any_cutter() {
  return {.diameter = forces::number(8e-3, 25e-3),
          .back_rake = forces::number(0.05, 0.7),
          .wear_flat = forces::number(0.0, 20e-6),
          .chamfer = forces::number(0.1e-3, 1e-3)};
}

double any_depth(const SingleCutter& c) {
  return forces::number(0.01, 0.9) * c.diameter * std::cos(c.back_rake);
}

/// Strips of a half circle's end are off by their width to the power 1.5.
RC_GTEST_PROP(GrooveCut, its_area_is_that_of_strips, ()) {
  const SingleCutter c = any_cutter();
  const double depth = any_depth(c);
  const CutRun run = groove_cut(c, depth);
  const double strips = reference::groove_area_by_strips(c.diameter, c.back_rake, depth, 2000);
  const double area = run.cuts[0].face_area * run.cuts[0].forward_W.x();
  RC_ASSERT(std::abs(area - strips) < 1e-5 * c.diameter * c.diameter);
}

/// Length of the rim in the rock, point by point about the face.
double rim_by_points(const SingleCutter& c, double depth) {
  constexpr int points = 20000;
  int inside = 0;
  for (int i = 0; i < points; ++i) {
    const double turn = 2 * pi * (i + 0.5) / points;
    const double below_top = 0.5 * c.diameter * (1.0 + std::cos(turn)) * std::cos(c.back_rake);
    if (below_top < depth) ++inside;
  }
  return pi * c.diameter * inside / points;
}

RC_GTEST_PROP(GrooveCut, its_edge_is_the_rim_in_the_rock, ()) {
  const SingleCutter c = any_cutter();
  const double depth = any_depth(c);
  constexpr double two_points = 1e-4;
  RC_ASSERT(std::abs(groove_cut(c, depth).cuts[0].cut.engaged_edge - rim_by_points(c, depth)) <
            two_points * pi * c.diameter);
}

forces::HansonHansen known_law() {
  forces::HansonHansen law;
  law.A1 = 1.2;
  law.A2 = 0.4;
  law.A3 = 0.3;
  law.A4 = 0.5;
  law.A5 = 0.9;
  law.A6 = 0.35;
  law.slip_speed = 0.0;
  return law;
}

Record slow_test(double depth) {
  Record r;
  r.speed = 0.5;
  r.depth = depth;
  return r;
}

/// The loads of forces (6), written out.
RC_GTEST_PROP(GrooveCut, its_loads_are_those_of_the_law, ()) {
  const SingleCutter c = any_cutter();
  const double depth = any_depth(c);
  const CutRun run = groove_cut(c, depth);
  const forces::HansonHansen law = known_law();
  const forces::Strength rock{.unconfined = 50e6, .confined = 80e6};
  const Loads loads = mean_loads(law, sample_of(run, slow_test(depth), rock, law));
  const double area = forces::groove_area({c.diameter, c.back_rake}, depth);
  const double rim = run.cuts[0].cut.engaged_edge, pressed = c.wear_flat + c.chamfer * rim;
  const double Ft =
      80e6 * (law.A1 * (1 + law.A2 * std::tan(c.back_rake)) * area + law.A4 * law.te * rim);
  const double Fn = 80e6 * law.A5 * pressed;
  constexpr double rounding = 1e-13;
  RC_ASSERT(std::abs(loads[axial] / (std::tan(c.back_rake + law.A3) * Ft + Fn) - 1) < rounding);
  RC_ASSERT(std::abs(loads[turning] / (Ft + law.A6 * Fn) - 1) < rounding);
}

TEST(GrooveCut, of_a_sharp_cutter_has_a_face_alone) {
  const CutRun run = groove_cut({.diameter = 13e-3, .back_rake = 0.3}, 1e-3);
  EXPECT_EQ(run.cuts.size(), 1u);
  EXPECT_EQ(run.cuts[0].cut.kind, bit::PartKind::face);
}

/// What is left between the groove and the face's rim raised by what does not chip off, in columns.
TEST(GrooveCut, is_less_what_chips_off_ahead) {
  const SingleCutter c{.diameter = 13e-3, .back_rake = 0.3};
  constexpr double depth = 2e-3, share = 0.4, radius = 6.5e-3;
  const double in_face = depth / std::cos(c.back_rake), raised = (1.0 - share) * in_face;
  double area = 0.0;
  constexpr int columns = 200000;
  for (int i = 0; i < columns; ++i) {
    const double y = radius * (2.0 * (i + 0.5) / columns - 1.0);
    const double rim = radius - std::sqrt(radius * radius - y * y);
    area += std::max(0.0, std::min(in_face, rim + raised) - rim) * 2.0 * radius / columns;
  }
  const CutRun whole = groove_cut(c, depth), left = groove_cut(c, depth, share);
  EXPECT_NEAR(left.cuts[0].face_area / area, 1.0, 1e-9);
  EXPECT_EQ(left.cuts[0].cut.engaged_edge, whole.cuts[0].cut.engaged_edge);
  EXPECT_LT(left.cuts[0].face_area, whole.cuts[0].face_area);
}

/// The input of a law includes the diameter of a part, for face and flat.
TEST(GrooveCut, identifies_the_diameter_of_the_cutter) {
  const CutRun run = groove_cut({.diameter = 13e-3, .back_rake = 0.3, .wear_flat = 1e-6}, 1e-3);
  ASSERT_EQ(run.cuts.size(), 2U);
  for (const auto& cut : run.cuts) EXPECT_EQ(cut.cut.diameter, 13e-3);
}

}  // namespace
}  // namespace tdbd::calibration::groove_cut_test
