#include "reference/literature/drag/planes/behr.hpp"

#include <numbers>

#include "reference/compare/cpu_clock.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/led_bit.hpp"
#include "reference/literature/drag/planes/bottom_harmonics.hpp"

namespace tdbd::reference {
namespace {

BehrOptions options_of(const CompareCase& c) {
  BehrOptions o;
  o.planes = c.options.planes;
  o.nodes = c.options.plane_nodes;
  o.radius = spoke_reach(c);
  return o;
}

/// Mean in the bit's frame and mean magnitude of the lateral forces of the run's steps.
void say_lateral_of(const CompareCase& c, const BehrRun& run, long first_step, Findings& f) {
  Eigen::Vector2d mean_B = Eigen::Vector2d::Zero();
  double side = 0.0;
  for (std::size_t i = 0; i < run.lateral_W.size(); ++i) {
    const double t = run.dt * (static_cast<double>(first_step) + static_cast<double>(i) + 1.0);
    mean_B += Eigen::Rotation2Dd(-simulation::angle_turned(c.ours.motion, t)) * run.lateral_W[i];
    side += run.lateral_W[i].norm();
  }
  const double steps = static_cast<double>(run.lateral_W.size());
  set_lateral_quantities(mean_B / steps, side / steps, f);
}

void say_areas(const CompareCase& c, const BehrRun& run, double turns, Findings& f) {
  std::vector<CutterNumbers> numbers;
  for (std::size_t i = 0; i < run.cutters.size(); ++i) {
    const BehrCutter& cutter = run.cutters[i];
    numbers.push_back(
        {run.mean_area(i), cutter.volume / turns, cutter.force.normal, cutter.force.cutting});
  }
  set_cutter_quantities(c, numbers, f);
}

}  // namespace

Findings run_behr_model(const Question& q) {
  const CompareCase& c = q.asked;
  const CpuClock clock;
  const double dt = c.ours.time.step;
  const long counted = counted_steps(c), before = c.ours.time.steps - counted;
  BehrOptions options = options_of(c);
  const BitPath path = path_of(c);
  BehrState state = behr_start(c.ours.bit.cutters, path(0.0), options);
  behr_run(state, path, 0.0, dt, static_cast<int>(before), *c.rock, options);
  BehrState again = state;
  const double from = dt * static_cast<double>(before);
  const BehrRun run = behr_run(state, path, from, dt, static_cast<int>(counted), *c.rock, options);
  Findings f;
  f.cost = {clock.seconds(), dt * static_cast<double>(c.ours.time.steps), c.ours.time.steps};
  set_load_quantities(f, {dt, run.weight, run.torque}, c.advance);
  options.force_time = ForceTime::crossing;
  say(f, Quantity::torque_noise_by_crossing,
      noise_of(behr_run(again, path, from, dt, static_cast<int>(counted), *c.rock, options).torque,
               1)
          .share);
  say_lateral_of(c, run, before, f);
  say(f, Quantity::removed_per_revolution, run.removed() / c.options.counted_revolutions);
  say(f, Quantity::share_moved_backwards, run.backward_share());
  say(f, Quantity::resolution_at_gage,
      2.0 * std::numbers::pi * c.ours.bit.gage_radius / options.planes);
  say_areas(c, run, c.options.counted_revolutions, f);
  f.bottom = BottomCircle{c.options.circle, depth_on_circle(state.bottom, c.options.circle)};
  set_missing(f, of_weight, "its motion is given, and no force acts back on it");
  set_missing(f, flats, no_wear);
  set_missing(f, of_cones, no_cones);
  return f;
}

}  // namespace tdbd::reference
