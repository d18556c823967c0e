#include "reference/literature/roller/craters/crater_drilling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::crater_drilling_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Three cones with an upright tooth each, which hardly turn.
RollerBit tripod() {
  RollerBit bit = example::roller_bit(0.0);
  for (RollerCone& cone : bit.cones) cone.rows = {example::even_row(80e-3, 60e-3, 1, 0.0)};
  return bit;
}

CraterDrillingOptions on_springs(double mass, double damping) {
  CraterDrillingOptions o;
  o.print.release = ToothRelease::elastic;
  o.start = BottomStart::flat;
  o.first_ratio = 0.0;
  o.given_revolutions = 1.0;  // a free tooth would topple
  o.axial = AxialMotion::mass;
  o.mass = mass;
  o.axial_damping = damping;
  o.sliding.friction = 0.0;
  return o;
}

/// Springs of 3 x 1e7 N/m under 5 t and 20 kN: from touch it swings to twice the depth at rest in half a
/// period, and back.
TEST(CraterDrilling, lets_a_mass_swing_on_elastic_teeth) {
  const ToothLaw spring = PowerTooth{1e7, 1.0, 6e-3};
  constexpr double mass = 5000.0, k = 3e7, weight = 20e3, step = 1e-4;
  const double period = 2.0 * pi * std::sqrt(mass / k);
  RollerSchedule s{1e-6, weight, step, 0.0, 0.0};
  s.revolutions = 0.95 * period * s.bit_speed / (2.0 * pi);
  const RollerRun r = crater_drilling(tripod(), spring, s, on_springs(mass, 0.0));
  const double touch = r.series.depth[0] - step * step * weight / mass;
  const auto deepest = std::ranges::max_element(r.series.depth);
  EXPECT_NEAR(*deepest - touch, 2.0 * weight / k, 0.01 * weight / k);
  const auto when = static_cast<double>(deepest - r.series.depth.begin()) * step;
  EXPECT_NEAR(when, 0.5 * period, 0.01 * period);
  EXPECT_LT(r.series.depth.back() - touch, 0.1 * weight / k);
  EXPECT_NEAR(*std::ranges::max_element(r.series.weight), 2.0 * weight, 0.01 * weight);
}

TEST(CraterDrilling, damps_a_mass_to_where_its_teeth_carry_the_weight) {
  const ToothLaw spring = PowerTooth{1e7, 1.0, 6e-3};
  RollerSchedule s{1e-6, 20e3, 1e-3, 0.0, 0.0};
  s.revolutions = 2.0 * s.bit_speed / (2.0 * pi);
  const RollerRun r = crater_drilling(tripod(), spring, s, on_springs(500.0, 2e5));
  EXPECT_NEAR(r.series.weight.back(), 20e3, 1e-6 * 20e3);
}

/// A round groove for every row, and level rock as high as a ball beside them.
TEST(CraterDrilling, starts_with_a_groove_for_every_row) {
  RollerSchedule s{1.0, 1.0, 1e-3, 0.01, 0.0};
  const RollerBit bit = example::roller_bit(4e-3);
  const RollerRun r = crater_drilling(bit, example::power_tooth(), s, {});
  const RollerCone& cone = bit.cones[0];
  for (const RollerRow& row : cone.rows) {
    const JournalAxes axes = journal_axes(cone);
    const Vec3 lowest = -row.along * axes.s + row.radius * axes.u + Vec3(0, cone.offset, 0);
    const double radius = lowest.head<2>().norm();
    const double a = row.tooth_radius;
    EXPECT_NEAR(level_at(r.bottom, 0.0, radius), lowest.z(), 0.02e-3);
    EXPECT_NEAR(level_at(r.bottom, 0.0, radius + 3e-3), lowest.z() - a + std::sqrt(a * a - 9e-6),
                0.03e-3);
  }
}

TEST(CraterDrilling, takes_its_means_after_the_bit_has_settled) {
  const RollerSchedule s{3.0 * pi, 20e3, 1e-3, 3.0, 1.5};
  const RollerRun r = crater_drilling(example::roller_bit(0.0), example::power_tooth(), s, {});
  ASSERT_EQ(r.series.time.size(), 2000U);
  EXPECT_NEAR(r.rate, (r.series.depth[1999] - r.series.depth[1000]) / 0.999, 1e-12);
  const double torque =
      std::accumulate(r.series.torque.begin() + 1000, r.series.torque.end(), 0.0) / 1000.0;
  EXPECT_NEAR(r.torque, torque, 1e-9);
  const double teeth = std::accumulate(r.tooth_force.begin(), r.tooth_force.end(), 0.0);
  EXPECT_NEAR(teeth, r.weight, 1e-6 * r.weight);
  EXPECT_NEAR(std::accumulate(r.tooth_volume.begin(), r.tooth_volume.end(), 0.0), r.volumes.dug,
              1e-12 * r.volumes.dug);
  EXPECT_NEAR(static_cast<double>(r.series.forces_in_contact.size()) / 1000.0, r.contacts, 1e-9);
  EXPECT_NEAR(std::accumulate(r.tooth_contacts.begin(), r.tooth_contacts.end(), 0.0), r.contacts,
              1e-12 * r.contacts);
  EXPECT_EQ(*std::ranges::max_element(r.tooth_largest),
            *std::ranges::max_element(r.series.forces_in_contact));
}

/// A table's last row is its end: the force stays, and each step of each tooth beyond it is counted.
TEST(CraterDrilling, counts_what_lies_beyond_a_table) {
  ToothTable shallow = example::tooth_table();
  for (double& depth : shallow.depth) depth *= 0.4;
  const RollerSchedule s{3.0 * pi, 60e3, 1e-3, 1.0, 0.0};
  const RollerRun r = crater_drilling(example::roller_bit(0.0), shallow, s, {});
  EXPECT_GT(r.beyond_law, 0);
  EXPECT_GT(r.deepest_print, shallow.depth.back());
}

}  // namespace
}  // namespace tdbd::reference::crater_drilling_test
