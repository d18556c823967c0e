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

void read_output(Config c, ChainCase& r) {
  using namespace chain_output_keys;
  r.history_every = c.read(history_every, usual_history_every(r.time.steps));
  const auto& e = r.plan.chain.elements;
  const double length = e.length * r.plan.chain.count();
  for (const double depth : c.read(string_depths, std::optional(std::vector<double>{}))) {
    const bool inside = depth >= 0.0 && depth <= length * (1.0 + 1e-9);
    if (inside) r.nodes.push_back(static_cast<int>(std::lround(depth / e.length)));
    if (!inside && c.problem_count() == 0)
      c.problem(string_depths, fmt::format("{:.6g} m", depth),
                fmt::format("depths of the string, 0 to {:.6g} m", length));
  }
  if (!c.has(string_profile_every)) return;
  const double steps = c.read(string_profile_every) / std::max(r.time.step, 1e-300);
  r.profile_every = std::max(1L, std::lround(std::min(steps, 1e15)));
}

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

std::vector<StaticLoad> static_loads(const ChainPlan& plan) {
  string::Chain c = plan.chain;
  c.axial_damping = c.torsional_damping = 0.0;
  c.threshold = 0.0;
  const double hanging = plan.bit.gravity_force;
  std::vector<StaticLoad> loads;
  const auto add = [&](const char* name, const string::SteadyMotion& m) {
    loads.push_back({name, string::steady_load(c, m)});
  };
  if (c.directions != string::Directions::torsion) {
    add("pull_up", {-1.0, 0.0, hanging, 0.0});
    add("slack_off", {1.0, 0.0, hanging, 0.0});
  }
  if (c.directions != string::Directions::axial) add("rotate", {0.0, 1.0, hanging, 0.0});
  if (plan.motion.pull != hanging || plan.motion.torque != 0.0)
    add("drill", {0.0, 1.0, plan.motion.pull, plan.motion.torque});
  return loads;
}

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
  read_output(c.table(chain_output_keys::table), r);
  c.finish();
  doubt_buckling(c, r);
  r.files = c.files();
  r.resolved = c.resolved();
  r.hash = fnv1a_hex(c.fingerprint());
  return r;
}

}  // namespace tdbd::simulation
