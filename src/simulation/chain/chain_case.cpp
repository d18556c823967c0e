#include "simulation/chain/chain_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/hash.hpp"
#include "simulation/case/history_rows.hpp"
#include "simulation/case/rotate_keys.hpp"
#include "simulation/case/title_key.hpp"

namespace tdbd::simulation {
namespace {

/// Where a compressed string would buckle, which a soft string does not: 2 sqrt(E I w sin/clearance).
void doubt_buckling(const Config& c, ChainCase& r) {
  const StringPlan& s = r.plan.string;
  if (s.hole_diameter == 0.0) return;
  for (const StaticLoad& l : static_loads(r.plan)) {
    for (int e = 0; e < r.plan.chain.count(); ++e) {
      const double top = e * r.plan.chain.elements.length;
      const double bottom = top + r.plan.chain.elements.length;
      const string::Section& here = *string::spans_between(s.sections, top, bottom)[0].section;
      const double side = string::tangent_at(s.survey, bottom).head<2>().norm() * here.weight;
      const double clearance = std::max(0.5 * s.hole_diameter - here.contact_radius, 1e-3);
      const double limit = 2.0 * std::sqrt(here.bending_rigidity * side / clearance);
      if (side == 0.0 || l.load.tension[at(e)] > -limit) continue;
      r.warnings.push_back(
          {c.place("string.hole_diameter"), "string.hole_diameter",
           fmt::format("{}: compressed with {:.3g} kN at {:.0f} m, beyond sinusoidal buckling at "
                       "{:.3g} kN, which is not modelled",
                       l.name, -1e-3 * l.load.tension[at(e)], top, 1e-3 * limit)});
      break;
    }
  }
}

}  // namespace

std::vector<DepthLoad> loads_by_depth(const ChainPlan& plan) {
  constexpr int depths = 50;
  const double length = plan.chain.elements.length * plan.chain.count();
  std::vector<DepthLoad> loads;
  for (int k = 1; k <= depths; ++k) {
    const double depth = length * k / depths;
    ChainPlan p = plan;
    p.string.sections.clear();
    for (const string::Span& s :
         string::spans_between(plan.string.sections, length - depth, length)) {
      p.string.sections.push_back(*s.section);
      p.string.sections.back().length = s.bottom - s.top;
    }
    const int count = std::max(2, plan.chain.count() * k / depths);
    p.chain.elements = string::make_elements(p.string.sections, count);
    p.chain.contact =
        string::make_contact(p.string.sections, p.string.survey, p.string.friction, count);
    p.bit.gravity_force = p.chain.contact.weight.back() +
                          plan.bit_weight * string::tangent_at(p.string.survey, depth).z();
    p.motion = {0.0, 0.0, p.bit.gravity_force, 0.0};
    DepthLoad here{depth};
    for (const StaticLoad& l : static_loads(p)) {
      const string::SurfaceLoad& surface = l.load.surface;
      if (l.name == "pull_up") here.pull_up = surface.hook_load;
      if (l.name == "slack_off") here.slack_off = surface.hook_load;
      if (l.name == "rotate") here.rotate = surface.hook_load;
      if (l.name == "rotate") here.torque = surface.torque;
    }
    loads.push_back(here);
  }
  return loads;
}

ChainCase read_chain_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  ChainCase r;
  r.path = path;
  r.title = c.read(title_keys::title);
  if (c.has(rotate_time_keys::table)) r.time = read_rotate_time(c.table(rotate_time_keys::table));
  r.plan = read_chain_plan(c, r.time.step, r.warnings);
  Config output = c.table(chain_output_keys::table);
  r.history_every =
      output.read(chain_output_keys::history_every, usual_history_every(r.time.steps));
  r.output = read_chain_output(output, r.plan.chain, r.time.step);
  c.finish();
  doubt_buckling(c, r);
  r.files = c.files();
  r.resolved = c.resolved();
  r.hash = fnv1a_hex(c.fingerprint());
  return r;
}

}  // namespace tdbd::simulation
