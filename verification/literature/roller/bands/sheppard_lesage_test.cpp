#include "reference/literature/roller/bands/sheppard_lesage.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::reference::sheppard_lesage_test {
namespace {

using battery::integer;
using battery::number;

constexpr double pi = std::numbers::pi, degree = pi / 180.0;
constexpr double speed = 3.0 * pi;  // 90 rpm
constexpr BandRock rock{100e6, 0.8};

const RollerRow outer{80e-3, 60e-3, 6e-3, {}}, inner{45e-3, 40e-3, 6e-3, {}};

RollerCone cone_with(double offset, std::vector<RollerRow> rows) {
  return {0.0, 36.0 * degree, offset, 0.0, 5e-3, std::move(rows)};
}

RollerBit three_cones(double offset, const std::vector<RollerRow>& rows) {
  RollerBit bit;
  for (int k = 0; k < 3; ++k) {
    bit.cones.push_back(cone_with(offset, rows));
    bit.cones.back().azimuth = 2.0 * pi * k / 3.0;
  }
  return bit;
}

struct Worked {
  double offset;
  std::vector<RollerRow> rows;
  double ratio, weight, torque, share;
};

const std::vector<Worked> worked{{0.0, {outer}, 1.66860, 9618.7, 61.652, 0.192},
                                 {0.0, {inner}, 1.49617, 8055.0, 36.215, 0.135},
                                 {0.0, {outer, inner}, 1.60543, 13333.4, 99.249, 0.223},
                                 {4e-3, {outer, inner}, 1.62022, 10372.0, 100.192, 0.290},
                                 {8e-3, {outer, inner}, 1.62447, 7745.2, 101.028, 0.391}};

TEST(SheppardLesage, gives_the_worked_cones) {
  for (const Worked& w : worked) {
    const SheppardLesage s = sheppard_lesage(three_cones(w.offset, w.rows), rock, speed, 2e-3);
    for (const BandCone& cone : s.cones) {
      EXPECT_NEAR(cone.ratio, w.ratio, 0.5e-5);
      EXPECT_NEAR(-cone.loads.force.z(), w.weight, 0.05);
      EXPECT_NEAR(-cone.loads.torque, w.torque, 0.5e-3);
      EXPECT_NEAR(3.0 * cone.loads.torque / (cone.loads.force.z() * 0.1), w.share, 0.5e-3);
    }
    EXPECT_NEAR(s.weight, 3.0 * w.weight, 0.15);
    EXPECT_NEAR(s.torque, 3.0 * w.torque, 1.5e-3);
    EXPECT_LE(s.lateral.norm(), 1e-12 * s.weight);  // three equal cones
  }
}

TEST(SheppardLesage, removes_the_worked_volume) {
  const SheppardLesage s = sheppard_lesage(three_cones(0.0, {outer, inner}), rock, speed, 2e-3);
  EXPECT_NEAR(s.volume_rate / 3.0, 9.753996e-6, 0.5e-12);
}

TEST(SheppardLesage, the_inner_row_is_in_rock_on_the_worked_arc) {
  const BandArc arc = band_arc(cone_with(4e-3, {inner}), inner, {speed, 3e-3, 3}, {});
  EXPECT_NEAR(arc.entry / degree, 3.291, 0.5e-3);
  EXPECT_NEAR(arc.exit / degree, 15.374, 0.5e-3);
}

TEST(SheppardLesage, finds_the_worked_advance_under_20_kn) {
  const SheppardLesage s =
      sheppard_lesage_under(three_cones(4e-3, {outer, inner}), rock, speed, 20e3);
  EXPECT_NEAR(s.weight, 20e3, 1e-8);
  EXPECT_NEAR(1e3 * s.advance, 1.09869, 0.5e-5);
  EXPECT_NEAR(3600.0 * s.rate, 5.933, 0.5e-3);
  EXPECT_NEAR(s.torque, 167.06, 0.5e-2);
  for (const BandCone& cone : s.cones) EXPECT_NEAR(cone.ratio, 1.62642, 0.5e-5);
}

TEST(SheppardLesage, gives_the_worked_weights_and_torques_at_four_advances) {
  struct Row {
    double millimetres, weight, torque;
  };
  for (const Row& w : {Row{0.5, 10737.0, 76.77}, Row{1.0, 18612.0, 152.28},
                       Row{2.0, 31116.0, 300.57}, Row{4.0, 50161.0, 589.03}}) {
    const SheppardLesage s =
        sheppard_lesage(three_cones(4e-3, {outer, inner}), rock, speed, 1e-3 * w.millimetres);
    EXPECT_NEAR(s.weight, w.weight, 0.5);
    EXPECT_NEAR(s.torque, w.torque, 0.5e-2);
  }
}

/// Any bit, its rock and its motion.
struct AnyBands {
  RollerBit bit;
  BandRock rock;
  BandOptions options;
  double speed, advance;
};

RollerCone any_cone() {
  RollerCone cone{*number(-3.0, 3.0), *number(0.3, 0.8), *number(-5e-3, 5e-3), 0.0, 5e-3, {}};
  const int rows = *integer(1, 4);
  for (int r = 0; r < rows; ++r)
    cone.rows.push_back({*number(0.03, 0.1), *number(0.03, 0.07), *number(2e-3, 8e-3), {}});
  return cone;
}

AnyBands any_bands() {
  AnyBands b;
  const int cones = *integer(1, 4);
  for (int k = 0; k < cones; ++k) b.bit.cones.push_back(any_cone());
  b.rock = {*number(1.0, 300.0) * 1e6, *number(0.0, 1.5)};
  b.options = {
      .half_angle = *number(0.0, 0.8), .angles = 100, .least_ratio = 0.1, .greatest_ratio = 10.0};
  b.speed = *number(1.0, 30.0);
  b.advance = *number(0.1, 4.0) * 1e-3;
  return b;
}

/// Loads that the model finds, or nothing for a bit that does not roll in the bracket.
template <typename F>
auto unless_it_cannot_roll(const F& f) -> decltype(f()) {
  try {
    return f();
  } catch (const InputError&) {
    RC_DISCARD("does not roll");
  }
}

constexpr double closes = 1e-12;  // of the larger side

/// The part along the motion does the work eps x volume, the part across it none, and the cones'
/// journals transmit what their free turning does not take.
RC_GTEST_PROP(SheppardLesage, power_is_that_of_the_volume, ()) {
  const AnyBands b = any_bands();
  const SheppardLesage s = unless_it_cannot_roll(
      [&] { return sheppard_lesage(b.bit, b.rock, b.speed, b.advance, b.options); });
  const double spent = b.rock.specific_energy * s.volume_rate;
  const double size = std::abs(s.weight * s.rate) + std::abs(s.torque * b.speed) + spent;
  RC_ASSERT(std::abs(s.weight * s.rate + s.torque * b.speed - spent) <= closes * size);
}

/// The claim's number: the worked bits at four advances.
TEST(SheppardLesage, power_of_the_worked_bits_is_that_of_their_volume) {
  double worst = 0.0;
  for (const Worked& w : worked)
    for (const double advance : {0.5e-3, 1e-3, 2e-3, 4e-3}) {
      const SheppardLesage s = sheppard_lesage(three_cones(w.offset, w.rows), rock, speed, advance);
      const double spent = rock.specific_energy * s.volume_rate;
      worst = std::max(worst, std::abs(s.weight * s.rate + s.torque * speed - spent) / spent);
    }
  EXPECT_LE(worst, closes);
  battery::record({"chapter2/power-identity",
                   "five bits at four advances: weight rate + torque speed over specific energy "
                   "times volume rate, distance from 1",
                   worst, "1", "<= 1e-12",
                   worst <= closes ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// The same with cones that are driven or braked: their moments' power is part of the account.
RC_GTEST_PROP(SheppardLesage, power_of_a_driven_cone_closes_too, ()) {
  const AnyBands b = any_bands();
  const BandMotion motion{b.speed, *number(1e-4, 0.02), 3};
  std::vector<BandStrip> strips;
  unless_it_cannot_roll([&] {
    lay_strips(b.bit.cones[0], motion, b.options, strips);
    return true;
  });
  const double cone_speed = -*number(0.1, 3.0) * b.speed;
  const BandLoads l = band_loads(strips, b.rock, cone_speed);
  const double sum = -l.force.z() * motion.rate - l.torque * b.speed - l.moment * cone_speed;
  const double spent = b.rock.specific_energy * l.volume_rate;
  const double size = std::abs(l.force.z() * motion.rate) + std::abs(l.torque * b.speed) + spent;
  RC_ASSERT(std::abs(sum - spent) <= closes * size);
}

/// Strips have the velocity of a body that turns with the bit and on its journal, and the
/// component along the normal is that which the arc was found with.
RC_GTEST_PROP(SheppardLesage, entering_speed_does_not_depend_on_the_speed_of_the_cone, ()) {
  const AnyBands b = any_bands();
  std::vector<BandStrip> strips;
  unless_it_cannot_roll([&] {
    lay_strips(b.bit.cones[0], {b.speed, 5e-3, 3}, b.options, strips);
    return true;
  });
  for (const BandStrip& s : strips) {
    RC_ASSERT(std::abs(s.spin.dot(s.normal)) <= 1e-16);
    RC_ASSERT(s.entering >= 0.0);
    RC_ASSERT(std::abs(s.normal.norm() - 1.0) <= 1e-15);
  }
}

/// Without offset, bands parallel to the journal, a small advance: the closed form of the arc.
TEST(SheppardLesage, a_small_advance_has_the_arc_of_its_closed_form) {
  double before = 1.0;
  for (const double advance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const RollerCone cone = cone_with(0.0, {outer});
    const double rate = advance * speed / (2.0 * pi);
    const double exit = band_arc(cone, outer, {speed, rate, 3}, {}).exit;
    const double off = std::abs(exit / small_arc(cone, outer, advance) - 1.0);
    EXPECT_LT(off, before / 2.5);  // a term of the arc's own size: half an order in the advance
    before = off;
  }
  EXPECT_LT(before, 1e-3);
}

/// Bands that lie flat on the bottom enter it where they are lowest and by the rate alone.
TEST(SheppardLesage, flat_bands_enter_by_the_rate_at_the_lowest_place) {
  const RollerCone cone = cone_with(0.0, {outer});
  std::vector<BandStrip> strips;
  lay_strips(cone, {speed, 3e-3, 3}, {.half_angle = cone.journal_angle, .angles = 100001}, strips);
  double lowest = 0.0;
  for (const BandStrip& s : strips) lowest = std::max(lowest, s.normal.z());
  EXPECT_NEAR(lowest, 1.0, 1e-9);
  EXPECT_GT(strips.back().entering, 0.0);
}

/// The torque of the rows' slip about the journal changes its sign at the limits: of pulls that
/// know only the slip's sense, and of pulls in proportion to it.
RC_GTEST_PROP(SheppardLesage, limits_of_the_cone_speed_balance_their_pulls, ()) {
  const RollerCone cone = any_cone();
  std::vector<double> weights;
  for (std::size_t r = 0; r < cone.rows.size(); ++r) weights.push_back(*number(0.1, 5.0));
  const auto slips = [&](double ratio, auto pull) {
    double moment = 0.0;
    for (std::size_t r = 0; r < cone.rows.size(); ++r) {
      const RollerRow& row = cone.rows[r];
      const double lowest =
          row.along * std::cos(cone.journal_angle) + row.radius * std::sin(cone.journal_angle);
      moment += weights[r] * row.radius * pull(lowest - ratio * row.radius);
    }
    return moment;
  };
  const auto sense = [](double slip) { return slip > 0.0 ? 1.0 : -1.0; };
  const double friction = ratio_under_constant_friction(cone, weights);
  RC_ASSERT(slips(friction * (1.0 - 1e-9), sense) >= 0.0);
  RC_ASSERT(slips(friction * (1.0 + 1e-9), sense) <= 0.0);
  const double viscous = ratio_under_viscous_slip(cone, weights);
  RC_ASSERT(std::abs(slips(viscous, [](double slip) { return slip; })) <= 1e-14);
}

TEST(SheppardLesage, the_speed_follows_in_the_time_of_its_inertia) {
  const RollerCone cone = cone_with(4e-3, {outer, inner});
  RollerCone heavy = cone;
  heavy.inertia *= 10.0;
  int evaluations = 0;
  const BandMotion motion{speed, 3e-3, 3};
  const double lag = free_cone(cone, rock, motion, {}, evaluations).lag;
  EXPECT_GT(lag, 0.0);
  EXPECT_NEAR(free_cone(heavy, rock, motion, {}, evaluations).lag, 10.0 * lag, 1e-9 * lag);
  EXPECT_LE(evaluations, 40);
}

template <typename F>
std::string refusal(const F& f) {
  try {
    f();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(SheppardLesage, rejects_missing_input) {
  EXPECT_EQ(refusal([] { sheppard_lesage({}, rock, speed, 2e-3); }),
            "Sheppard and Lesage: found a bit without cones, expected at least one");
  EXPECT_EQ(refusal([] { sheppard_lesage(three_cones(0.0, {}), rock, speed, 2e-3); }),
            "Sheppard and Lesage: found a cone without rows, expected at least one");
  EXPECT_EQ(refusal([] { sheppard_lesage(three_cones(0.0, {outer}), rock, speed, -1.0); }),
            "Sheppard and Lesage: found -1 for the advance, expected a positive number");
  RollerRow nose = outer;
  nose.radius = 0.0;
  EXPECT_EQ(refusal([&] { sheppard_lesage(three_cones(0.0, {nose}), rock, speed, 2e-3); }),
            "Sheppard and Lesage: found a row on its journal, expected one around it");
  const std::string speeds = refusal([] {
    sheppard_lesage(three_cones(0.0, {outer}), rock, speed, 2e-3,
                    {.least_ratio = 0.5, .greatest_ratio = 1.0});
  });
  EXPECT_EQ(speeds.find("Sheppard and Lesage: the speed of a free cone (rad/s): found no root"),
            0U);
  const std::string heavy =
      refusal([] { sheppard_lesage_under(three_cones(0.0, {outer}), rock, speed, 1e9); });
  EXPECT_EQ(heavy.find("Sheppard and Lesage: the advance under the weight (m): found no root"), 0U);
}

}  // namespace
}  // namespace tdbd::reference::sheppard_lesage_test
