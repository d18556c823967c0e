#include "string/chain.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"
#include "string/node_flow.hpp"

namespace tdbd::string {
namespace {

bool moves_along(const Chain& c) { return c.directions != Directions::torsion; }
bool turns_freely(const Chain& c) { return c.directions != Directions::axial; }

/// Mobilities of half a step (s), in units of slip.
void prepare(const Chain& c, double half, ChainWork& w) {
  if (half == w.half_step) return;
  w.half_step = half;
  const double along = half * phi(-c.axial_damping * half);
  const double around = half * phi(-c.torsional_damping * half);
  for (std::size_t i = 0; i < w.along.size(); ++i) {
    w.along[i] = along / c.elements.mass[i];
    w.around[i] = around / w.mass_around[i];
  }
}

/// Forces on a node along and around the hole, in units of slip.
Slip force_on(const Chain& c, const ChainWork& w, std::size_t i) {
  return {w.tension[i] - w.tension[i - 1] + c.contact.weight[i],
          (w.torque[i - 1] - w.torque[i]) * w.inverse_radius[i]};
}

/// String (5) for all nodes in one pass without branches. The result is valid for nodes that are
/// far from rest; for these `margin` is negative.
void flow_far_from_rest(const Chain& c, const ChainState& s, ChainWork& w) {
  const std::size_t n = at(c.count());
  const double *T = w.tension.data(), *Q = w.torque.data(), *weight = c.contact.weight.data();
  const double *v = s.velocity.data(), *om = s.rotary_speed.data();
  const double *N = w.side_force.data(), *mu = c.contact.sliding.data();
  const double *ba = w.along.data(), *bq = w.around.data(), *ma = c.elements.mass.data();
  const double *r = w.radius.data(), *ir = w.inverse_radius.data(), *mq = w.mass_around.data();
  double *na = w.next_along.data(), *nq = w.next_around.data(), *margin = w.margin.data();
  const double a = c.axial_damping, b = c.torsional_damping, vc = c.threshold;
  for (std::size_t i = 1; i < n; ++i) {
    const double wa = v[i], wq = om[i] * r[i], R = mu[i] * N[i];
    const double da = ba[i] * (T[i] - T[i - 1] + weight[i] - a * ma[i] * wa);
    const double dq = bq[i] * ((Q[i - 1] - Q[i]) * ir[i] - b * mq[i] * wq);
    const double size = std::sqrt(wa * wa + wq * wq), inverse = 1.0 / size;
    const double ya = ba[i] * R, yq = bq[i] * R, gap = size - vc;
    margin[i] = 16.0 * (da * da + dq * dq + ya * ya + yq * yq) - gap * std::abs(gap);
    const double ea = 2.0 * wa + da - ya * wa * inverse, eq = 2.0 * wq + dq - yq * wq * inverse;
    const double k = 1.0 / std::sqrt(ea * ea + eq * eq);
    na[i] = wa + da - ya * ea * k;
    nq[i] = wq + dq - yq * eq * k;
  }
}

/// The flow of nodes 1 to n - 1 with motion both along and around the hole.
void flow_both(const Chain& c, double time, ChainState& s, ChainWork& w) {
  flow_far_from_rest(c, s, w);
  Lost lost;
  long resting = 0;
  for (std::size_t i = 1; i < at(c.count()); ++i) {
    const double radius = w.radius[i];
    const Slip from{s.velocity[i], s.rotary_speed[i] * radius}, F = force_on(c, w, i);
    const Slip mass{c.elements.mass[i], w.mass_around[i]};
    const Slip damping{c.axial_damping * mass.along, c.torsional_damping * mass.around};
    double level = c.contact.sliding[i] * w.side_force[i];
    Slip to{w.next_along[i], w.next_around[i]};
    if (!(w.margin[i] < 0.0)) {
      const double most = c.contact.resting[i] * w.side_force[i];
      const FreeFlow free{{from.along + w.along[i] * (F.along - damping.along * from.along),
                           from.around + w.around[i] * (F.around - damping.around * from.around)},
                          {w.along[i], w.around[i]}};
      to = flow_slip(from, free, {most, level, c.threshold});
      if (size_of(from) <= c.threshold) level = most;
      resting += to.along == 0.0 && to.around == 0.0;
    }
    add_flow_losses({from, to, F, level, time}, mass, damping, lost);
    s.velocity[i] = to.along;
    s.rotary_speed[i] = to.around * w.inverse_radius[i];
  }
  s.ledger.friction += lost.friction;
  s.ledger.damping += lost.damping;
  w.resting = resting;
}

/// The flow of nodes 1 to n - 1 with rotation only.
void flow_torsion(const Chain& c, double time, ChainState& s, ChainWork& w) {
  Lost lost;
  long resting = 0;
  for (std::size_t i = 1; i < at(c.count()); ++i) {
    const double radius = w.radius[i], mass = w.mass_around[i];
    const Slip from{0.0, s.rotary_speed[i] * radius};
    const Slip F{0.0, (w.torque[i - 1] - w.torque[i]) * w.inverse_radius[i]};
    const Coulomb friction{c.contact.resting[i] * w.side_force[i],
                           c.contact.sliding[i] * w.side_force[i], c.threshold};
    const DampedBody body{mass, c.torsional_damping * mass};
    const Slip to{0.0, friction.resting > 0.0
                           ? flow_along(body, F.around, friction, time, from.around)
                           : from.around + w.around[i] * (F.around - body.damping * from.around)};
    const double level = std::abs(from.around) > c.threshold ? friction.sliding : friction.resting;
    add_flow_losses({from, to, F, level, time}, {0.0, mass}, {0.0, body.damping}, lost);
    s.rotary_speed[i] = to.around * w.inverse_radius[i];
    resting += to.around == 0.0;
  }
  s.ledger.friction += lost.friction;
  s.ledger.damping += lost.damping;
  w.resting = resting;
}

/// The flow of nodes 1 to n - 1 with motion along the hole only; they rotate like the top.
void flow_axial(const Chain& c, double time, ChainState& s, ChainWork& w) {
  Lost lost;
  for (std::size_t i = 1; i < at(c.count()); ++i) {
    const double mass = c.elements.mass[i], damping = c.axial_damping * mass;
    const Slip from{s.velocity[i], 0.0}, F{force_on(c, w, i).along, 0.0};
    const Slip to{from.along + w.along[i] * (F.along - damping * from.along), 0.0};
    add_flow_losses({from, to, F, 0.0, time}, {mass, 0.0}, {damping, 0.0}, lost);
    s.velocity[i] = to.along;
    s.rotary_speed[i] = s.top.set_speed;
  }
  s.ledger.damping += lost.damping;
}

void flow_top_along(const Chain& c, double time, ChainState& s, const ChainWork& w) {
  if (!moves_along(c)) return;
  if (c.top.axial != Top::Axial::hook_load) {
    s.velocity[0] = s.top.rate;
    return;
  }
  const double mass = c.elements.mass[0], damping = c.axial_damping * mass;
  const double F = w.tension[0] + c.contact.weight[0] - s.top.hook_load, from = s.velocity[0];
  const double to = from + w.along[0] * (F - damping * from), mean = 0.5 * (from + to);
  s.ledger.damping += (time * F - mass * (to - from)) * mean;
  s.ledger.top -= time * s.top.hook_load * mean;
  s.velocity[0] = to;
}

void flow_top_around(const Chain& c, double time, ChainState& s, const ChainWork& w) {
  if (c.top.torsion == Top::Torsion::speed || !turns_freely(c)) {
    s.rotary_speed[0] = s.top.set_speed;
    return;
  }
  const double cell = c.elements.inertia[0], damping = c.torsional_damping * cell;
  const double from = s.rotary_speed[0], inertia = cell + c.top.inertia;
  const TopFlow f = flow_top(c.top, time, from, s.top.set_speed, s.top.set_angle - s.angle[0],
                             -w.torque[0], damping, inertia);
  const double mean = 0.5 * (from + f.speed), rest = f.motor_impulse - f.spring_impulse;
  const double given = rest * (f.limited ? mean : s.top.set_speed);
  s.ledger.top += given;
  s.ledger.top_damping += given - rest * mean;
  s.ledger.damping += time * damping * mean * mean;
  s.top.limited = f.limited;
  s.rotary_speed[0] = f.speed;
}

/// Adds the energy taken by the Kelvin-Voigt dampers at the chain's own nodes during a flow to the
/// ledger.
void add_damper_losses(const Chain& c, double time, ChainState& s, const ChainWork& w) {
  double work = 0.0;
  for (std::size_t i = 0; i < at(c.count()); ++i) {
    const double above = i > 0 ? w.damper_force[i - 1] : 0.0;
    const double turned = i > 0 ? w.damper_torque[i - 1] : 0.0;
    const bool lowered = i == 0 && c.top.axial != Top::Axial::hook_load;
    const bool driven = i == 0 && c.top.torsion == Top::Torsion::speed;
    const double v = lowered ? s.velocity[0] : 0.5 * (w.before_velocity[i] + s.velocity[i]);
    const double omega = driven ? s.rotary_speed[0] : 0.5 * (w.before_speed[i] + s.rotary_speed[i]);
    work += time * ((w.damper_force[i] - above) * v + (turned - w.damper_torque[i]) * omega);
  }
  s.ledger.loss -= work;
}

/// Flow of nodes 0 to n - 1 over `time`.
void flow_nodes(const Chain& c, double time, ChainState& s, ChainWork& w) {
  prepare(c, time, w);
  if (c.has_loss()) {
    std::copy(s.velocity.begin(), s.velocity.end(), w.before_velocity.begin());
    std::copy(s.rotary_speed.begin(), s.rotary_speed.end(), w.before_speed.begin());
  }
  flow_top_along(c, time, s, w);
  flow_top_around(c, time, s, w);
  switch (c.directions) {
    case Directions::both:
      flow_both(c, time, s, w);
      break;
    case Directions::torsion:
      flow_torsion(c, time, s, w);
      break;
    case Directions::axial:
      flow_axial(c, time, s, w);
      break;
  }
  if (c.has_loss()) add_damper_losses(c, time, s, w);
}

void drift(const Chain& c, double h, ChainState& s) {
  double fallen = 0.0;
  for (std::size_t i = 0; i < at(c.count()); ++i) {
    const double way = h * s.velocity[i];
    s.displacement[i] += way;
    s.angle[i] += h * s.rotary_speed[i];
    fallen += c.contact.weight[i] * way;
  }
  s.ledger.gravity += fallen;
}

void take_command(const Chain& c, double h, const TopCommand& command, TopState& top) {
  top.set_speed = command.turn / h;
  top.hook_load = command.hook_load;
  if (c.top.axial == Top::Axial::rate) top.rate = command.way / h;
}

/// Adds the work of the top on the string during the step to the ledger. Call it after the drift.
void add_top_work(const Chain& c, double h, double set_turn, ChainState& s, const ChainWork& w) {
  if (moves_along(c) && c.top.axial != Top::Axial::hook_load) {
    const double way = h * s.velocity[0];
    const double damper = c.axial_damping * c.elements.mass[0] * s.velocity[0];
    s.ledger.top -= (0.5 * (w.opening_pull + w.tension[0]) + c.contact.weight[0] - damper) * way;
    s.ledger.damping += damper * way;
  }
  if (!turns_freely(c)) return;
  if (c.top.torsion == Top::Torsion::speed) {
    const double turn = h * s.rotary_speed[0];
    const double damper = c.torsional_damping * c.elements.inertia[0] * s.rotary_speed[0];
    s.ledger.top += (0.5 * (w.opening_torque + w.torque[0]) + damper) * turn;
    s.ledger.damping += damper * turn;
  } else {
    s.ledger.top +=
        0.5 * c.top.integral * (w.opening_behind + s.top.set_angle - s.angle[0]) * set_turn;
  }
}

/// Adds the Kelvin-Voigt forces from the rates of the last drift.
void add_losses(const Chain& c, const ChainState& s, ChainWork& w) {
  for (std::size_t e = 0; e < at(c.count()); ++e) {
    w.damper_force[e] = c.axial_loss_time * c.elements.axial[e] * s.stretching[e];
    w.damper_torque[e] = c.torsional_loss_time * c.elements.torsional[e] * s.twisting[e];
    w.tension[e] += w.damper_force[e];
    w.torque[e] += w.damper_torque[e];
  }
}

/// Computes the elastic forces, and the side forces that follow from them.
void load(const Chain& c, const ChainState& s, const EndMotion& end, ChainWork& w) {
  const std::size_t n = at(c.count());
  for (std::size_t e = 0; e + 1 < n; ++e) {
    w.tension[e] = c.elements.axial[e] * (s.displacement[e + 1] - s.displacement[e]);
    w.torque[e] = c.elements.torsional[e] * (s.angle[e] - s.angle[e + 1]);
  }
  w.tension[n - 1] = c.elements.axial[n - 1] * (end.displacement - s.displacement[n - 1]);
  w.torque[n - 1] = c.elements.torsional[n - 1] * (s.angle[n - 1] - end.angle);
  if (!moves_along(c)) std::fill(w.tension.begin(), w.tension.end(), 0.0);
  if (!turns_freely(c)) std::fill(w.torque.begin(), w.torque.end(), 0.0);
  side_forces(c.contact, w.tension, w.side_force);
  if (c.has_loss()) add_losses(c, s, w);
}

}  // namespace

ChainState chain_at_rest(const Chain& c) {
  ChainState s;
  const std::size_t n = at(c.count());
  for (auto* a : {&s.displacement, &s.velocity, &s.angle, &s.rotary_speed}) a->assign(n, 0.0);
  const std::size_t lossy = c.has_loss() ? n : 0;
  s.stretching.assign(lossy, 0.0);
  s.twisting.assign(lossy, 0.0);
  return s;
}

ChainWork chain_work(const Chain& c, const ChainState& s, const EndMotion& end) {
  ChainWork w;
  const std::size_t n = at(c.count());
  for (auto* a : {&w.tension, &w.torque, &w.damper_force, &w.damper_torque}) a->assign(n, 0.0);
  for (auto* a : {&w.side_force, &w.along, &w.around, &w.radius, &w.inverse_radius, &w.mass_around,
                  &w.next_along, &w.next_around, &w.margin, &w.before_velocity, &w.before_speed})
    a->assign(n + 1, 0.0);
  for (std::size_t i = 0; i <= n; ++i) {
    const double radius = c.contact.radius[i] > 0.0 ? c.contact.radius[i] : 1.0;
    w.radius[i] = radius;
    w.inverse_radius[i] = 1.0 / radius;
    w.mass_around[i] = c.elements.inertia[i] / (radius * radius);
  }
  load(c, s, end, w);
  return w;
}

void open_step(const Chain& c, double h, const TopCommand& command, ChainState& s, ChainWork& w) {
  take_command(c, h, command, s.top);
  flow_nodes(c, 0.5 * h, s, w);
  w.opening_pull = w.tension[0];
  w.opening_torque = w.torque[0];
  w.opening_behind = s.top.set_angle - s.angle[0];
  drift(c, h, s);
  w.set_turn = s.top.limited ? 0.0 : command.turn;
  s.top.set_angle += w.set_turn;
}

void load_elements(const Chain& c, const EndMotion& end, ChainState& s, ChainWork& w) {
  if (c.has_loss()) {
    const std::size_t n = at(c.count());
    for (std::size_t e = 0; e < n; ++e) {
      const double v = e + 1 < n ? s.velocity[e + 1] : end.velocity;
      const double omega = e + 1 < n ? s.rotary_speed[e + 1] : end.rotary_speed;
      s.stretching[e] = v - s.velocity[e];
      s.twisting[e] = s.rotary_speed[e] - omega;
    }
  }
  load(c, s, end, w);
}

void close_step(const Chain& c, double h, const TopCommand& command, ChainState& s, ChainWork& w) {
  add_top_work(c, h, w.set_turn, s, w);
  if (c.top.axial == Top::Axial::autodriller)
    update_block_rate(c.top, h, surface_load(c, s, w).hook_load, command.weight, s.top);
  flow_nodes(c, 0.5 * h, s, w);
}

}  // namespace tdbd::string
