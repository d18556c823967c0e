#include "dynamics/drilling/drilling_step.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "dynamics/drilling/chained_string.hpp"
#include "dynamics/drilling/stability.hpp"
#include "dynamics/rotation/drift.hpp"

namespace tdbd::dynamics {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Whether the wall resists at either end of a half step.
bool rubs(const Wall& wall, const Configuration& a, const Configuration& b) {
  return wall_resists(wall) && (a.contact.depth > 0.0 || b.contact.depth > 0.0);
}

/// Rotates a vector about z by an angle given by its cosine and sine.
Vec3 turned(const Vec3& p, double cosine, double sine) {
  return {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y(), p.z()};
}

using Directions = std::array<Direction, 3>;

/// Speeds of the contact for the momenta in `w`: slip around the wall, slip along z, radial speed,
/// m/s.
Vec3 speeds_at_contact(const DrillingSystem& s, const Configuration& at,
                       const Directions& directions, FlowWork& w) {
  w.start.resize(w.momenta.size());
  velocities_of(s, at, w.momenta, w.start);
  Vec3 speeds;
  for (int i = 0; i < 3; ++i) {
    const Direction& d = directions[tdbd::at(i)];
    speeds[i] = d.force_W.dot(w.start.head<3>()) + d.torque_W.dot(w.start.segment<3>(3));
  }
  return speeds;
}

/// T: the impulse that rotates the momenta with the contact from one geometry to another, (24). The
/// momenta are rotated about z, and an impulse at the contact then restores the speeds of the
/// contact. Zero if the ring touches the wall in only one of the geometries.
Vec6 turning_impulse(const DrillingSystem& s, const Configuration& from, const Configuration& to,
                     const DrillingState& state, FlowWork& w) {
  Vec6 T = Vec6::Zero();
  if (from.contact.depth <= 0.0 || to.contact.depth <= 0.0) return T;
  const double cosine = from.contact.outward_W.dot(to.contact.outward_W),
               sine = from.contact.outward_W.cross(to.contact.outward_W).z();
  const Vec3 &p = state.momentum_W, &pi = state.rotation.momentum_W;
  T << turned(p, cosine, sine) - p, turned(pi, cosine, sine) - pi;
  const Directions there = contact_directions(to.contact);
  momenta_column(s, state, w.momenta);
  const Vec3 before = speeds_at_contact(s, from, contact_directions(from.contact), w);
  w.momenta.head<6>() += T;
  const Vec3 after = speeds_at_contact(s, to, there, w);
  Mat3 mobility;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Direction &a = there[tdbd::at(i)], &b = there[tdbd::at(j)];
      mobility(i, j) =
          a.force_W.dot(b.force_W) / s.mass + a.torque_W.dot(to.mobility_W * b.torque_W);
    }
  const Vec3 impulse = mobility.llt().solve(before - after);
  for (int i = 0; i < 3; ++i) {
    T.head<3>() += impulse[i] * there[tdbd::at(i)].force_W;
    T.tail<3>() += impulse[i] * there[tdbd::at(i)].torque_W;
  }
  return T;
}

/// Performs a quarter step in each geometry, with the turning impulse between them.
void take_quarter_steps(const DrillingSystem& s, double h, const Configuration& first,
                        const Configuration& second, DrillingState& state, EnergyLedger* ledger,
                        HalfWork& w) {
  const Vec6 T = turning_impulse(s, first, second, state, w.flow);
  w.flow.force = w.force;
  w.flow.force.head<6>() -= T / (0.5 * h);
  resisted_flow(s, first, 0.25 * h, state, ledger, w.flow);
  w.mean = 0.5 * w.flow.mean;
  state.momentum_W += T.head<3>();
  state.rotation.momentum_W += T.tail<3>();
  resisted_flow(s, second, 0.25 * h, state, ledger, w.flow);
  w.mean += 0.5 * w.flow.mean;
}

/// Performs half a drift. Returns false if it does not converge.
bool drift_halfway(const DrillingSystem& s, double h, const DrillingState& from, DrillingState& to,
                   Configuration& middle) {
  to = from;
  if (coast(s.gyrostat, s.integrator.drift, 1, 0.5 * h, to.rotation) == LieOutcome::too_long)
    return false;
  to.rotation.time += 0.5 * h;
  to.c_W += (0.5 * h / s.mass) * to.momentum_W;
  to.upper.z += 0.5 * h * to.upper.rate;
  to.upper.angle += 0.5 * h * to.upper.speed;
  if (s.rock.mass > 0.0) to.rock_z += 0.5 * h / s.rock.mass * to.rock_momentum;
  configure(s, to, middle);
  return true;
}

/// Rotates the momenta about z by the angle that a touching ring travels around the wall in half a
/// step.
void rotate_with_contact(const DrillingSystem& s, double h, const Configuration& node,
                         HalfWork& work) {
  const WallContact& c = node.contact;
  if (c.depth <= 0.0) return;
  DrillingState& x = work.trial;
  momenta_column(s, x, work.flow.momenta);
  work.mean.resize(work.flow.momenta.size());
  velocities_of(s, node, work.flow.momenta, work.mean);
  const Vec3 ring = work.mean.head<3>() + Vec3(work.mean.segment<3>(3)).cross(c.ring_arm_W);
  constexpr double most = 0.9;  // largest sine
  const double sine =
      std::clamp(0.5 * h * ring.dot(c.tangent_W) / (s.wall.clearance + c.depth), -most, most);
  const double cosine = std::sqrt(1.0 - sine * sine);
  x.momentum_W = turned(x.momentum_W, cosine, sine);
  x.rotation.momentum_W = turned(x.rotation.momentum_W, cosine, sine);
}

}  // namespace

double cone_share(ConeImpulse impulse, Half half) {
  if (impulse == ConeImpulse::halves) return 1.0;
  return half == Half::closing ? 2.0 : 0.0;
}

void take_half_step(const DrillingSystem& s, const HalfStep& step, DrillingState& state,
                    EnergyLedger* ledger, HalfWork& w, DrillingVelocity& mean) {
  const auto& [h, half, node, middle, wrench, share] = step;
  force_column(s, node.conservative, wrench, share, w.force);
  const bool opens = half == Half::opening;
  if (opens) follow_bit(s, node, 0.5 * h, state);
  if (rubs(s.wall, node, middle)) {
    take_quarter_steps(s, h, opens ? node : middle, opens ? middle : node, state, ledger, w);
    from_column(s, w.mean, mean);
  } else {
    w.flow.force = w.force;
    resisted_flow(s, node, 0.5 * h, state, ledger, w.flow);
    from_column(s, w.flow.mean, mean);
  }
  if (!opens) follow_bit(s, node, 0.5 * h, state);
}

void find_middle(const DrillingSystem& s, double h, const Configuration& node, const Wrench& wrench,
                 const DrillingState& state, HalfWork& w, Configuration& middle) {
  w.trial = state;
  rotate_with_contact(s, h, node, w);
  if (!wall_resists(s.wall) || !drift_halfway(s, h, w.trial, w.halfway, middle)) {
    middle = node;
    return;
  }
  if (!rubs(s.wall, node, middle)) return;
  w.trial = state;
  const double share = cone_share(wrench.cone_impulse, Half::opening);
  take_half_step(s, {h, Half::opening, node, middle, wrench, share}, w.trial, nullptr, w,
                 w.mean_velocity);
  if (!drift_halfway(s, h, w.trial, w.halfway, middle)) middle = node;
}

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

void velocity_after_kicks(const DrillingSystem& system, double h, const Drilling& d,
                          RemainingKicks kicks, const Wrench& wrench, DrillingWork& work,
                          DrillingVelocity& out) {
  DrillingState& s = work.predicted;
  s = d.state;
  const auto take = [&](Half half, const Configuration& middle) {
    const double share = cone_share(wrench.cone_impulse, half);
    take_half_step(system, {h, half, work.at, middle, wrench, share}, s, nullptr, work.half, out);
  };
  if (kicks == RemainingKicks::closing_and_opening) take(Half::closing, work.middle);
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
