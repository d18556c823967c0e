#include "string/statics.hpp"

#include <cmath>

#include "core/types.hpp"

namespace tdbd::string {
namespace {

/// Load of the element above a node.
struct Above {
  double tension = 0.0, torque = 0.0;
};

/// Direction of the slip: shares of the friction along and around the hole.
Above direction(const Chain& c, const SteadyMotion& m, double radius) {
  const double along = c.directions == Directions::torsion ? 0.0 : m.rate;
  const double around = c.directions == Directions::axial ? 0.0 : m.rotary_speed * radius;
  const double size = std::hypot(along, around);
  return size > 0.0 ? Above{along / size, around / size} : Above{};
}

/// Equilibrium of node i. Its side force depends on the tension above, which is found by a
/// fixed-point iteration. The contraction factor is friction times the bend of one element.
Above above_node(const Chain& c, const SteadyMotion& m, int i, const Above& below) {
  const std::size_t k = at(i);
  const double radius = c.contact.radius[k] > 0.0 ? c.contact.radius[k] : 1.0;
  const double slip = std::hypot(m.rate, m.rotary_speed * radius);
  const double mu = slip > c.threshold ? c.contact.sliding[k] : c.contact.resting[k];
  const Above e = direction(c, m, radius);
  const double free =
      below.tension + c.contact.weight[k] - c.axial_damping * c.elements.mass[k] * m.rate;
  const bool pulls = c.directions != Directions::torsion;
  double tension = pulls ? free : 0.0, side = 0.0;
  for (int round = 0; round < 100; ++round) {
    side = side_force_at(c.contact, i, tension, below.tension);
    const double next = pulls ? free - mu * side * e.tension : 0.0;
    const bool same = std::abs(next - tension) <= 1e-15 * std::abs(next);
    tension = next;
    if (same) break;
  }
  return {tension, below.torque + mu * side * e.torque * radius +
                       c.torsional_damping * c.elements.inertia[k] * m.rotary_speed};
}

}  // namespace

SteadyLoad steady_load(const Chain& c, const SteadyMotion& m) {
  const int n = c.count();
  SteadyLoad load;
  load.tension.assign(at(n), 0.0);
  load.torque.assign(at(n), 0.0);
  load.side_force.assign(at(n) + 1, 0.0);
  Above here{c.directions == Directions::torsion ? 0.0 : m.pull,
             c.directions == Directions::axial ? 0.0 : m.torque};
  for (int i = n - 1; i >= 0; --i) {
    load.tension[at(i)] = here.tension;
    load.torque[at(i)] = here.torque;
    if (i > 0) here = above_node(c, m, i, here);
  }
  side_forces(c.contact, load.tension, load.side_force);
  load.surface = {
      load.tension[0] + c.contact.weight[0] - c.axial_damping * c.elements.mass[0] * m.rate,
      load.torque[0] + c.torsional_damping * c.elements.inertia[0] * m.rotary_speed};
  return load;
}

SteadyStart steady_start(const Chain& c, const SteadyMotion& m, const SteadyLoad& load) {
  SteadyStart s{chain_at_rest(c), {}};
  double u = 0.0, angle = 0.0;
  for (std::size_t i = 0; i < at(c.count()); ++i) {
    s.chain.displacement[i] = u;
    s.chain.angle[i] = angle;
    s.chain.velocity[i] = c.directions == Directions::torsion ? 0.0 : m.rate;
    s.chain.rotary_speed[i] = m.rotary_speed;
    u += load.tension[i] / c.elements.axial[i];
    angle -= load.torque[i] / c.elements.torsional[i];
  }
  s.end = {u, angle, s.chain.velocity[0], m.rotary_speed};
  s.chain.top.set_speed = m.rotary_speed;
  s.chain.top.rate = s.chain.velocity[0];
  s.chain.top.hook_load = load.surface.hook_load;
  if (c.top.torsion == Top::Torsion::pi && c.top.integral > 0.0)
    s.chain.top.set_angle = load.surface.torque / c.top.integral;
  return s;
}

}  // namespace tdbd::string
