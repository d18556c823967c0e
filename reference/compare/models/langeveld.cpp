#include <algorithm>
#include <numbers>

#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/led_bit.hpp"
#include "reference/literature/drag/planes/bottom_harmonics.hpp"
#include "reference/literature/drag/spokes/langeveld_path.hpp"

namespace tdbd::reference {
namespace {

/// Rock that fits the bit at its start, up to the centre of its highest cutter.
LangeveldRock rock_around(const CompareCase& c, const std::vector<SpokeCutter>& cutters) {
  double highest = 0.0;
  for (const SpokeCutter& cutter : cutters) highest = std::max(highest, -cutter.centre_B.z());
  return fitting_rock(cutters, 0.0, -highest, c.options.spokes, c.options.spoke_nodes,
                      spoke_reach(c));
}

/// A rim can enter the wall only in whirl.
LangeveldContact contact_of(const CompareCase& c, const std::vector<SpokeCutter>& cutters) {
  LangeveldContact contact;
  if (c.ours.motion.kind == simulation::MotionKind::whirl)
    contact.counted = CountedRock::within_rim;
  if (!c.tips) return contact;
  contact.law = LangeveldLaw::tip;
  contact.widths = tip_widths(cutters);
  return contact;
}

}  // namespace

Findings run_langeveld_model(const Question& q) {
  const CompareCase& c = q.asked;
  const std::vector<SpokeCutter> cutters = spoke_cutters(c.ours.bit.cutters, "Langeveld");
  LangeveldRock rock = rock_around(c, cutters);
  PathOptions options;
  options.step = c.ours.time.step;
  options.duration = options.step * static_cast<double>(c.ours.time.steps);
  options.counted = options.step * static_cast<double>(counted_steps(c));
  const PathRun run = langeveld_path(cutters, c.tips ? *c.tips : *c.rock, rock, path_of(c), options,
                                     contact_of(c, cutters));
  Findings f;
  set_path_run_quantities(c, run, f);
  say(f, Quantity::resolution_at_gage,
      2.0 * std::numbers::pi * c.ours.bit.gage_radius / c.options.spokes);
  f.bottom = BottomCircle{c.options.circle, depth_on_circle(rock.bottom, c.options.circle)};
  if (c.tips) f.notes.emplace_back(law_of_tips);
  set_missing(f, of_weight, given_rate);
  set_missing(f, flats, no_wear);
  set_missing(f, of_cones, no_cones);
  return f;
}

}  // namespace tdbd::reference
