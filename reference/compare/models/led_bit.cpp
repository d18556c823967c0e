#include "reference/compare/models/led_bit.hpp"

#include <algorithm>

#include "bit/cutter/cutter.hpp"
#include "reference/compare/models/blanks.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::reference {

BitPath path_of(const CompareCase& c) {
  return [&motion = c.ours.motion](double t) {
    return BitPlace{simulation::pose_at(motion, t).p, simulation::angle_turned(motion, t)};
  };
}

double spoke_reach(const CompareCase& c) {
  constexpr double margin = 2e-3;  // m
  return c.ours.bit.gage_radius + c.ours.motion.whirl.radius + margin;
}

HansonHansenRock hanson_hansen_rock(const CompareCase& c) {
  HansonHansenRock rock;
  rock.law = c.edges ? HansonHansenLaw::edges : HansonHansenLaw::area;
  if (c.edges) rock.edges = *c.edges;
  if (c.rock) rock.shared = *c.rock;
  return rock;
}

CutterNumbers forces_of(const bit::Cutter& cutter, const Vec3& force_B) {
  const Vec3 forward(-std::sin(cutter.azimuth), std::cos(cutter.azimuth), 0.0);
  return {0.0, 0.0, -force_B.dot(bit::profile_normal_B(cutter)), -force_B.dot(forward)};
}

void set_cutter_quantities(const CompareCase& c, const std::vector<CutterNumbers>& cutters,
                           Findings& f) {
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    const bit::Cutter& cutter = c.ours.bit.cutters[i];
    const auto tell = [&](PartQuantity q, double value) {
      f.parts.push_back({simulation::cutter_name(cutter), cutter.tip_radius, q, value});
    };
    tell(PartQuantity::area, cutters[i].area);
    tell(PartQuantity::volume_per_revolution, cutters[i].volume);
    tell(PartQuantity::force_into_rock, cutters[i].normal);
    tell(PartQuantity::drag, cutters[i].drag);
  }
}

void set_lateral_quantities(const Eigen::Vector2d& mean_B, double side, Findings& f) {
  say(f, Quantity::imbalance, mean_B.norm() / *saying(f, Quantity::weight).value);
  say(f, Quantity::imbalance_direction, direction_of(mean_B));
  say(f, Quantity::side_force, side);
}

std::vector<double> last_of(const std::vector<double>& values, long count) {
  const auto keep = std::min(count, static_cast<long>(values.size()));
  return {values.end() - keep, values.end()};
}

void set_path_run_quantities(const CompareCase& c, const PathRun& run, Findings& f) {
  const long counted = counted_steps(c);
  set_load_quantities(
      f, {c.ours.time.step, last_of(run.wob_spread, counted), last_of(run.tob_spread, counted)},
      c.advance);
  say(f, Quantity::torque_noise_by_crossing, noise_of(last_of(run.tob_by_step, counted), 1).share);
  set_lateral_quantities(run.lateral_B.head<2>(), run.side, f);
  say(f, Quantity::removed_per_revolution, run.lowered);
  say(f, Quantity::share_moved_backwards, run.backwards);
  std::vector<CutterNumbers> numbers(run.area.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = forces_of(c.ours.bit.cutters[i], run.force_B[i]);
    numbers[i].area = run.area[i];
    numbers[i].volume = run.volume[i];
  }
  set_cutter_quantities(c, numbers, f);
  f.cost.steps = run.steps;
  f.cost.simulated = c.ours.time.step * static_cast<double>(run.steps);
}

}  // namespace tdbd::reference
