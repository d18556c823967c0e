#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bit/body/blade_body.hpp"
#include "bit/cutter/cutter_frame.hpp"
#include "bit/generate_design.hpp"

namespace tdbd::bit::blade_problems_test {
namespace {

constexpr double gage_radius = 107.95e-3;  ///< m

std::vector<Cutter> plain() { return lay_out(plain_design()).cutters; }

/// All problems, "key: found, expected" each on a line.
std::string problems_of(const std::vector<Cutter>& cutters, const BladeOptions& options,
                        double gage = gage_radius) {
  std::string all;
  for (const BladeProblem& p : blade_problems(cutters, options, gage))
    all += (all.empty() ? "" : "\n") + p.key + ": " + p.found + ", " + p.expected;
  return all;
}

/// With a back rake of 60 degrees half the diameter of 16 mm stands on the blade: 8 mm, and its under-exposure.
TEST(BladeProblems, keep_every_cutter_on_its_blade) {
  std::vector<Cutter> cutters = plain();
  Cutter& c = cutters[3];
  c.diameter = 16e-3;
  c.back_rake = 60 * degree;
  c.under_exposure = 0.5e-3;
  EXPECT_EQ(problems_of(cutters, {.exposure = 8.499e-3}).find("exposure"), std::string::npos);
  EXPECT_EQ(
      problems_of(cutters, {.exposure = 8.501e-3}),
      fmt::format("exposure: 8.501 mm, which lifts cutter {} (blade {}, radius {:.6g} mm) off "
                  "its blade, less than 8.5 mm",
                  c.id, c.blade, 1e3 * c.tip_radius));
}

/// What wear and under-exposure take from a tip is not outside the blade.
TEST(BladeProblems, leave_something_of_every_cutter_outside) {
  std::vector<Cutter> cutters = plain();
  Cutter& c = cutters[3];
  c.wear = 1.5e-3;
  c.under_exposure = 1e-3;
  EXPECT_EQ(problems_of(cutters, {.exposure = 2.501e-3}).find("exposure"), std::string::npos);
  EXPECT_EQ(problems_of(cutters, {.exposure = 2.499e-3}),
            fmt::format("exposure: 2.499 mm, which leaves nothing of cutter {} (blade {}, radius "
                        "{:.6g} mm) outside the blade: wear 1.5 mm, under-exposure 1 mm, more than "
                        "2.5 mm",
                        c.id, c.blade, 1e3 * c.tip_radius));
  for (Cutter& each : cutters) {
    each.wear = 0.0;
    each.under_exposure = 0.25;  // what is left is 0, exactly
  }
  EXPECT_EQ(problems_of(cutters, {.exposure = 0.25}).find("exposure: 250 mm, which leaves nothing"),
            0U);
}

/// The floor on the gage must leave 0.3 of the gage radius: of a larger gage than the cutters' the slots may be
/// as deep as this leaves.
TEST(BladeProblems, leave_a_core) {
  const BladeOptions shallow{.exposure = 5e-3, .slot_depth = 10e-3};
  const double top = blade_shape(plain(), shallow).meridian.back().top.r;
  const double gage = (top - 12.3456e-3) / 0.3;
  BladeOptions options = shallow;
  options.slot_depth = 12.345e-3;
  EXPECT_EQ(problems_of(plain(), options, gage), "");
  options.slot_depth = 12.346e-3;
  EXPECT_EQ(problems_of(plain(), options, gage),
            fmt::format("slot_depth: 12.346 mm, slots that leave no core: a floor at radius {:.6g} "
                        "mm on the gage, at most 12.34 mm",
                        1e3 * (top - 12.346e-3)));
}

/// A blade may end half a cutter's length before the end of the cutter that trails most.
TEST(BladeProblems, keep_half_of_every_cutter_on_its_blade) {
  const std::vector<Cutter> cutters = plain();
  const BladeShape shape = blade_shape(cutters, {.width = 20e-3});
  double needed = 0.0;
  const Cutter* worst = nullptr;
  for (const Cutter& c : cutters)
    for (const BladeStrip& blade : shape.blades) {
      if (blade.blade != c.blade) continue;
      const Vec3 end_B = c.X_BC * Vec3(-c.length, 0.0, 0.0);
      const double front = front_at(blade, place_of(shape, c));
      const double behind =
          Vec3(std::sin(front), -std::cos(front), 0.0).dot(end_B) - c.length / 2.0;
      if (behind > needed) worst = &c;
      needed = std::max(needed, behind);
    }
  EXPECT_EQ(problems_of(cutters, {.width = needed + 1e-9}), "");
  EXPECT_EQ(problems_of(cutters, {.width = needed - 1e-9}),
            fmt::format("width: {0:.6g} mm, a blade that ends before cutter {1} (blade {2}, radius "
                        "{3:.6g} mm), at least {0:.6g} mm",
                        1e3 * needed, worst->id, worst->blade, 1e3 * worst->tip_radius));
}

/// Six blades every 60 degrees: at the gage there is room for a blade and the walls of the slot behind it.
TEST(BladeProblems, leave_slots_between_blades) {
  const std::vector<Cutter> cutters = plain();
  const BladeShape shape = blade_shape(cutters, {});
  const double s = shape.meridian.back().s, top = shape.meridian.back().top.r;
  double least = 1e9;
  for (std::size_t k = 0; k < shape.blades.size(); ++k) {
    const BladeStrip &a = shape.blades[k], &b = shape.blades[(k + 1) % shape.blades.size()];
    double gap = front_at(b, s) - front_at(a, s);
    if (gap < 0.0) gap += 2.0 * pi;
    least = std::min(least, gap * top);
  }
  const double width = least - 2.0 * 4e-3;
  EXPECT_EQ(problems_of(cutters, {.width = width - 1e-9, .wall = 4e-3}), "");
  const std::string why = problems_of(cutters, {.width = width + 1e-9, .wall = 4e-3});
  EXPECT_NE(why.find(fmt::format("that close the slot between them at radius {:.6g} mm: {:.6g} mm "
                                 "from front to front, more than the width {:.6g} mm and two walls "
                                 "of 4 mm",
                                 1e3 * top, 1e3 * least, 1e3 * width)),
            std::string::npos)
      << why;
  EXPECT_EQ(why.find("width: blades "), 0U) << why;
}

/// Two blades of which one overtakes the other on its way out.
TEST(BladeProblems, keep_blades_one_behind_the_other) {
  std::vector<Cutter> cutters;
  for (const auto& [blade, radius, azimuth] :
       {std::tuple(1, 0.03, 0.0), {1, 0.09, 0.0}, {2, 0.031, 0.6}, {2, 0.091, -0.6}}) {
    Cutter c;
    c.id = static_cast<int>(cutters.size()) + 1;
    c.blade = blade;
    c.diameter = 16e-3;
    c.length = 13e-3;
    c.tip_radius = radius;
    c.tip_height = radius * radius * 2.0;
    c.profile_angle = std::atan(radius * 4.0);
    c.azimuth = azimuth;
    c.X_BC = cutter_pose(c);
    cutters.push_back(c);
  }
  const std::string why = problems_of(cutters, {.exposure = 3e-3, .slot_depth = 5e-3});
  EXPECT_NE(why.find("width: blades 2 and 1 that cross at radius "), std::string::npos) << why;
  EXPECT_NE(why.find(" from front to front, blades one behind the other"), std::string::npos)
      << why;
  for (Cutter& c : cutters)
    if (c.blade == 2) c.azimuth = 0.6;
  EXPECT_EQ(problems_of(cutters, {.exposure = 3e-3, .slot_depth = 5e-3}).find("cross"),
            std::string::npos);
}

}  // namespace
}  // namespace tdbd::bit::blade_problems_test
