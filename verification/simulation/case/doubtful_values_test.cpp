#include "simulation/case/doubtful_values.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "verification/battery/shapes.hpp"

namespace tdbd::simulation::doubtful_values_test {

std::vector<CaseWarning> doubts(const std::string& name, const std::vector<std::string>& settings) {
  return read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", settings).warnings;
}

/// Bit B has cutters of 19 mm, worn by 0.6 mm, on a gage of 8.5 in.
TEST(DoubtfulValues, are_edges_longer_than_half_of_a_cutter) {
  EXPECT_TRUE(doubts("bit-b-steady", {"rock.edge_length=9 mm"}).empty());
  for (const std::string edge : {"10 mm", "50 mm"}) {
    const auto warnings = doubts("bit-b-steady", {"rock.edge_length=" + edge});
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].key, "rock.edge_length");
    EXPECT_EQ(warnings[0].place, "--set: rock.edge_length");
    EXPECT_TRUE(
        warnings[0].text.starts_with("edges of " + edge + " do not resolve the cuts of a part 1"))
        << warnings[0].text;
  }
}

TEST(DoubtfulValues, are_edges_longer_than_half_of_a_tooth) {
  EXPECT_TRUE(doubts("bit-r-steady", {"rock.edge_length=4 mm"}).empty());
  EXPECT_EQ(doubts("bit-r-steady", {"rock.edge_length=8 mm"}).size(), 1u);
}

TEST(DoubtfulValues, are_edges_that_are_coarse_for_the_forces_on_teeth) {
  EXPECT_TRUE(doubts("drill-bit-r", {"rock.edge_length=1.5 mm"}).empty());
  const auto warnings = doubts("drill-bit-r", {"rock.edge_length=3 mm"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "rock.edge_length");
  EXPECT_TRUE(warnings[0].text.starts_with("edges of 3 mm are coarse for the forces on a tooth "))
      << warnings[0].text;
  EXPECT_TRUE(doubts("bit-r-steady", {"rock.edge_length=3 mm"}).empty());  // no forces
}

TEST(DoubtfulValues, are_sections_nearer_than_the_longest_edge) {
  EXPECT_TRUE(doubts("bit-b-steady", {"maintenance.longest_edge=1.7"}).empty());
  EXPECT_TRUE(doubts("bit-r-steady", {"measure.section_lead=1.2"}).empty());  // no faces
  const auto warnings = doubts("bit-b-steady", {"measure.section_lead=1.2"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "measure.section_lead");
  EXPECT_EQ(warnings[0].text,
            "sections 1.2 edge lengths ahead are too small where edges are up to 1.6 edge lengths "
            "long (maintenance.longest_edge): found 1.2, expected at least 1.6");
  EXPECT_EQ(doubts("bit-b-steady", {"maintenance.longest_edge=2"}).size(), 1u);
}

/// The shipped step of 0.5 ms is short enough; the ring's clearance is 3 mm.
TEST(DoubtfulValues, are_steps_that_are_long_for_a_rolling_bit) {
  EXPECT_TRUE(doubts("drill-bit-b-whirl", {}).empty());
  const auto warnings = doubts("drill-bit-b-whirl", {"wall.clearance=2 mm"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "time.step");
  EXPECT_EQ(warnings[0].text,
            "a bit that rolls around this wall whirls at 108 Hz, 0.34 rad in a step; rates of a "
            "whirling bit are accurate with at most 0.25 rad: 0.37 ms");
  EXPECT_TRUE(doubts("drill-bit-b-whirl", {"wall.clearance=2 mm", "wall.friction=0"}).empty());
}

/// 300 kg of string and a bit on a wall of 1e8 N/m: a touch lasts 6 ms.
TEST(DoubtfulValues, are_steps_that_are_long_for_an_impact_on_the_wall) {
  const auto warnings = doubts("drill-bit-b-whirl", {"wall.friction=0", "time.step=0.7 ms"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "time.step");
  EXPECT_TRUE(warnings[0].text.starts_with("the bit's impact on the wall lasts "))
      << warnings[0].text;
  EXPECT_TRUE(
      doubts("drill-bit-b-whirl", {"wall.stiffness=1e7", "wall.friction=0", "time.step=0.7 ms"})
          .empty());
}

/// The middle one of a part's three sizes; what does not cut, or has no mesh yet, has no say.
TEST(NarrowestWidth, is_that_of_the_narrowest_part_that_cuts) {
  bit::Bit b;
  EXPECT_EQ(narrowest_width(b), 0.0);
  const auto add = [&](const Vec3& size, bit::Cutting cutting) {
    bit::Part& part = b.parts.emplace_back();
    part.cutting = cutting;
    if (size.x() > 0.0) part.mesh_P = battery::box(Vec3::Zero(), size);
  };
  add({1e-3, 2e-3, 3e-3}, bit::Cutting::never);
  EXPECT_EQ(narrowest_width(b), 0.0);
  add({30e-3, 10e-3, 20e-3}, bit::Cutting::cuts);
  add(Vec3::Zero(), bit::Cutting::cuts);
  add({25e-3, 40e-3, 50e-3}, bit::Cutting::cuts);
  EXPECT_EQ(narrowest_width(b), 20e-3);
}

TEST(DoubtfulValues, are_weights_that_break_teeth) {
  EXPECT_TRUE(doubts("drill-bit-b", {"motion.weight_on_bit=84 klbf"}).empty());
  const auto warnings = doubts("drill-bit-b", {"motion.weight_on_bit=1.5 MN"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "motion.weight_on_bit");
  EXPECT_EQ(warnings[0].text,
            "1500 kN on a bit of 215.9 mm: teeth break at 378 kN (10 klbf per inch of diameter)");
}

/// Bit B and its string weigh 10.18 kN; its centre of mass is 126.6 mm above its nose.
TEST(DoubtfulValues, are_attachments_at_which_a_bit_off_bottom_topples) {
  const auto with = [](const std::string& height, const std::string& weight,
                       const std::string& bending) {
    return doubts("drill-bit-b",
                  {"string.attachment_height=" + height, "motion.weight_on_bit=" + weight,
                   "string.bending_stiffness=" + bending});
  };
  EXPECT_TRUE(with("0 mm", "0 kN", "1300").empty());
  const auto hanging = with("0 mm", "0 kN", "1060");
  ASSERT_EQ(hanging.size(), 1u);
  EXPECT_EQ(hanging[0].key, "string.attachment_height");
  EXPECT_EQ(
      hanging[0].text,
      "off bottom the bit topples: the string holds it with 1.018e+04 N at a point 126.6 mm "
      "below its centre of mass; found a bending stiffness of 1060 N m/rad, expected more than "
      "1290 N m/rad, or the default height");
  EXPECT_TRUE(with("0 mm", "10.3 kN", "0").empty());  // the load exceeds the weight
  EXPECT_TRUE(with("200 mm", "0 kN", "0").empty());
  const auto pushed = with("200 mm", "20 kN", "0");
  ASSERT_EQ(pushed.size(), 1u);
  EXPECT_NE(pushed[0].text.find("the string pushes it with 9816 N at a point 73.37 mm above"),
            std::string::npos)
      << pushed[0].text;
}

TEST(DoubtfulValues, are_attachments_below_the_centre_of_mass_on_an_axial_spring) {
  const std::vector<std::string> lowered{
      "motion={kind='drilling', rotary_speed=10, rate_of_penetration=0.01}",
      "string.bending_stiffness=0", "string.axial_stiffness=1e6"};
  const auto with = [&](const std::string& more) {
    std::vector<std::string> settings = lowered;
    settings.push_back(more);
    return doubts("drill-bit-b", settings).size();
  };
  EXPECT_EQ(with("string.attachment_height=120 mm"), 1u);
  EXPECT_EQ(with("string.attachment_height=130 mm"), 0u);
  EXPECT_EQ(with("string.gravity=0"), 0u);
}

/// The heaviest of a schedule counts.
TEST(DoubtfulValues, are_found_in_schedules) {
  EXPECT_TRUE(doubts("laboratory", {}).empty());
  EXPECT_EQ(doubts("laboratory", {"motion.weight_on_bit.values=[10e3, 2e6, 10e3]"}).size(), 1u);
}

/// Bit B at 120 rpm: five blades pass at 10 Hz. Its gage stands for the hole.
TEST(DoubtfulValues, of_a_chain_are_buckling_in_the_hole_that_the_bit_drills) {
  const std::vector<std::string> inclined{
      "string.survey={measured_depth=[0, 2500], inclination=[1, 1], azimuth=[0, 0]}"};
  EXPECT_TRUE(doubts("string-drill-bit-b", inclined).empty());
  std::vector<std::string> heavy = inclined;
  heavy.emplace_back("motion.weight_at_start='700 kN'");
  const auto warnings = doubts("string-drill-bit-b", heavy);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "string.model");
  EXPECT_TRUE(warnings[0].text.starts_with("drill: compressed with ")) << warnings[0].text;
  // The drill pipe above the collars, 127 mm by 108.6 mm with tool joints of 168.2 mm, in a hole of 215.9 mm.
  const double inertia = std::numbers::pi / 64.0 * (std::pow(0.127, 4) - std::pow(0.1086, 4));
  const double weight = 9.80665 * (7850.0 - 1200.0) * std::numbers::pi / 4.0 *
                        (std::pow(0.127, 2) - std::pow(0.1086, 2));
  const double limit =
      2.0 * std::sqrt(206e9 * inertia * weight * std::sin(1.0) / (0.5 * (0.2159 - 0.1682)));
  EXPECT_NE(warnings[0].text.find(fmt::format("sinusoidal buckling at {:.3g} kN", 1e-3 * limit)),
            std::string::npos)
      << warnings[0].text;
  heavy.emplace_back("string.hole_diameter='8.5 in'");
  const auto given = doubts("string-drill-bit-b", heavy);
  ASSERT_EQ(given.size(), 1u);
  EXPECT_EQ(given[0].key, "string.hole_diameter");
  EXPECT_EQ(given[0].text, warnings[0].text);
}

TEST(DoubtfulValues, of_a_chain_are_elements_too_long_for_the_passing_blades) {
  EXPECT_TRUE(doubts("string-drill-bit-b", {}).empty());
  const auto warnings = doubts("string-drill-bit-b", {"string.element_length=50"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "string.element_length");
  EXPECT_EQ(
      warnings[0].text,
      "elements of 50 m resolve waves up to 6.36 Hz, 10 elements to a wavelength; the blades of "
      "the bit pass at 10 Hz: use at most 31.8 m");
}

TEST(DoubtfulValues, of_a_chain_are_sections_ahead_of_the_faces) {
  const auto warnings = doubts("string-drill-bit-b", {"measure.section_at_face='as_ahead'"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "measure.section_at_face");
  EXPECT_EQ(warnings[0].text,
            "\"as_ahead\" damps axial vibrations of the bit, because the weight on bit leads its "
            "motion; \"extrapolated\" hardly does");
}

}  // namespace tdbd::simulation::doubtful_values_test
