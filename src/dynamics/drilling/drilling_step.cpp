#include "dynamics/drilling/drilling_step.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "dynamics/drilling/dissipation.hpp"
#include "dynamics/rotation/drift.hpp"

namespace tdbd::dynamics {
namespace {

/// Held rock takes none.
void add_impulse(const DrillingSystem& system, double h, const Wrench& w, DrillingState& s) {
  s.momentum_W += h * w.force_W;
  s.rotation.momentum_W += h * w.torque_W;
  for (std::size_t k = 0; k < w.cones.size(); ++k) s.rotation.cone_momenta[k] += h * w.cones[k];
  if (system.rock.mass > 0.0) s.rock_momentum += h * w.rock_force;
}

void give_impulses(const DrillingSystem& system, double h, const Drilling& d, DrillingState& s) {
  add_impulse(system, h, d.at.conservative, s);
  add_impulse(system, h, d.wrench, s);
}

/// A kick, the mean velocity over it, and the work of the wrench.
void kick(const DrillingSystem& system, double h, Drilling& d, DrillingVelocity& mean) {
  velocity(system, d.at, d.state, d.before);
  give_impulses(system, h, d, d.state);
  velocity(system, d.at, d.state, mean);
  mean_velocity(d.before, mean, mean);
  d.ledger.cut_bit += h * power_on_bit(d.wrench, mean);
  d.ledger.cut_rock += h * power_on_rock(d.wrench, mean);
}

/// Where the top's work is counted: before the drift and after it.
struct TopAction {
  TopPosition position;
  StringPull pull;
  double attachment_z = 0.0;
};
TopAction top_action(const Drilling& d) {
  return {d.at.top, d.at.pull, d.state.c_W.z() + d.at.pull.arm_W.z()};
}

/// Mean force times way. The top pulls at the string's upper end as the string does at the bit.
double work_of_top(const TopAction& a, const TopAction& b) {
  return 0.5 * (a.pull.spring_W + b.pull.spring_W).dot(b.position.point_W - a.position.point_W) +
         0.5 * (a.pull.twist_moment + b.pull.twist_moment) * (b.position.angle - a.position.angle) +
         0.5 * (a.pull.load + b.pull.load) * (b.attachment_z - a.attachment_z);
}

/// Positions and time move on, momenta stay. False: a drift that solves was too long.
bool drift_all(const DrillingSystem& s, double h, Drilling& d) {
  const Integrator& i = s.integrator;
  if (coast(s.gyrostat, i.drift, i.drifts_per_step, h, d.state.rotation) == LieOutcome::too_long)
    return false;
  d.state.rotation.time += h;
  const Vec3 way = (h / s.mass) * d.state.momentum_W;
  d.state.c_W += way;
  d.ledger.gravity += s.mass * s.gravity * way.z();
  if (s.rock.mass > 0.0) d.state.rock_z += h / s.rock.mass * d.state.rock_momentum;
  return true;
}

}  // namespace

Drilling start_drilling(const DrillingSystem& system, DrillingState state) {
  Drilling d;
  d.state = std::move(state);
  configure(system, d.state, d.at);
  d.ledger.start = total(stored_energy(system, d.at, d.state));
  return d;
}

Drilling resume_drilling(const DrillingSystem& system, DrillingState state, Wrench wrench,
                         const EnergyLedger& ledger) {
  Drilling d;
  d.state = std::move(state);
  d.wrench = std::move(wrench);
  d.ledger = ledger;
  configure(system, d.state, d.at);
  return d;
}

void open_step(const DrillingSystem& system, double h, Drilling& d) {
  d.step_start = d.state;
  const EnergyLedger ledger_start = d.ledger;
  dissipate(system, d.at, Sweep::forward, 0.5 * h, d.state, d.ledger);
  kick(system, 0.5 * h, d, d.opening);
  const TopAction before = top_action(d);
  if (!drift_all(system, h, d)) {
    d.state = d.step_start;
    d.ledger = ledger_start;
    throw RunError(
        fmt::format("the drift does not converge at t = {:.9g} s with a step of {:.6g} s",
                    d.state.rotation.time, h));
  }
  configure(system, d.state, d.at);
  d.ledger.top += work_of_top(before, top_action(d));
}

const DrillingState& predicted(const DrillingSystem& system, double h, Drilling& d) {
  d.predicted = d.state;
  give_impulses(system, 0.5 * h, d, d.predicted);
  EnergyLedger unseen;
  dissipate(system, d.at, Sweep::backward, 0.5 * h, d.predicted, unseen);
  return d.predicted;
}

void close_step(const DrillingSystem& system, double h, const Wrench& wrench, Drilling& d) {
  d.wrench = wrench;
  kick(system, 0.5 * h, d, d.closing);
  dissipate(system, d.at, Sweep::backward, 0.5 * h, d.state, d.ledger);
}

}  // namespace tdbd::dynamics
