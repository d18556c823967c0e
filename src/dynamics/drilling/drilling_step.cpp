#include "dynamics/drilling/drilling_step.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "dynamics/drilling/chained_string.hpp"
#include "dynamics/rotation/drift.hpp"

namespace tdbd::dynamics {
namespace {

/// Performs a half step as one flow and adds the work of the wrench to the ledger.
void half_step(const DrillingSystem& system, double h, Half which, Drilling& d,
               DrillingWork& work) {
  DrillingVelocity& mean = which == Half::opening ? work.opening : work.closing;
  const double share = cone_share(d.wrench.cone_impulse, which);
  take_half_step(system, {h, which, work.at, work.middle, d.wrench, share}, d.state, &d.ledger,
                 work.half, mean);
  d.ledger.cut_bit += 0.5 * h * power_on_bit(d.wrench, mean, share);
  d.ledger.cut_rock += 0.5 * h * power_on_rock(d.wrench, mean);
  if (system.chained) d.chain.ledger.loss -= 0.5 * h * power_on_bit(work.chain_damper, mean, 1.0);
}

/// Data from which the work of the top over the drift is computed; taken before and after it.
struct TopAction {
  TopPosition position;
  StringPull pull;
  double attachment_z = 0.0;
};
TopAction top_action(const DrillingState& state, const Configuration& at) {
  return {at.top, at.pull, state.c_W.z() + at.pull.arm_W.z()};
}

/// Mean force times displacement. The top pulls the upper end of the string with the force of the
/// string on the bit.
double work_of_top(const TopAction& a, const TopAction& b) {
  return 0.5 * (a.pull.spring_W + b.pull.spring_W).dot(b.position.point_W - a.position.point_W) +
         0.5 * (a.pull.twist_moment + b.pull.twist_moment) * (b.position.angle - a.position.angle) +
         0.5 * (a.pull.load + b.pull.load) * (b.attachment_z - a.attachment_z);
}

/// Advances positions and time; momenta do not change. Returns false if an implicit drift did not
/// converge.
bool drift_all(const DrillingSystem& s, double h, Drilling& d) {
  const Integrator& i = s.integrator;
  if (coast(s.gyrostat, i.drift, i.drifts_per_step, h, d.state.rotation) == LieOutcome::too_long)
    return false;
  d.state.rotation.time += h;
  const Vec3 way = (h / s.mass) * d.state.momentum_W;
  d.state.c_W += way;
  d.ledger.gravity += weight_W(s).dot(way);
  if (s.rock.mass > 0.0) d.state.rock_z += h / s.rock.mass * d.state.rock_momentum;
  return true;
}

}  // namespace

Drilling start_drilling(const DrillingSystem& system, DrillingState state,
                        string::ChainState chain) {
  Drilling d;
  d.state = std::move(state);
  d.chain = std::move(chain);
  const DrillingWork work = drilling_work(system, d);
  d.ledger.start = total(stored_energy(system, work.at, d.state));
  return d;
}

DrillingWork drilling_work(const DrillingSystem& system, const Drilling& d) {
  DrillingWork work;
  configure(system, d.state, work.at);
  start_chain_work(system, d, work);
  return work;
}

void open_step(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work) {
  work.step_start = d.state;
  const EnergyLedger ledger_start = d.ledger;
  open_chain(system, h, d, work);
  find_middle(system, h, work.at, d.wrench, d.state, work.half, work.middle);
  half_step(system, h, Half::opening, d, work);
  const TopAction before = top_action(d.state, work.at);
  if (!drift_all(system, h, d)) {
    d.state = work.step_start;
    d.ledger = ledger_start;
    if (system.chained) d.chain = work.chain_start;
    throw RunError(
        fmt::format("the drift does not converge at t = {:.9g} s with a step of {:.6g} s",
                    d.state.rotation.time, h));
  }
  place_upper_end(system, d.chain, d.state.upper);
  configure(system, d.state, work.at);
  load_chain(system, h, d, work);
  if (!system.chained) d.ledger.top += work_of_top(before, top_action(d.state, work.at));
}

const DrillingState& predicted(const DrillingSystem& system, double h, const Drilling& d,
                               DrillingWork& work) {
  work.predicted = d.state;
  const double share = cone_share(d.wrench.cone_impulse, Half::opening);  // 0 if at_end
  take_half_step(system, {h, Half::closing, work.at, work.middle, d.wrench, share}, work.predicted,
                 nullptr, work.half, work.before);
  return work.predicted;
}

void velocity_after(const DrillingSystem& system, double h, const Drilling& d, KicksLeft kicks,
                    const Wrench& wrench, DrillingWork& work, DrillingVelocity& out) {
  DrillingState& s = work.predicted;
  s = d.state;
  const auto take = [&](Half half, const Configuration& middle) {
    const double share = cone_share(wrench.cone_impulse, half);
    take_half_step(system, {h, half, work.at, middle, wrench, share}, s, nullptr, work.half, out);
  };
  if (kicks == KicksLeft::closing_and_opening) take(Half::closing, work.middle);
  find_middle(system, h, work.at, wrench, s, work.half, work.next_middle);
  take(Half::opening, work.next_middle);
  velocity(system, work.at, s, out);
}

void close_step(const DrillingSystem& system, double h, const Wrench& wrench, Drilling& d,
                DrillingWork& work) {
  d.wrench = wrench;
  half_step(system, h, Half::closing, d, work);
  close_chain(system, h, d, work);
}

}  // namespace tdbd::dynamics
