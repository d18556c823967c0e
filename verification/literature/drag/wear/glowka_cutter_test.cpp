#include "reference/literature/drag/wear/glowka_cutter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "battery/generators.hpp"
#include "core/angles.hpp"
#include "forces/laws/virgin_groove.hpp"
#include "reference/forces/groove_by_strips.hpp"

namespace tdbd::reference::glowka_cutter_test {
namespace {

constexpr double inch = 25.4e-3, lbf = 4.4482216152605;  // m, N
/// Relative. The worked numbers are this project's own; no paper prints them.
constexpr double digits = 1e-6;

/// Power fits to the rows of data/single_cutter_fn_fd_doc.csv: Berea sandstone, sharp cutter of half
/// an inch; Sierra White granite, blunt cutter of three quarters.
const GlowkaFace small_face{0.25 * inch, 20.0 * degree};
const GlowkaLaw sharp_in_berea{.normal = {5925.0 * lbf, inch, 1.50},
                               .drag = {5863.0 * lbf, inch, 1.43}};

double between(double lo, double hi) { return lo + (hi - lo) * *battery::number(0.0, 1.0); }

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(GlowkaCutter, segments_of_a_16_mm_face_have_the_worked_areas) {
  expect_near(segment_area(8e-3, 0.5e-3), 1.867841e-6, digits);
  expect_near(segment_area(8e-3, 1.0e-3), 5.232189e-6, digits);
  expect_near(segment_area(8e-3, 2.0e-3), 14.505976e-6, digits);
}

TEST(GlowkaCutter, a_virgin_cut_of_60_mils_has_the_worked_area_and_forces) {
  const double depth = 0.06 * inch;
  expect_near(virgin_area(small_face, depth), 0.01373336 * inch * inch, digits);
  const GlowkaForces f = glowka_forces(sharp_in_berea, depth, 0.0);
  expect_near(f.normal, 87.079 * lbf, 1e-5);
  expect_near(f.drag, 104.924 * lbf, 1e-5);
}

TEST(GlowkaCutter, half_and_a_quarter_of_that_area_have_the_worked_depths_and_forces) {
  struct Row {
    double share, depth, normal, drag;
  };
  const double whole = virgin_area(small_face, 0.06 * inch);
  for (const Row& row :
       {Row{0.5, 0.0374094, 42.871, 53.393}, Row{0.25, 0.0234203, 21.236, 27.330}}) {
    const double depth = effective_depth(small_face, row.share * whole);
    expect_near(depth, row.depth * inch, 2e-6);
    const GlowkaForces f = glowka_forces(sharp_in_berea, depth, 0.0);
    expect_near(f.normal, row.normal * lbf, 2e-5);
    expect_near(f.drag, row.drag * lbf, 2e-5);
  }
}

/// Fn of a share of the area over that share of Fn: 1 where the two laws say the same.
double against_area_law(double power, double share) {
  const double whole = virgin_area(small_face, 0.06 * inch);
  const DepthLaw law{1.0, 0.06 * inch, power};
  return at_depth(law, effective_depth(small_face, share * whole)) / share;
}

TEST(GlowkaCutter, nearly_agrees_with_a_law_of_area_where_the_power_is_1_and_a_half) {
  EXPECT_NEAR(against_area_law(1.5, 0.5), 1.0 - 0.0153, 1e-4);
  EXPECT_NEAR(against_area_law(1.5, 0.25), 1.0 - 0.0245, 1e-4);
}

TEST(GlowkaCutter, parts_from_a_law_of_area_where_a_blunt_cutter_has_the_power_033) {
  EXPECT_NEAR(against_area_law(0.33, 0.5), 1.711, 1e-3);
  EXPECT_NEAR(against_area_law(0.33, 0.25), 2.932, 1e-3);
}

/// Shallow segments grow as the depth to 3/2: the ratio of the two laws tends to share^(2n/3 - 1).
RC_GTEST_PROP(GlowkaCutter, at_small_cuts_the_ratio_of_the_two_laws_is_a_power_of_the_share, ()) {
  const double power = between(0.2, 2.0), share = between(0.05, 0.95);
  const double depth = 1e-5 * small_face.radius;
  const DepthLaw law{1.0, depth, power};
  const double area = share * virgin_area(small_face, depth);
  const double ratio = at_depth(law, effective_depth(small_face, area)) / share;
  RC_ASSERT(std::abs(ratio / std::pow(share, power / 1.5 - 1.0) - 1.0) < 1e-4);
}

/// The product's groove is found by Newton's iteration on the half angle, this one by halving the depth.
RC_GTEST_PROP(GlowkaCutter, agrees_with_the_groove_of_the_product_and_with_strips, ()) {
  const double radius = between(4e-3, 12e-3), rake = between(0.0, 1.0);
  const GlowkaFace face{radius, rake};
  const double depth = between(0.02, 0.98) * 2.0 * radius * std::cos(rake);
  const double area = virgin_area(face, depth), scale = radius * radius;
  RC_ASSERT(std::abs(area - forces::groove_area({2.0 * radius, rake}, depth)) < 1e-14 * scale);
  RC_ASSERT(std::abs(area - groove_area_by_strips(2.0 * radius, rake, depth, 4000)) < 2e-5 * scale);
  RC_ASSERT(std::abs(effective_depth(face, area) - depth) < 1e-9 * radius);
  RC_ASSERT(std::abs(effective_depth(face, area) -
                     forces::groove_depth({2.0 * radius, rake}, area).depth) < 1e-9 * radius);
}

TEST(GlowkaCutter, a_flat_adds_its_stress_and_friction) {
  // 2067 d^0.33 lbf over 0.02 in2; the mean ratio of drag to normal force is 0.70.
  const DepthLaw stress{2067.0 / 0.02 * lbf / (inch * inch), inch, 0.33};
  const GlowkaLaw blunt{.normal = {}, .drag = {}, .flat_stress = stress, .flat_friction = 0.7};
  const GlowkaForces f = glowka_forces(blunt, 0.04 * inch, 0.02 * inch * inch);
  expect_near(f.flat_normal, 2067.0 * std::pow(0.04, 0.33) * lbf, 1e-12);
  expect_near(f.flat_drag, 0.7 * f.flat_normal, 1e-15);
  EXPECT_EQ(f.normal, 0.0);
}

TEST(GlowkaCutter, nothing_cut_is_no_force_and_more_than_the_face_its_whole_depth) {
  EXPECT_EQ(effective_depth(small_face, 0.0), 0.0);
  EXPECT_EQ(effective_depth(small_face, 1.0), 2.0 * small_face.radius * std::cos(20.0 * degree));
  const GlowkaForces f = glowka_forces(sharp_in_berea, 0.0, 1e-6);
  EXPECT_EQ(f.normal + f.drag + f.flat_normal + f.flat_drag, 0.0);
}

}  // namespace
}  // namespace tdbd::reference::glowka_cutter_test
