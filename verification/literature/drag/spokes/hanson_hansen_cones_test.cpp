#include "reference/literature/drag/spokes/hanson_hansen_cones.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::reference::hanson_hansen_cones_test {
namespace {

constexpr double mm = 1e-3, pi = std::numbers::pi, speed = 3.0 * pi;

/// A row of teeth on each of three equal cones without offset.
RollerBit one_row(double along, double radius, int teeth) {
  RollerBit bit;
  for (int k = 0; k < 3; ++k) {
    RollerCone cone;
    cone.azimuth = 2.0 * pi * k / 3.0;
    cone.journal_angle = 36.0 * pi / 180.0;
    cone.inertia = 0.005;
    RollerRow row{along, radius, 6 * mm, {}};
    for (int i = 0; i < teeth; ++i) row.angles.push_back(2.0 * pi * i / teeth);
    cone.rows.push_back(row);
    bit.cones.push_back(cone);
  }
  return bit;
}

ConesSetup even_drilling() {
  ConesSetup s;
  s.system.stiffness = Vec3(0, 0, 1e7).asDiagonal();
  s.system.damping = Vec3(0, 0, 1e5).asDiagonal();
  s.system.mass = 5000.0;
  s.system.inertia = 1e6;
  s.system.rate = 3e-3;  // 2 mm a revolution
  s.system.speed = speed;
  s.rock.pressure = 100e6;
  return s;
}

/// Rolling without slip: i = cos(beta) L / rho + sin(beta), with the worked numbers of both rows.
TEST(HansonHansenCones, turn_at_the_rolling_ratio_of_their_only_row) {
  for (const auto& [along, radius, teeth, ratio] :
       {std::tuple(80 * mm, 60 * mm, 25, 1.66647), std::tuple(45 * mm, 40 * mm, 15, 1.49793)}) {
    HansonHansenCones m = hanson_hansen_cones(one_row(along, radius, teeth), even_drilling());
    for (int i = 0; i < 2000; ++i) advance(m);
    const double start = m.state[bit_unknowns];
    for (int i = 0; i < 2000; ++i) advance(m);
    const double turned = (start - m.state[bit_unknowns]) / (0.2 * speed);
    EXPECT_NEAR(turned / ratio, 1.0, 0.01) << teeth;  // seen: 0.9985, 0.9975
    EXPECT_GT(teeth_in_contact(m), 0);
    EXPECT_GT(m.removed, 0.0);
  }
}

/// Three cones that start alike stay alike.
TEST(HansonHansenCones, of_one_kind_turn_alike) {
  HansonHansenCones m = hanson_hansen_cones(one_row(45 * mm, 40 * mm, 15), even_drilling());
  for (int i = 0; i < 1500; ++i) advance(m);
  EXPECT_GT(m.load.force_W.squaredNorm() + m.removed, 0.0);
  EXPECT_NEAR(m.state[bit_unknowns + 3] / m.state[bit_unknowns + 1], 1.0, 1e-6);
  EXPECT_NEAR(m.state[bit_unknowns + 5] / m.state[bit_unknowns + 1], 1.0, 1e-6);
}

TEST(HansonHansenCones, leave_out_the_bits_acceleration_of_a_cone) {
  const RollerCone cone = one_row(45 * mm, 40 * mm, 15).cones.front();
  EXPECT_NEAR(neglected_acceleration(cone, 50.0), 29.4, 0.05);
  EXPECT_NEAR(2.0 / cone.inertia, 400.0, 1e-9);
}

}  // namespace
}  // namespace tdbd::reference::hanson_hansen_cones_test
