#include "reference/literature/roller/wheel/briggs_bit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angles.hpp"
#include "core/error.hpp"

namespace tdbd::reference::briggs_bit_test {
namespace {

const CoulombRock shale{24.82e6, 23.8 * degree};
const BriggsBit tricone{{60e-3, 12, 30.0 * degree, 10e-3}, 3, 70e-3};
/// Both ways meet on any columns: these are coarse.
const RollingOptions coarse{.column = 0.02e-3, .step = 0.16e-3};
constexpr double speed = 3.0 * pi;  // rad/s, 90 rpm

constexpr double one_percent = 0.01;  // as the worked numbers of a wheel are given
constexpr double of_columns = 1e-3;   // relative, of columns of 0.01 mm, steps of 0.08 mm and roots

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(BriggsBit, is_three_wheels) {
  const BriggsDrilling d = briggs_at_penetration(tricone, shale, 2e-3, speed);
  expect_near(d.weight, 3.0 * 1191.7, one_percent);
  expect_near(d.torque, 3.0 * 117.4 * 70e-3, one_percent);
  expect_near(d.cone_ratio, 70.0 / 59.03, 1e-3);
}

/// Wheels that turn freely and do not rise: all power goes through the torque.
TEST(BriggsBit, its_power_crushes_the_rock) {
  const BriggsDrilling d = briggs_at_penetration(tricone, shale, 2e-3, speed);
  const double volume_rate =
      2.0 * pi * tricone.track_radius * tricone.wheel.width * d.rate;  // m3/s
  expect_near(d.torque * speed, wedge_pressure(shale, tricone.wheel.half_angle) * volume_rate,
              0.01);
}

TEST(BriggsBit, penetration_from_weight_undoes_weight_from_penetration) {
  for (const double penetration : {0.5e-3, 2e-3, 4e-3}) {
    const BriggsDrilling d = briggs_at_penetration(tricone, shale, penetration, speed, coarse);
    const BriggsDrilling back = briggs_under_weight(tricone, shale, d.weight, speed, coarse);
    expect_near(back.penetration, penetration, 3.0 * of_columns);
    expect_near(back.weight, d.weight, 3.0 * of_columns);
  }
}

TEST(BriggsBit, cohesion_from_rate_undoes_rate_from_cohesion) {
  const BriggsDrilling d = briggs_under_weight(tricone, shale, 4e3, speed, coarse);
  const double c = briggs_cohesion(tricone, shale.friction_angle, 4e3, d.rate, speed, coarse);
  expect_near(c, shale.cohesion, of_columns);
}

TEST(BriggsBit, a_weaker_rock_drills_faster_and_turns_harder) {
  const CoulombRock weak{0.5 * shale.cohesion, shale.friction_angle};
  const BriggsDrilling hard = briggs_under_weight(tricone, shale, 4e3, speed, coarse);
  const BriggsDrilling soft = briggs_under_weight(tricone, weak, 4e3, speed, coarse);
  EXPECT_GT(soft.rate, 1.5 * hard.rate);
  EXPECT_GT(soft.torque, hard.torque);
}

/// This row rolls at 1.66647 turns a turn where nothing yields.
TEST(BriggsBit, of_a_row_rolls_on_the_row_s_track) {
  RollerCone cone;
  cone.journal_angle = 36.0 * degree;
  cone.rows = {{.along = 80e-3, .radius = 60e-3, .tooth_radius = 6e-3, .angles = {}}};
  cone.rows[0].angles.resize(25);
  const BriggsBit bit = briggs_bit({{cone, cone, cone}}, 0, 0, 0.7, 12e-3);
  EXPECT_EQ(bit.wheels, 3);
  EXPECT_EQ(bit.wheel.teeth, 25);
  EXPECT_NEAR(bit.track_radius / bit.wheel.radius, 1.66647, 5e-6);
  EXPECT_NEAR(briggs_at_penetration(bit, shale, 0.5e-3, speed).cone_ratio, 1.67, 0.01);
  EXPECT_THROW(briggs_bit({}, 0, 0, 0.7, 12e-3), InputError);
  EXPECT_THROW(briggs_bit({{cone}}, 0, 1, 0.7, 12e-3), InputError);
}

TEST(BriggsBit, names_itself_and_what_it_needs) {
  const auto message = [](double weight, double rotary_speed) -> std::string {
    try {
      briggs_under_weight(tricone, shale, weight, rotary_speed);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message(0.0, speed), "Briggs: found no weight, expected one above 0");
  EXPECT_EQ(message(1e3, 0.0), "Briggs: found no rotary speed, expected one above 0");
  EXPECT_EQ(message(1e6, speed).substr(0, 34), "Briggs: a penetration (m) at which");
}

}  // namespace
}  // namespace tdbd::reference::briggs_bit_test
