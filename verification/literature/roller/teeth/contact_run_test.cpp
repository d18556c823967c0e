#include "reference/literature/roller/teeth/contact_run.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/files/bit_file.hpp"
#include "core/error.hpp"
#include "reference/literature/roller/craters/crater_bottom.hpp"
#include "reference/literature/roller/roller_bit_of.hpp"
#include "reference/literature/roller/teeth/contact_statistics.hpp"
#include "reference/literature/roller/teeth/round_end.hpp"
#include "verification/battery/generators.hpp"
#include "verification/literature/roller/example_roller_bit.hpp"

namespace tdbd::reference::contact_run_test {

using battery::integer;
using battery::number;

constexpr double pi = std::numbers::pi, degree = pi / 180.0;
constexpr double speed = 3.0 * pi;  // 90 rpm
constexpr double ratio = 1.37;
constexpr double rounding = 5e-15;  // of a share of the time and of a number of teeth

RollerRow even_row(int teeth, double first = 0.0) {
  RollerRow row{80e-3, 60e-3, 6e-3, {}};
  for (int i = 0; i < teeth; ++i) row.angles.push_back(first + 2.0 * pi * i / teeth);
  return row;
}

RollerBit one_cone(const std::vector<RollerRow>& rows) {
  return {{{0.0, 36.0 * degree, 4e-3, 0.0, 0.0, rows}}};
}

/// Time in which a row turns by so many pitches, s.
double time_of_pitches(int pitches, int teeth) {
  return 2.0 * pi * pitches / (teeth * ratio * speed);
}

ContactSchedule schedule(double penetration, double duration) {
  return {{ratio}, speed, penetration, duration};
}

/// Over whole pitches the algorithm must find the closed form of an even row.
RC_GTEST_PROP(ContactRun,
              of_an_even_row_over_whole_pitches_has_the_mean_and_variance_in_closed_form, ()) {
  const int teeth = *integer(1, 40), pitches = *integer(1, 30);
  RollerBit bit = one_cone({even_row(teeth, *number(0.0, 6.0))});
  bit.cones[0].journal_angle = *number(0.0, 1.2);
  const double depth = 60e-3 * std::cos(bit.cones[0].journal_angle) * *number(0.001, 1.9);
  const ContactRun run = contact_run(bit, schedule(depth, time_of_pitches(pitches, teeth)));
  const RowContact closed = row_contact(bit.cones[0], bit.cones[0].rows[0], {depth, ratio, speed});
  RC_ASSERT(std::abs(run.mean - closed.mean) <= rounding * teeth);
  RC_ASSERT(std::abs(run.variance - closed.variance) <= rounding * teeth);
}

TEST(ContactRun, lets_teeth_touch_one_after_the_other_for_the_duration_in_closed_form) {
  constexpr int teeth = 25;
  const RollerBit bit = one_cone({even_row(teeth, 1.0)});
  const ContactRun run = contact_run(bit, schedule(2e-3, 2.0));
  const double lasts =
      row_contact(bit.cones[0], bit.cones[0].rows[0], {2e-3, ratio, speed}).duration;
  constexpr double instant = 1.5e-15;  // s, rounding of instants up to 2 s
  std::size_t inner = 0;
  for (std::size_t i = 1; i < run.contacts.size(); ++i) {
    const ToothInRock &last = run.contacts[i - 1], &c = run.contacts[i];
    if (last.entry == 0.0 || c.exit == 2.0) continue;
    ++inner;
    EXPECT_EQ(c.tooth, (last.tooth + 1) % teeth);
    EXPECT_NEAR(c.entry - last.entry, time_of_pitches(1, teeth), instant);
    EXPECT_NEAR(c.exit - c.entry, lasts, instant);
  }
  EXPECT_GT(inner, 40U);
}

/// Two rows in phase touch with two teeth at once: four times the variance of one, where the statistics of
/// independent rows say twice.
TEST(ContactRun, keeps_the_phase_of_rows_on_one_cone) {
  constexpr int teeth = 15;
  const double whole = time_of_pitches(teeth, teeth);
  const ContactRun one = contact_run(one_cone({even_row(teeth)}), schedule(2e-3, whole));
  const ContactRun two =
      contact_run(one_cone({even_row(teeth), even_row(teeth)}), schedule(2e-3, whole));
  EXPECT_GT(one.variance, 0.2);
  EXPECT_NEAR(two.mean, 2.0 * one.mean, rounding);
  EXPECT_NEAR(two.variance, 4.0 * one.variance, rounding);
}

/// A second cone that turns at an unrelated speed is independent in the long run.
TEST(ContactRun, of_cones_at_unrelated_speeds_tends_to_the_sum_of_their_variances) {
  RollerBit bit = one_cone({even_row(15)});
  bit.cones.push_back(bit.cones[0]);
  ContactSchedule s = schedule(2e-3, 400.0);
  s.ratios = {ratio, ratio * std::numbers::phi};
  s.step = 20e-3;
  const ContactRun run = contact_run(bit, s);
  const double one = row_contact(bit.cones[0], bit.cones[0].rows[0], {2e-3, ratio, speed}).variance;
  constexpr double of_the_length = 2e-5;  // of the variance; some 10^4 contacts; seen: 7e-6
  EXPECT_NEAR(run.variance, 2.0 * one, of_the_length);
}

RC_GTEST_PROP(ContactRun, is_the_same_for_any_step, ()) {
  const RollerBit bit = one_cone({even_row(*integer(1, 7)), even_row(*integer(1, 7), 0.3)});
  ContactSchedule s = schedule(*number(0.01, 60.0) * 1e-3, *number(0.1, 2.0));
  const ContactRun fine = contact_run(bit, s);
  s.step = *number(10.0, 200.0) * 1e-3;  // up to 148 degrees of the cone
  const ContactRun coarse = contact_run(bit, s);
  RC_ASSERT(coarse.contacts.size() == fine.contacts.size());
  for (std::size_t i = 0; i < fine.contacts.size(); ++i) {
    RC_ASSERT(coarse.contacts[i].tooth == fine.contacts[i].tooth);
    RC_ASSERT(std::abs(coarse.contacts[i].entry - fine.contacts[i].entry) <= rounding);
    RC_ASSERT(std::abs(coarse.contacts[i].exit - fine.contacts[i].exit) <= rounding);
  }
}

TEST(ContactRun, takes_means_after_settling) {
  constexpr int teeth = 15;
  const RollerBit bit = one_cone({even_row(teeth, 0.2)});
  ContactSchedule s = schedule(2e-3, time_of_pitches(1, teeth));
  s.settle = 0.4 * s.duration;
  s.duration += s.settle;
  const ContactRun run = contact_run(bit, s);
  const RowContact closed = row_contact(bit.cones[0], bit.cones[0].rows[0], {2e-3, ratio, speed});
  EXPECT_NEAR(run.mean, closed.mean, rounding);
  EXPECT_NEAR(run.variance, closed.variance, rounding);
  double shares = 0.0, times = 0.0;
  for (const double share : run.tooth_share) shares += share;
  for (const double share : run.count_share) times += share;
  EXPECT_NEAR(shares, run.mean, rounding);
  EXPECT_NEAR(times, 1.0, rounding);
}

/// A tooth of our bit: its tip, and z where its row is lowest (m, B).
struct OurTooth {
  const bit::Part* part;
  Vec3 tip_P;
  double lowest;
};

std::vector<OurTooth> our_teeth(const bit::Bit& ours) {
  std::vector<OurTooth> teeth;
  for (const bit::Part& part : ours.parts) {
    if (part.kind != bit::PartKind::tooth) continue;
    const bit::Cone& cone = ours.cones[at(part.cone)];
    const double height = bit::row_measures(cone, cone.layout.rows[at(part.row)]).height;
    teeth.push_back({&part, bit::tooth_tip_P(part), -height});
  }
  return teeth;
}

/// The teeth in rock at an instant, by the tips of our meshes on our cones.
std::vector<bool> touching(const bit::Bit& ours, const std::vector<OurTooth>& our,
                           const ContactSchedule& s, double time) {
  std::vector<double> angles;
  for (const double r : s.ratios) angles.push_back(-r * s.bit_speed * time);
  std::vector<bool> teeth;
  for (const OurTooth& tooth : our) {
    const Vec3 tip_B = bit::part_pose(ours, *tooth.part, angles) * tooth.tip_P;
    teeth.push_back(tip_B.z() > tooth.lowest - s.penetration);
  }
  return teeth;
}

std::vector<bool> touching(const ContactRun& run, double time) {
  std::vector<bool> teeth(run.tooth_share.size(), false);
  for (const ToothInRock& c : run.contacts)
    if (c.entry < time && time < c.exit) teeth[c.tooth] = true;
  return teeth;
}

/// Bit R has skewed journals, rows of several pitches and a tooth on a journal.
RC_GTEST_PROP(ContactRun, finds_the_teeth_of_bit_r_that_the_cones_of_tdbd_put_into_the_bottom, ()) {
  static const bit::Bit ours = bit::read_bit(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml",
                                             bit::DirectionRule::hybrid, bit::InsideRule::down)
                                   .bit;
  static const std::vector<OurTooth> our = our_teeth(ours);
  static const RollerBit roller = roller_bit_of(ours);
  ContactSchedule s = schedule(*number(0.1, 8.0) * 1e-3, 1.0);
  s.ratios = {*number(1.0, 2.0), *number(1.0, 2.0), *number(-2.0, 2.0)};
  const ContactRun run = contact_run(roller, s);
  for (int i = 0; i < 20; ++i) {
    const double time = *number(0.001, 0.999);
    RC_ASSERT(touching(run, time) == touching(ours, our, s, time));
  }
}

std::string refusal(const RollerBit& bit, const ContactSchedule& s) {
  try {
    contact_run(bit, s);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ContactRun, rejects_bits_and_schedules_without_an_answer) {
  const RollerBit bit = one_cone({even_row(5)});
  const ContactSchedule good = schedule(1e-3, 1.0);
  EXPECT_EQ(refusal(bit, good), "");
  EXPECT_EQ(refusal({}, good),
            "Ma and Azar: found a bit without cones, expected a roller cone bit");
  EXPECT_EQ(refusal(one_cone({}), good),
            "Ma and Azar: found cones without teeth, expected at least one");
  ContactSchedule s = good;
  s.ratios = {1.0, 1.0};
  EXPECT_EQ(refusal(bit, s), "Ma and Azar: found 2 cone speeds, expected one for each of 1 cones");
  s = good;
  s.penetration = std::nan("");
  EXPECT_EQ(refusal(bit, s),
            "Ma and Azar: found a penetration that is not finite, expected metres");
  s = good;
  s.step = 0.0;
  EXPECT_EQ(
      refusal(bit, s),
      "Ma and Azar: found a duration, step or bit speed that is not above 0; needs all three");
  s = good;
  s.settle = 1.0;
  EXPECT_EQ(refusal(bit, s), "Ma and Azar: found means from 1 s on, expected 0 to 1 s");
  s = good;
  s.step = 0.25;
  EXPECT_EQ(
      refusal(bit, s),
      "Ma and Azar: found a step of 0.25 s in which a cone makes half a turn or more, expected "
      "a shorter one");
}

/// A ring begins to carry at once, as wide as it is: by a law that is smooth at 0, and by a table that
/// begins with a slope; scale: the law's force.
constexpr double of_power = 0.03, of_table = 0.15;

double force_on(const ZMap& bottom, const RoundEnd& end, const ToothLaw& law, double depth) {
  std::vector<double> gaps(end.points.size());
  touch_round_end(end, Vec3::Zero(), bottom, gaps.data());
  return round_end_force(end, law, gaps.data(), depth);
}

TEST(RoundEnd, feels_the_law_itself_on_flat_rock) {
  const RoundEnd end = round_end(6e-3, 0.5e-3, 4e-3);
  const ZMap bottom = flat_z_map(10e-3, 0.0, 40);
  for (const auto& [law, of_rings] : {std::pair{ToothLaw(example::power_tooth()), of_power},
                                      std::pair{ToothLaw(example::tooth_table()), of_table}})
    for (const double depth : {1e-3, 1.7e-3, 2.4e-3}) {
      const double expected = tooth_force(law, depth);
      EXPECT_NEAR(force_on(bottom, end, law, depth), expected, of_rings * expected) << depth;
    }
}

/// In its own crater a tooth feels nothing; its point alone would not know of the ridge beside it.
TEST(RoundEnd, feels_the_ridge_beside_its_point_and_nothing_in_its_own_crater) {
  const RoundEnd end = round_end(6e-3, 0.5e-3, 4e-3);
  const ToothLaw law = example::power_tooth();
  ZMap bottom = flat_z_map(12e-3, 0.0, 240);
  dig(bottom, {Vec3(0, 0, 1e-3), 1e-3, 6e-3, CraterShape::sphere});
  EXPECT_LT(force_on(bottom, end, law, 0.99e-3), 0.01 * tooth_force(law, 1e-3));
  ZMap ridge = flat_z_map(12e-3, 0.0, 240);
  dig(ridge, {Vec3(-1.5e-3, 0, 1e-3), 1e-3, 6e-3, CraterShape::sphere});
  const double there = level_at(ridge, 0.0, 0.0);
  EXPECT_GT(force_on(ridge, end, law, 0.99 * there), 0.05 * tooth_force(law, 1e-3));
}

}  // namespace tdbd::reference::contact_run_test
