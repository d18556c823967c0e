#include <fmt/format.h>

#include <numbers>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/free_run.hpp"
#include "reference/compare/models/free_string.hpp"
#include "reference/compare/models/led_bit.hpp"
#include "reference/literature/drag/planes/bottom_harmonics.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_pdc.hpp"

namespace tdbd::reference {
namespace {

constexpr int free_depth_nodes = 2000;  // of the bottom as a function of r
constexpr double spare_depth = 50e-3;   // m, in addition to what the initial rate would drill

/// The setup prescribes no motion here: the bit starts as in the case, and the string's top is
/// where the case has it.
HansonHansenPdc hanson_hansen_model(const CompareCase& c, const FreeString& s) {
  const dynamics::Wall& wall = c.ours.drilling.system.wall;
  HansonHansenSetup setup;
  setup.system = hanson_hansen_system(c, s);
  setup.rock = hanson_hansen_rock(c);
  setup.spring = {wall.stiffness, wall.restitution};
  setup.layout = {c.options.spokes, c.options.spoke_spacing};
  setup.step = c.ours.time.step;
  setup.depth = s.start_rate * setup.step * static_cast<double>(c.ours.time.steps) + spare_depth;
  HansonHansenPdc m = hanson_hansen_pdc(c.ours.bit.cutters, setup);
  m.system.top_z = s.top_z - s.z;  // the model's bit starts at z = 0
  m.system.top_angle = s.top_angle;
  m.state[5] = s.start_rate;
  for (double& radius : m.wall.radius) radius += wall.clearance;
  return m;
}

FreeModel running(HansonHansenPdc& m) {
  FreeModel model;
  model.title = "Hanson and Hansen";
  const double floor = m.bottom.frame.floor;
  model.advance = [&m] { advance(m); };
  model.now = [&m, floor] {
    const HansonHansenState& y = m.state;
    const BitPlace place = place_in_rock(y);
    if (place.p_WB.z() > floor)
      throw InputError(
          fmt::format("Hanson and Hansen: found a bit deeper than its rock, {} m, needs one that "
                      "drills slower or does not diverge",
                      floor));
    return FreeInstant{place, Vec3(y[3], y[4], y[5] - y[9]), y[7]};
  };
  model.hole = [&m] { return -volume(m.bottom); };
  model.force_W = &m.cutter_force_W;
  model.area = &m.cutter_area;
  model.torque = &m.load.torque;
  return model;
}

}  // namespace

Findings run_free_hanson_hansen_model(const Question& q) {
  const CompareCase& c = q.asked;
  if (!c.ours.bit.cones.empty()) return run_free_hanson_hansen_cones_model(q);
  constexpr StringTerms terms = StringTerms::springs_and_dampers;
  HansonHansenPdc m = hanson_hansen_model(c, free_string(c, terms, "Hanson and Hansen"));
  Findings f;
  run_free_model(c, running(m), f);
  say(f, Quantity::resolution_at_gage,
      2.0 * std::numbers::pi * c.ours.bit.gage_radius / c.options.spokes);
  const Spokes bottom = deepest(m.bottom, spoke_reach(c), free_depth_nodes);
  f.bottom = BottomCircle{c.options.circle, depth_on_circle(bottom, c.options.circle)};
  f.notes.push_back(left_out(c, terms));
  set_free_missing(f);
  return f;
}

}  // namespace tdbd::reference
