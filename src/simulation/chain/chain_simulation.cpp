#include "simulation/chain/chain_simulation.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::simulation {
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
