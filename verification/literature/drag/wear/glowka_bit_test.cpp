#include "reference/literature/drag/wear/glowka_bit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "battery/generators.hpp"
#include "core/error.hpp"
#include "core/types.hpp"
#include "forces/laws/laws.hpp"
#include "literature/drag/wear/glowka_laws.hpp"
#include "reference/forces/groove_by_strips.hpp"
#include "reference/literature/drag/wear/glowka_cutter.hpp"

namespace tdbd::reference::glowka_bit_test {

using namespace glowka_laws;

const GlowkaRun run{.advance = 2e-3, .rotary_speed = 4.0 * pi};

/// The sums as they are written, with positions and directions of their own.
struct Sums {
  double weight = 0.0, torque = 0.0, side_x = 0.0, side_y = 0.0, bend_x = 0.0, bend_y = 0.0;
};

void add(Sums& s, const bit::Cutter& c, double arm, double normal, double drag) {
  const double cos = std::cos(c.azimuth), sin = std::sin(c.azimuth);
  const double x = arm * cos, y = arm * sin, z = -c.tip_height;
  const double Fx = -normal * std::sin(c.profile_angle) * cos + drag * sin;
  const double Fy = -normal * std::sin(c.profile_angle) * sin - drag * cos;
  const double Fz = -normal * std::cos(c.profile_angle);
  s.weight -= Fz;
  s.torque += drag * arm;
  s.side_x += Fx;
  s.side_y += Fy;
  s.bend_x += y * Fz - z * Fy;
  s.bend_y += z * Fx - x * Fz;
}

TEST(GlowkaBit, weight_torque_side_force_and_moments_are_the_sums) {
  const GlowkaBit bit = glowka_bit(cutters_of("bit-b"));
  const std::vector<double> worn(bit.cutters.size(), 0.8e-3);
  const GlowkaLoads loads = loads_of(bit, in_granite, worn, run);
  Sums s;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i) {
    const GlowkaCutterLoad& l = loads.cutters[i];
    if (l.area > 0.0)
      add(s, bit.cutters[i], l.volume / (2.0 * pi * l.area), l.forces.normal, l.forces.drag);
    add(s, bit.cutters[i], bit.cutters[i].tip_radius, l.forces.flat_normal, l.forces.flat_drag);
  }
  const double newton = 1e-12 * s.weight, newton_metre = 1e-12 * s.torque;
  EXPECT_NEAR(loads.weight, s.weight, newton);
  EXPECT_NEAR(loads.torque, s.torque, newton_metre);
  EXPECT_NEAR(loads.force_B.x(), s.side_x, newton);
  EXPECT_NEAR(loads.force_B.y(), s.side_y, newton);
  EXPECT_NEAR(loads.moment_B.x(), s.bend_x, newton_metre);
  EXPECT_NEAR(loads.moment_B.y(), s.bend_y, newton_metre);
}

/// Bits at another azimuth have the same loads, turned.
RC_GTEST_PROP(GlowkaBit, turning_the_bit_turns_the_side_force_and_the_moments, ()) {
  const double angle = *battery::number(0.0, 6.0);
  std::vector<bit::Cutter> cutters = cutters_of("bit-b");
  const std::vector<double> worn(cutters.size());
  const GlowkaLoads before = loads_of(glowka_bit(cutters, 0.2e-3), sharp_in_berea, worn, run);
  for (bit::Cutter& c : cutters) c.azimuth += angle;
  const GlowkaLoads after = loads_of(glowka_bit(cutters, 0.2e-3), sharp_in_berea, worn, run);
  const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  RC_ASSERT((turn * before.force_B - after.force_B).norm() < 1e-9 * before.weight);
  RC_ASSERT((turn * before.moment_B - after.moment_B).norm() < 1e-9 * before.torque);
}

TEST(GlowkaBit, blades_in_balance_have_no_side_force_and_no_bending) {
  std::vector<bit::Cutter> three(3);
  for (int i = 0; i < 3; ++i) {
    bit::Cutter& c = three[static_cast<std::size_t>(i)];
    c.diameter = 16e-3;
    c.tip_radius = 40e-3;
    c.azimuth = 2.0 * pi * i / 3.0;
    c.profile_angle = 0.3;
    c.back_rake = 20.0 * degree;
  }
  const GlowkaLoads loads = loads_of(glowka_bit(three), in_granite, {1e-3, 1e-3, 1e-3}, run);
  EXPECT_LT(loads.force_B.head<2>().norm(), 1e-12 * loads.weight);
  EXPECT_LT(loads.moment_B.head<2>().norm(), 1e-12 * loads.torque);
  EXPECT_GT(loads.torque, 1.0);
}

/// One law read at effective depths, one of areas with the mean constants of the same tests (39 MPa and
/// 0.74): on the whole bit they differ by 6 to 15 %, less at larger cuts, since the power is below 3/2.
TEST(GlowkaBit, in_berea_is_near_the_law_of_areas_of_the_same_tests) {
  constexpr double eps = 39e6, zeta = 0.74;
  const GlowkaBit bit = glowka_bit(cutters_of("bit-b"));
  for (const double advance : {1e-3, 2.0833e-3, 3e-3}) {
    const GlowkaLoads loads =
        loads_of(bit, sharp_in_berea, std::vector<double>(bit.cutters.size()), {advance, 4.0 * pi});
    double weight = 0.0, torque = 0.0;
    for (std::size_t i = 0; i < bit.cutters.size(); ++i) {
      weight += zeta * eps * loads.cutters[i].area * std::cos(bit.cutters[i].profile_angle);
      torque += eps * loads.cutters[i].volume / (2.0 * pi);
    }
    EXPECT_NEAR(loads.weight / weight, 1.1, 0.06) << advance;
    EXPECT_NEAR(loads.torque / torque, 1.1, 0.06) << advance;
  }
}

TEST(GlowkaBit, the_largest_cut_of_bit_b_is_the_worked_one) {
  const GlowkaBit bit = glowka_bit(cutters_of("bit-b"), 0.01e-3);
  const GlowkaLoads loads =
      loads_of(bit, sharp_in_berea, std::vector<double>(bit.cutters.size()), {3e-3, 4.0 * pi});
  double largest = 0.0;
  for (const GlowkaCutterLoad& l : loads.cutters) largest = std::max(largest, l.area);
  EXPECT_NEAR(largest, 26.235e-6, 5e-4 * 26.235e-6);
}

TEST(GlowkaBit, wear_on_a_face_that_leans_back_is_less_along_the_normal) {
  std::vector<bit::Cutter> one(1);
  one[0].diameter = 16e-3;
  one[0].tip_radius = 40e-3;
  one[0].back_rake = 60.0 * degree;
  const auto deepest = [&](double worn) {
    const GlowkaLoads loads = loads_of(glowka_bit(one), in_granite, {worn}, run);
    return *std::max_element(loads.cut.bottom.begin(), loads.cut.bottom.end());
  };
  EXPECT_NEAR(deepest(0.0) - deepest(2e-3), 1e-3, 1e-7);
}

TEST(GlowkaBit, flats_add_weight_and_heat) {
  const GlowkaBit bit = glowka_bit(cutters_of("bit-b"));
  const std::size_t n = bit.cutters.size();
  const GlowkaLoads sharp = loads_of(bit, in_granite, std::vector<double>(n), run);
  const GlowkaLoads worn = loads_of(bit, in_granite, std::vector<double>(n, 1e-3), run);
  EXPECT_GT(worn.weight, 1.5 * sharp.weight);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(sharp.cutters[i].temperature, granite_heat.fluid_temperature);
    EXPECT_EQ(worn.cutters[i].temperature > granite_heat.fluid_temperature,
              worn.cutters[i].area > 0.0);
  }
}

TEST(GlowkaBit, advance_from_weight_undoes_weight_from_advance) {
  const GlowkaBit bit = glowka_bit(cutters_of("bit-b"), 0.1e-3);
  const std::vector<double> worn(bit.cutters.size(), 0.3e-3);
  for (const double advance : {0.1e-3, 1e-3, 4e-3}) {
    const double weight = loads_of(bit, in_granite, worn, {advance, 12.0}).weight;
    GlowkaLoads loads;
    EXPECT_NEAR(glowka_under_weight(bit, in_granite, granite_heat, worn, weight, 12.0, loads),
                advance, 1e-12);  // m; 0.1 m halved 40 times
    EXPECT_NEAR(loads.weight, weight, 1e-7 * weight);
  }
  GlowkaLoads loads;
  EXPECT_THROW(glowka_under_weight(bit, in_granite, granite_heat, worn, 1e9, 12.0, loads),
               InputError);
}

std::string message(const std::vector<double>& worn, const GlowkaRun& how,
                    std::vector<bit::Cutter> cutters) {
  try {
    loads_of(glowka_bit(cutters, 1e-3), in_granite, worn, how);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(GlowkaBit, names_itself_and_what_it_needs) {
  bit::Cutter square;
  square.id = 7;
  square.diameter = 16e-3;
  square.tip_radius = 40e-3;
  EXPECT_EQ(message({}, run, {}), "Glowka: found no cutters, expected at least one");
  EXPECT_EQ(message({0.0}, {0.0, 1.0}, {square}),
            "Glowka: found an advance of 0.000000 m per revolution, expected one above 0");
  EXPECT_EQ(message({0.0}, {1e-3, 0.0}, {square}),
            "Glowka: found a rotary speed of 0.000000 rad/s, expected one above 0");
  EXPECT_EQ(message({}, run, {square}), "Glowka: found the wear of 0 cutters, expected that of 1");
  EXPECT_EQ(message({1e-3}, run, {square}),
            "Glowka: found cutter 7 worn and without back rake, expected one above 0: its flat has "
            "no end");
  EXPECT_EQ(message({0.0}, run, {square}), "");
}

}  // namespace tdbd::reference::glowka_bit_test

namespace tdbd::reference::glowka_cutter_test {

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

}  // namespace tdbd::reference::glowka_cutter_test
