#include <numbers>

#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/led_bit.hpp"
#include "reference/literature/drag/planes/bottom_harmonics.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_path.hpp"

namespace tdbd::reference {
namespace {

constexpr int depth_nodes = 2000;  // of the bottom as a function of r

}  // namespace

Findings run_hanson_hansen_model(const Question& q) {
  const CompareCase& c = q.asked;
  if (!c.ours.bit.cones.empty()) return run_hanson_hansen_cones_model(q);
  const std::vector<SpokeCutter> cutters = spoke_cutters(c.ours.bit.cutters, "Hanson and Hansen");
  const HansonHansenRock law = hanson_hansen_rock(c);
  PathOptions options;
  options.step = c.ours.time.step;
  options.duration = options.step * static_cast<double>(c.ours.time.steps);
  options.counted = options.step * static_cast<double>(counted_steps(c));
  OutlineSpokes rock =
      fitting_outline_rock(cutters, c.ours.motion.rate_of_penetration * options.duration,
                           {c.options.spokes, c.options.spoke_spacing});
  const double reach = spoke_reach(c);
  const PathRun run = hanson_hansen_path(cutters, law, rock, path_of(c), options);
  Findings f;
  set_path_run_quantities(c, run, f);
  say(f, Quantity::resolution_at_gage,
      2.0 * std::numbers::pi * c.ours.bit.gage_radius / c.options.spokes);
  f.bottom = BottomCircle{c.options.circle,
                          depth_on_circle(deepest(rock, reach, depth_nodes), c.options.circle)};
  set_missing(f, of_weight, given_rate);
  set_missing(f, flats, no_wear);
  set_missing(f, of_cones, no_cones);
  return f;
}

}  // namespace tdbd::reference
