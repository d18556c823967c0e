#include "reference/literature/drag/spokes/hanson_hansen_pdc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bit/cutter/cutter_table.hpp"
#include "core/error.hpp"

namespace tdbd::reference::hanson_hansen_pdc_test {
namespace {

constexpr double speed = 4.0 * std::numbers::pi, rate = 6e-3;  // 120 rpm, 3 mm a revolution
constexpr double weight = 22414.8, torque = 1747.98;           // of the radial plane, bit B

std::vector<bit::Cutter> bit_b() {
  return bit::read_cutter_table(TDBD_SOURCE_DIR "/cases/bits/bit-b.csv", bit::CutterDefaults{});
}

HansonHansenSetup laboratory() {
  HansonHansenSetup s;
  s.rock.shared = {100e6, 0.8, 0.0, 0.0};
  s.system.stiffness = Vec3(2e5, 2e5, 7e5).asDiagonal();
  s.system.damping = Vec3(1e4, 1e4, 5e5).asDiagonal();
  s.system.inertia = 1e4;
  s.system.turn_stiffness = 938.0;
  s.system.rate = rate;
  s.system.speed = speed;
  s.spring = {1e8, 0.6};
  s.led = 1.0;
  s.weight = weight;
  s.torque = torque;
  s.depth = 0.02;
  return s;
}

/// Means over some steps.
struct PdcMeans {
  double wob = 0.0, tob = 0.0, rock = 0.0;
};

PdcMeans drill(HansonHansenPdc& m, int steps) {
  PdcMeans mean;
  for (int i = 0; i < steps; ++i) {
    advance(m);
    mean.wob -= m.load.force_W.z() / steps;
    mean.tob -= m.load.torque / steps;
    mean.rock += m.state[8] / steps;
  }
  return mean;
}

TEST(HansonHansenPdc, drills_with_the_weight_and_torque_of_the_radial_plane) {
  HansonHansenSetup s = laboratory();
  s.lateral_locked = true;
  HansonHansenPdc m = hanson_hansen_pdc(bit_b(), s);
  const PdcMeans mean = drill(m, 500);
  EXPECT_NEAR(mean.wob / weight, 1.0, 0.005);  // seen: 0.9983
  EXPECT_NEAR(mean.tob / torque, 1.0, 0.005);  // seen: 0.9979
}

/// A bit that may move sideways is pushed by its imbalance and held by wall and string.
TEST(HansonHansenPdc, leaves_the_holes_axis_when_it_may) {
  HansonHansenPdc m = hanson_hansen_pdc(bit_b(), laboratory());
  drill(m, 250);
  const double off = std::hypot(m.state[0], m.state[1]);
  EXPECT_GT(off, 1e-5);  // seen: 0.05 mm
  EXPECT_LT(off, 2e-4);
}

TEST(HansonHansenPdc, pushes_the_rock_down_with_its_weight) {
  HansonHansenSetup s = laboratory();
  s.lateral_locked = true;
  s.system.rock_mass = 280.0;
  s.system.rock_stiffness = 8.6e7;
  s.system.rock_damping = 2e5;
  HansonHansenPdc m = hanson_hansen_pdc(bit_b(), s);
  m.state[8] = weight / s.system.rock_stiffness;
  m.state[2] += m.state[8];
  drill(m, 100);
  const PdcMeans mean = drill(m, 200);
  EXPECT_NEAR(mean.rock * s.system.rock_stiffness / mean.wob, 1.0, 0.001);
}

TEST(HansonHansenPdc, says_what_it_needs) {
  HansonHansenSetup s = laboratory();
  EXPECT_THROW(hanson_hansen_pdc({}, s), InputError);
  s.system.mass = 0.0;
  EXPECT_THROW(hanson_hansen_pdc(bit_b(), s), InputError);
}

}  // namespace
}  // namespace tdbd::reference::hanson_hansen_pdc_test
