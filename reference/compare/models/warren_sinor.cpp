#include "reference/literature/drag/plane/warren_sinor.hpp"

#include "reference/compare/models/answers.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::reference {
namespace {

/// Width of the columns, m. At the gage, where rims are steep, columns five times wider assign 5 %
/// of an area to a neighbour.
constexpr double plane_column = 0.01e-3;

void say_plane_cutters(const CompareCase& c, const WarrenSinorLoad& load, Findings& f) {
  for (std::size_t i = 0; i < load.cutters.size(); ++i) {
    const bit::Cutter& cutter = c.ours.bit.cutters[i];
    const WarrenSinorCutter& cut = load.cutters[i];
    const auto tell = [&](PartQuantity q, double value) {
      f.parts.push_back({simulation::cutter_name(cutter), cutter.tip_radius, q, value});
    };
    tell(PartQuantity::area, cut.area);
    tell(PartQuantity::volume_per_revolution, cut.volume);
    tell(PartQuantity::force_into_rock, cut.force.normal);
    tell(PartQuantity::drag, cut.force.cutting);
  }
}

void say_plane_at_weight(const CompareCase& c, double weight, const WarrenSinorOptions& options,
                         Findings& f) {
  if (weight <= 0.0) {
    set_missing(f, {Quantity::rate_at_weight, Quantity::torque_at_weight}, no_weight);
    return;
  }
  const WarrenSinorLoad load = warren_sinor_at_weight(c.ours.bit.cutters, weight, *c.rock, options);
  say(f, Quantity::rate_at_weight, load.rate(c.ours.motion.rotary_speed));
  say(f, Quantity::torque_at_weight, load.torque);
}

}  // namespace

Findings run_warren_sinor_model(const Question& q) {
  const CompareCase& c = q.asked;
  WarrenSinorOptions options;
  options.form = c.options.outline;
  options.column = plane_column;
  const WarrenSinorLoad load = warren_sinor(c.ours.bit.cutters, c.advance, *c.rock, options);
  Findings f;
  set_steady_load_quantities(f, load.weight, load.torque, c.advance);
  say(f, Quantity::imbalance, load.imbalance());
  say(f, Quantity::imbalance_direction, direction_of(load.imbalance_B()));
  say(f, Quantity::side_force, load.imbalance_B().norm());
  say(f, Quantity::removed_per_revolution, load.volume);
  say_plane_cutters(c, load, f);
  say_plane_at_weight(c, q.weight, options, f);
  set_missing(f, Quantity::share_moved_backwards, "the bit turns about a fixed axis");
  set_missing(f, Quantity::resolution_at_gage, "one plane stands for the whole bottom");
  set_missing(f, flats, "no wear: flats are input");
  set_missing(f, of_cones, no_cones);
  add_whirl_note(c, f);
  return f;
}

}  // namespace tdbd::reference
