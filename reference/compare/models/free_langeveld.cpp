#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/free_run.hpp"
#include "reference/compare/models/free_string.hpp"
#include "reference/literature/drag/planes/bottom_harmonics.hpp"
#include "reference/literature/drag/spokes/langeveld.hpp"

namespace tdbd::reference {
namespace {

constexpr double free_margin = 5e-3;  // m, of spokes beyond the gage

LangeveldSystem langeveld_system(const CompareCase& c, const FreeString& s) {
  LangeveldSystem l;
  l.mass = s.mass, l.inertia = s.inertia;
  l.lateral_stiffness = s.lateral_stiffness;
  l.axial_stiffness = s.axial_stiffness, l.axial_damping = s.axial_damping;
  l.twist_stiffness = s.twist_stiffness;
  l.rate = s.rate, l.speed = s.speed;
  l.top_z = s.top_z, l.top_angle = s.top_angle;
  l.wall.stiffness = c.ours.drilling.system.wall.stiffness;
  l.rock = c.tips ? *c.tips : *c.rock;
  if (c.tips) {
    l.law = LangeveldLaw::tip;
    l.widths = tip_widths(spoke_cutters(c.ours.bit.cutters, "Langeveld"));
  }
  l.step = c.ours.time.step;
  return l;
}

Langeveld langeveld_model(const CompareCase& c, const FreeString& s) {
  const std::vector<SpokeCutter> rims = spoke_cutters(c.ours.bit.cutters, "Langeveld");
  const double clearance = c.ours.drilling.system.wall.clearance;
  double highest = 0.0;
  for (const SpokeCutter& cutter : rims) highest = std::max(highest, -cutter.centre_B.z());
  LangeveldRock rock = fitting_rock(rims, s.z, s.z - highest, c.options.spokes,
                                    c.options.spoke_nodes, widest_reach(rims) + free_margin);
  for (double& radius : rock.wall.radius) radius += clearance;
  return langeveld(c.ours.bit.cutters, langeveld_system(c, s), std::move(rock),
                   {0, 0, s.z, 0, 0, 0, s.start_rate, s.speed});
}

/// Throws if the bit is where the spokes end, because the rock beyond them is not known.
void check_on_spokes(const Langeveld& m) {
  const double off = std::hypot(m.state[0], m.state[1]);
  if (off > free_margin && off < 1.0)
    throw InputError(fmt::format(
        "Langeveld: found a bit that whirls {:.3g} m beside the axis at {:.4g} s, where its spokes "
        "end; needs a stiffer string",
        off, m.time));
}

/// Each node represents its share of ring and sector.
double hole_volume(const Spokes& bottom) {
  double sum = 0.0;
  for (std::size_t i = 0; i < bottom.depth.size(); ++i)
    sum += bottom.depth[i] * bottom.node_radius(static_cast<int>(i) % bottom.nodes);
  return sum * bottom.node_spacing() * 2.0 * std::numbers::pi / bottom.spokes;
}

}  // namespace

Findings run_free_langeveld_model(const Question& q) {
  const CompareCase& c = q.asked;
  Langeveld m = langeveld_model(c, free_string(c, StringTerms::springs, "Langeveld"));
  FreeModel model;
  model.title = "Langeveld";
  model.advance = [&m] { advance(m); };
  model.now = [&m] {
    const LangeveldState& y = m.state;
    check_on_spokes(m);
    return FreeInstant{{Vec3(y[0], y[1], y[2]), y[3]}, Vec3(y[4], y[5], y[6]), y[7]};
  };
  model.hole = [&m] { return hole_volume(m.rock.bottom); };
  model.force_W = &m.load.cutter_force_W;
  model.area = &m.load.cutter_area;
  model.torque = &m.load.torque;
  Findings f;
  run_free_model(c, model, f);
  say(f, Quantity::resolution_at_gage,
      2.0 * std::numbers::pi * c.ours.bit.gage_radius / c.options.spokes);
  f.bottom = BottomCircle{c.options.circle, depth_on_circle(m.rock.bottom, c.options.circle)};
  f.notes.push_back(left_out(c, StringTerms::springs));
  if (c.tips) f.notes.emplace_back(law_of_tips);
  set_free_missing(f);
  return f;
}

}  // namespace tdbd::reference
