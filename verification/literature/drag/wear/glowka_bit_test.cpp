#include "reference/literature/drag/wear/glowka_bit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "battery/generators.hpp"
#include "core/angles.hpp"
#include "core/error.hpp"
#include "literature/drag/wear/glowka_laws.hpp"

namespace tdbd::reference::glowka_bit_test {
namespace {

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

}  // namespace
}  // namespace tdbd::reference::glowka_bit_test
