#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/roller_case.hpp"
#include "reference/compare/models/tooth_parts.hpp"
#include "reference/literature/roller/craters/huang_cawthorne.hpp"
#include "reference/literature/roller/craters/ma_zhou_deng.hpp"

/// Ma, Zhou and Deng, and both methods of Huang and Cawthorne: teeth over craters, under a weight.
namespace tdbd::reference {
namespace {

constexpr double full_turn_of_bit = 2.0 * std::numbers::pi;
constexpr double longest_crater_step = 0.25e-3;  // s: at 1 ms teeth lock into the previous prints

RollerSchedule schedule_of(const Question& q, const std::string& model) {
  if (q.weight <= 0.0)
    throw InputError(model +
                     ": found no weight, needs compare.weight_on_bit or a model beside it "
                     "that finds one");
  const simulation::Case& c = q.asked.ours;
  RollerSchedule s;
  s.bit_speed = c.motion.rotary_speed;
  s.weight = q.weight;
  s.step = std::min(c.time.step, longest_crater_step);
  s.revolutions = c.time.step * static_cast<double>(c.time.steps) * s.bit_speed / full_turn_of_bit;
  s.settle = std::max(0.0, s.revolutions - q.asked.options.counted_revolutions);
  return s;
}

/// Sets the options that all these models take from the case.
void take_case(const CompareCase& c, const RollerBit& bit, CraterDrillingOptions& drilling) {
  drilling.sliding.friction = tooth_friction(c, drilling.model);
  drilling.print.sphere_radius = largest_tooth(bit);
  drilling.first_ratio = outer_rolling_ratio(bit);
}

void say_cones_of_run(const CompareCase& c, const RollerRun& run, Findings& f) {
  double sum = 0.0;
  for (std::size_t k = 0; k < run.cone_ratio.size(); ++k) {
    f.parts.push_back(
        {c.ours.bit.cones[k].name, 0.0, PartQuantity::cone_speed_ratio, -run.cone_ratio[k]});
    sum -= run.cone_ratio[k];
  }
  say(f, Quantity::cone_speed_ratio, sum / static_cast<double>(run.cone_ratio.size()));
  say(f, Quantity::teeth_in_contact, run.contacts);
  say(f, Quantity::teeth_in_contact_variance, run.contacts_variance);
}

/// Number of counted steps of the model, which has its own step size.
std::size_t counted_of(const CompareCase& c, const RollerSchedule& schedule,
                       const RollerSeries& series) {
  const double steps =
      c.options.counted_revolutions * full_turn_of_bit / (schedule.bit_speed * schedule.step);
  return std::min(static_cast<std::size_t>(std::lround(steps)), series.torque.size());
}

/// Sets the noise of the counted steps, and the mean magnitude of their lateral force.
void say_steps(const CompareCase& c, const RollerRun& run, const RollerSchedule& schedule,
               Findings& f) {
  const RollerSeries& s = run.series;
  const std::size_t counted = counted_of(c, schedule, s);
  const auto from = static_cast<std::ptrdiff_t>(s.torque.size() - counted);
  f.series = {schedule.step,
              {s.weight.begin() + from, s.weight.end()},
              {s.torque.begin() + from, s.torque.end()}};
  const double together = 5e-3 / schedule.step;
  say(f, Quantity::torque_noise, noise_of(f.series.torque, 1).share);
  say(f, Quantity::torque_noise_5ms,
      noise_of(f.series.torque, static_cast<std::size_t>(std::lround(together))).share);
  double side = 0.0;
  for (std::size_t i = s.side_x.size() - counted; i < s.side_x.size(); ++i)
    side += std::hypot(s.side_x[i], s.side_y[i]);
  say(f, Quantity::side_force, side / static_cast<double>(counted));
}

BottomCircle circle_of(const CompareCase& c, const ZMap& bottom) {
  BottomCircle circle{c.options.circle, {}};
  for (int i = 0; i < c.options.circle_samples; ++i) {
    const double azimuth = full_turn_of_bit * i / c.options.circle_samples;
    circle.depth.push_back(
        level_at(bottom, circle.radius * std::cos(azimuth), circle.radius * std::sin(azimuth)));
  }
  return circle;
}

Findings findings_of(const Question& q, const RollerBit& bit, const RollerRun& run,
                     const RollerSchedule& schedule) {
  const CompareCase& c = q.asked;
  Findings f;
  say(f, Quantity::rate_at_weight, run.rate);
  say(f, Quantity::torque_at_weight, run.torque);
  say(f, Quantity::removed_per_revolution, run.volumes.dug / schedule.revolutions);
  say(f, Quantity::resolution_at_gage, run.bottom.cell());
  say_steps(c, run, schedule, f);
  say_cones_of_run(c, run, f);
  set_tooth_quantities(c, bit,
                       {run.tooth_force, run.tooth_largest, run.tooth_contacts,
                        over(run.tooth_volume, schedule.revolutions)},
                       f);
  f.bottom = circle_of(c, run.bottom);
  f.cost.steps = static_cast<long>(run.series.time.size());
  f.cost.simulated = schedule.step * static_cast<double>(f.cost.steps);
  if (schedule.step < c.ours.time.step)
    f.notes.push_back(fmt::format(
        "its step is {:g} ms, not the case's: at 1 ms teeth lock into the prints of those before",
        1e3 * schedule.step));
  if (run.beyond_law > 0)
    f.notes.push_back("teeth went deeper than the table's last row in " +
                      std::to_string(run.beyond_law) + " tooth-steps");
  set_missing(f, {Quantity::weight, Quantity::torque, Quantity::work_of_a_turn_torque},
              "it finds the rate of a weight, not the weight of a rate");
  set_missing(f, {Quantity::imbalance, Quantity::imbalance_direction},
              "its bit keeps to the hole's axis: what pushes it aside is not summed in its frame");
  set_missing(f, Quantity::torque_noise_by_crossing, no_spokes);
  set_missing(f, Quantity::share_moved_backwards, no_cutters);
  set_missing(f, flats, no_wear);
  return f;
}

Findings run_patent_model(const Question& q, PatentMethod way) {
  const RollerBit bit = roller_bit_of(q.asked.ours.bit, "Huang and Cawthorne");
  HuangCawthorneOptions options;
  options.way = way;
  take_case(q.asked, bit, options.drilling);
  options.first_ratio = options.drilling.first_ratio;
  const RollerSchedule schedule = schedule_of(q, "Huang and Cawthorne");
  const ToothTable table = tooth_table_of(q.asked, bit, "Huang and Cawthorne");
  return findings_of(q, bit, huang_cawthorne(bit, table, schedule, options), schedule);
}

}  // namespace

Findings run_ma_zhou_deng_model(const Question& q) {
  const RollerBit bit = roller_bit_of(q.asked.ours.bit, "Ma, Zhou and Deng");
  MaZhouDengOptions options;
  take_case(q.asked, bit, options.drilling);
  const RollerSchedule schedule = schedule_of(q, "Ma, Zhou and Deng");
  const ToothTable table = tooth_table_of(q.asked, bit, "Ma, Zhou and Deng");
  return findings_of(q, bit, ma_zhou_deng(bit, table, schedule, options), schedule);
}

Findings run_huang_cawthorne_1_model(const Question& q) {
  return run_patent_model(q, PatentMethod::first);
}

Findings run_huang_cawthorne_2_model(const Question& q) {
  return run_patent_model(q, PatentMethod::second);
}

}  // namespace tdbd::reference
