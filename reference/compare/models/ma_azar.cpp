#include <fmt/format.h>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/roller_case.hpp"
#include "reference/compare/models/tooth_parts.hpp"
#include "reference/literature/roller/teeth/contact_run.hpp"
#include "reference/literature/roller/teeth/contact_statistics.hpp"

namespace tdbd::reference {
namespace {

/// The case's schedule: the same steps, and means over the same revolutions.
ContactSchedule contact_schedule(const CompareCase& c, const RollerBit& bit) {
  ContactSchedule s;
  s.ratios.assign(bit.cones.size(), c.options.roller.cone_ratio.value_or(outer_rolling_ratio(bit)));
  s.bit_speed = c.ours.motion.rotary_speed;
  s.penetration = c.options.roller.penetration.value_or(c.advance);
  s.step = c.ours.time.step;
  s.duration = s.step * static_cast<double>(c.ours.time.steps);
  s.settle = s.duration - s.step * static_cast<double>(counted_steps(c));
  return s;
}

/// The share of time in which a tooth is in contact is the mean number of contacts of that tooth.
void say_contacts(const CompareCase& c, const RollerBit& bit, const ContactRun& run, Findings& f) {
  say(f, Quantity::teeth_in_contact, run.mean);
  say(f, Quantity::teeth_in_contact_variance, run.variance);
  set_tooth_values_and_sums(c, bit, PartQuantity::teeth_in_contact, run.tooth_share, f);
}

/// The result of the closed form, if the bit satisfies its assumptions.
std::string statistics_of(const RollerBit& bit, const ContactSchedule& s) {
  try {
    const ContactStatistics all = bit_contact(bit, s.ratios, s.bit_speed, s.penetration).all;
    return fmt::format(
        "the statistics of rows that turn independently give {:.4g} teeth, variance {:.4g}",
        all.mean, all.variance);
  } catch (const InputError& e) {
    return fmt::format("no statistics of independent rows: {}", e.what());
  }
}

}  // namespace

Findings run_ma_azar_model(const Question& q) {
  const CompareCase& c = q.asked;
  const RollerBit bit = roller_bit_of(c.ours.bit, "Ma and Azar");
  const ContactSchedule schedule = contact_schedule(c, bit);
  const ContactRun run = contact_run(bit, schedule);
  Findings f;
  say_contacts(c, bit, run, f);
  f.cost.steps = run.steps;
  f.cost.simulated = schedule.duration;
  f.notes.push_back(fmt::format(
      "given, not found: cones at {:.4f} of the bit's speed, all rows {:.3g} mm in a flat bottom",
      schedule.ratios.front(), 1e3 * schedule.penetration));
  f.notes.push_back(statistics_of(bit, schedule));
  set_missing(f, {Quantity::weight, Quantity::torque, Quantity::work_of_a_turn_torque},
              "kinematics and counting: it has no forces");
  set_missing(f, of_weight, "kinematics and counting: it has no forces");
  set_missing(f, lateral, "kinematics and counting: it has no forces");
  set_missing(f, noises, "kinematics and counting: it has no forces");
  set_missing(f, Quantity::torque_noise_by_crossing, no_spokes);
  set_missing(f, Quantity::removed_per_revolution, "its bottom is flat and stays so");
  set_missing(f, Quantity::cone_speed_ratio, "cone speeds are its input");
  set_missing(f, Quantity::resolution_at_gage, "it keeps no bottom");
  set_missing(f, Quantity::share_moved_backwards, no_cutters);
  set_missing(f, flats, no_wear);
  return f;
}

}  // namespace tdbd::reference
