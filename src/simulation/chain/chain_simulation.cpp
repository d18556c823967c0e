#include "simulation/chain/chain_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "simulation/case/rotate_settings.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {
namespace {

/// Frequency at which the blades of a regenerative bit pass a point, Hz; 0 for other bits.
double passing_frequency(const ChainPlan& p) {
  return p.bit.pitch > 0.0 ? p.rotary_speed / p.bit.pitch : 0.0;
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
  TitleSettings title;
  read_fields(c, title);
  r.title = title.title;
  if (c.has(RotateTimeSettings::table)) r.time = read_rotate_time(c);
  r.plan = read_chain_plan(c, r.time.step, r.warnings);
  check_rig_log(c, r.plan.log, r.time.step * static_cast<double>(r.time.steps));
  r.history_every = read_table(c, StringOutput{usual_history_every(r.time.steps)}).history_every;
  Config output = c.table(StringOutput::table);
  r.output = read_chain_output(output, r.plan.chain, r.time.step);
  c.finish();
  std::ranges::move(chain_warnings(c, {r.plan.string, r.plan.chain, static_loads(r.plan),
                                       r.plan.string.hole_diameter, passing_frequency(r.plan)}),
                    std::back_inserter(r.warnings));
  r.files = c.files();
  r.resolved = c.resolved();
  r.hash = fnv1a_hex(c.fingerprint());
  return r;
}

namespace {

void watch(const ChainCase& c, ChainSimulation& s) {
  ChainFigures& f = s.figures;
  f.node_steps_at_rest += s.work.resting;
  if (2 * s.steps_done < c.time.steps) return;
  const double speed = s.state.bit.rotary_speed;
  const bool first = 2 * s.steps_done < c.time.steps + 2 && f.bit_steps_at_rest == 0 &&
                     f.least_speed == 0.0 && f.largest_speed == 0.0;
  f.least_speed = first ? speed : std::min(f.least_speed, speed);
  f.largest_speed = first ? speed : std::max(f.largest_speed, speed);
  f.bit_steps_at_rest += speed == 0.0;
}

double balance(const ChainCase& c, const ChainSimulation& s) {
  return string::energy_balance(c.plan.chain, c.plan.bit, s.state);
}

}  // namespace

ChainSimulation start_chain(const ChainCase& c) {
  const ChainPlan& p = c.plan;
  const string::SteadyLoad load = string::steady_load(p.chain, p.motion);
  string::SteadyStart start = string::steady_start(p.chain, p.motion, load);
  ChainSimulation s;
  s.state.chain = std::move(start.chain);
  s.state.bit.displacement = start.end.displacement;
  s.state.bit.angle = start.end.angle;
  if (p.bit.law != string::BitLaw::fixed) {
    s.state.bit.velocity = start.end.velocity;
    s.state.bit.rotary_speed = p.motion.rotary_speed;
  }
  if (p.bit.law == string::BitLaw::regenerative) {
    const double speed = p.rotary_speed;
    string::start_cut(p.bit, speed > 0.0 ? p.rate * p.bit.pitch / speed : 0.0, s.state.bit);
  }
  s.work = string::chain_work(p.chain, s.state.chain, string::motion_of(s.state.bit));
  s.figures.start_balance = balance(c, s);
  return s;
}

void advance_chain(const ChainCase& c, ChainSimulation& s, long steps) {
  const ChainPlan& p = c.plan;
  const double h = c.time.step;
  const string::TopCommand usual{p.rotary_speed * h, p.rate * h, p.hook_load, p.surface_weight};
  for (long i = 0; i < steps; ++i) {
    const string::TopCommand command =
        command_of(p.log, usual, h * static_cast<double>(s.steps_done), h);
    string::step_bit_on_chain(p.chain, p.bit, h, command, s.state, s.work);
    ++s.steps_done;
    watch(c, s);
  }
  s.time = h * static_cast<double>(s.steps_done);  // avoids a sum of rounded steps
  const double change = balance(c, s) - s.figures.start_balance;
  if (!std::isfinite(change))
    throw RunError("the state is no longer finite: the step is too long for this string");
  s.figures.residual = std::max(s.figures.residual, std::abs(change));
}

}  // namespace tdbd::simulation
