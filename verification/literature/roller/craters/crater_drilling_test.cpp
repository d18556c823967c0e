#include "reference/literature/roller/craters/crater_drilling.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "reference/literature/roller/craters/crater_bottom.hpp"
#include "reference/literature/roller/craters/tooth_prints.hpp"
#include "verification/battery/generators.hpp"
#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::crater_drilling_test {

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
  o.prescribed_ratio_revolutions = 1.0;  // a free tooth would topple
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

/// Cells of a tenth of a millimetre under a crater of 3 mm; scale: its volume.
constexpr double of_cells = 1e-3;

ZMap fine() { return flat_z_map(6e-3, 0.0, 240); }

TEST(CraterBottom, a_cone_and_a_cap_leave_their_volumes) {
  for (const Crater& crater : {Crater{{0, 0, 1.5e-3}, 1.5e-3, 3.5e-3, CraterShape::cone},
                               Crater{{0, 0, 1.2e-3}, 1.2e-3, 6e-3, CraterShape::sphere}}) {
    ZMap bottom = fine();
    const double expected = isolated_volume(crater);
    EXPECT_NEAR(dig(bottom, crater), expected, of_cells * expected);
    EXPECT_NEAR(*std::ranges::max_element(bottom.height), crater.depth, 0.1 * crater.depth);
    EXPECT_EQ(*std::ranges::min_element(bottom.height), 0.0);
    EXPECT_EQ(dig(bottom, crater), 0.0);
  }
}

TEST(CraterBottom, two_craters_that_overlap_take_less_than_their_sum) {
  ZMap bottom = fine();
  const Crater first{{-1e-3, 0, 1e-3}, 1e-3, 2.6e-3, CraterShape::cone};
  Crater second = first;
  second.tip_W.x() = 1e-3;
  const double alone = dig(bottom, first), then = dig(bottom, second);
  EXPECT_LT(then, 0.9 * alone);
  EXPECT_GT(then, 0.5 * alone);
}

RC_GTEST_PROP(CraterBottom, levels_of_a_plane_are_exact_and_of_the_outside_are_the_rims, ()) {
  ZMap bottom = flat_z_map(1.0, 0.0, 20);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i)
      bottom.height[at(j) * 20 + at(i)] = 0.3 * bottom.centre(i) - 0.2 * bottom.centre(j);
  const double x = *battery::number(-0.95, 0.95), y = *battery::number(-0.95, 0.95);
  RC_ASSERT(std::abs(level_at(bottom, x, y) - (0.3 * x - 0.2 * y)) <= 1e-15);
  RC_ASSERT(std::abs(level_at(bottom, 7.0, y) - (0.3 * 0.95 - 0.2 * y)) <= 1e-15);
}

RC_GTEST_PROP(CraterBottom, digging_never_raises_and_returns_the_removed_volume, ()) {
  ZMap bottom = flat_z_map(6e-3, 0.0, 60);
  for (int n = 0; n < 4; ++n) {
    const std::vector<double> before = bottom.height;
    const double depth = *battery::number(-0.5, 2.0) * 1e-3;
    const Crater crater{
        {*battery::number(-8.0, 8.0) * 1e-3, *battery::number(-8.0, 8.0) * 1e-3, depth},
        depth,
        *battery::number(0.0, 5.0) * 1e-3,
        *rc::gen::element(CraterShape::cone, CraterShape::sphere)};
    const double dug = dig(bottom, crater);
    double sum = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      RC_ASSERT(bottom.height[i] >= before[i]);
      sum += (bottom.height[i] - before[i]) * bottom.cell() * bottom.cell();
    }
    RC_ASSERT(std::abs(sum - dug) <= 1e-12 * (sum + 1e-12));
  }
}

}  // namespace tdbd::reference::crater_drilling_test

namespace tdbd::reference::tooth_prints_test {

const ToothLaw law = example::power_tooth();

ZMap flat() { return flat_z_map(15e-3, 0.0, 150); }

/// Presses a tooth at (x, 0) to a depth; the bottom under it is the flat one until it leaves.
double press(ToothPrint& print, const PrintOptions& options, double x, double depth, ZMap& bottom,
             PrintVolumes& volumes) {
  return follow_print(print, law, options, Vec3(x, 0.0, depth), depth, bottom, volumes);
}

TEST(ToothPrints, leave_one_crater_of_the_deepest_place_when_the_tooth_is_out) {
  ZMap bottom = flat();
  ToothPrint print;
  PrintVolumes volumes;
  const PrintOptions options;
  for (const double depth : {0.5e-3, 1e-3, 0.6e-3})
    EXPECT_EQ(press(print, options, depth, depth, bottom, volumes), 0.0);
  EXPECT_EQ(print.deepest, 1e-3);
  const double r = crater_radius(law, 1e-3), cone = std::numbers::pi * r * r * 1e-3 / 3.0;
  EXPECT_NEAR(press(print, options, 2e-3, -1e-6, bottom, volumes), cone, 2e-3 * cone);
  EXPECT_NEAR(volumes.isolated, cone, 1e-12 * cone);
  EXPECT_NEAR(level_at(bottom, 1e-3, 0.0), 1e-3, 0.05e-3);
  EXPECT_EQ(print.deepest, 0.0);
  EXPECT_EQ(press(print, options, 2e-3, -1e-6, bottom, volumes), 0.0);
}

/// A ball dragged through the rock leaves a groove, and behind itself at once.
TEST(ToothPrints, sweep_a_groove_behind_the_tooth) {
  ZMap bottom = flat();
  ToothPrint print;
  PrintVolumes volumes;
  const PrintOptions options{
      .path = PrintPath::swept, .shape = CraterShape::sphere, .sphere_radius = 6e-3};
  constexpr double depth = 1e-3, way = 10e-3;
  for (double x = -5e-3; x < 5e-3; x += 0.05e-3) press(print, options, x, depth, bottom, volumes);
  EXPECT_NEAR(level_at(bottom, -2e-3, 0.0), depth, 0.02e-3);
  EXPECT_LT(level_at(bottom, 5e-3, 0.0), 0.01e-3);
  press(print, options, 5e-3, -1e-6, bottom, volumes);
  const double a = options.sphere_radius, half = std::acos(1.0 - depth / a);
  const double section = a * a * (half - std::sin(half) * std::cos(half));
  const double cap = std::numbers::pi * depth * depth * (a - depth / 3.0);
  EXPECT_NEAR(volumes.dug, way * section + cap, 0.01 * volumes.dug);
  EXPECT_NEAR(volumes.isolated, cap, 1e-12 * cap);
}

TEST(ToothPrints, of_crushed_rock_do_not_spring_back) {
  PrintOptions options;
  ToothPrint print;
  print.deepest = 1e-3;
  options.release = ToothRelease::elastic;
  EXPECT_EQ(print_share(options, print, 0.5e-3), 1.0);
  options.release = ToothRelease::crushed;
  EXPECT_EQ(print_share(options, print, 1e-3), 1.0);
  EXPECT_NEAR(print_share(options, print, 1e-3 - 10e-6), 0.5, 1e-9);
  EXPECT_EQ(print_share(options, print, 0.9e-3), 0.0);
  EXPECT_EQ(print_share(options, print, 1.2e-3), 1.0);
  EXPECT_EQ(print_share(options, print, -1e-9), 0.0);
}

}  // namespace tdbd::reference::tooth_prints_test
