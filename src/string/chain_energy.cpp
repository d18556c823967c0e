#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types.hpp"
#include "string/chain.hpp"

namespace tdbd::string {
namespace {

/// Support of node 0. Zero mass: it cannot move freely.
struct Held {
  double mass = 0.0, spring = 0.0;
};

/// The largest ratio of the sum of both stiffnesses to mass over all nodes that can move, 1/s2.
double largest_rate(const std::vector<double>& stiffness, const std::vector<double>& mass,
                    const Held& top, double end_mass) {
  const std::size_t n = stiffness.size();
  double largest = 0.0;
  for (std::size_t i = 1; i < n; ++i)
    largest = std::max(largest, 2.0 * (stiffness[i - 1] + stiffness[i]) / mass[i]);
  if (top.mass > 0.0) largest = std::max(largest, (2.0 * stiffness[0] + top.spring) / top.mass);
  if (end_mass > 0.0) {
    const double factor = n == 1 && top.mass == 0.0 ? 1.0 : 2.0;  // single node below a fixed top
    largest = std::max(largest, factor * stiffness[n - 1] / end_mass);
  }
  return largest;
}

/// The longest h with h omega < 2 and, with a loss time, (h omega/2)^2 (1 + 2 tau/h) < 1.
double longest_with(double square, double loss_time) {
  if (square == 0.0) return std::numeric_limits<double>::infinity();
  return std::sqrt(loss_time * loss_time + 4.0 / square) - loss_time;
}

}  // namespace

double stored_energy(const Chain& c, const ChainState& s, const EndMotion& end) {
  const std::size_t n = at(c.count());
  const bool along = c.directions != Directions::torsion;
  const bool around = c.directions != Directions::axial;
  double twice = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool lowered = i == 0 && c.top.axial != Top::Axial::hook_load;
    const bool driven = i == 0 && c.top.torsion == Top::Torsion::speed;
    const double inertia = c.elements.inertia[i] + (i == 0 ? c.top.inertia : 0.0);
    if (along && !lowered) twice += c.elements.mass[i] * s.velocity[i] * s.velocity[i];
    if (around && !driven) twice += inertia * s.rotary_speed[i] * s.rotary_speed[i];
    const double u = (i + 1 < n ? s.displacement[i + 1] : end.displacement) - s.displacement[i];
    const double q = (i + 1 < n ? s.angle[i + 1] : end.angle) - s.angle[i];
    if (along) twice += c.elements.axial[i] * u * u;
    if (around) twice += c.elements.torsional[i] * q * q;
  }
  if (around && c.top.torsion == Top::Torsion::pi) {
    const double behind = s.top.set_angle - s.angle[0];
    twice += c.top.integral * behind * behind;
  }
  return 0.5 * twice;
}

SurfaceLoad surface_load(const Chain& c, const ChainState& s, const ChainWork& w) {
  SurfaceLoad l;
  l.hook_load = c.top.axial == Top::Axial::hook_load
                    ? s.top.hook_load
                    : w.tension[0] + c.contact.weight[0] -
                          c.axial_damping * c.elements.mass[0] * s.velocity[0];
  if (c.top.torsion == Top::Torsion::speed) {
    l.torque = w.torque[0] + c.torsional_damping * c.elements.inertia[0] * s.rotary_speed[0];
  } else {
    const double motor = c.top.integral * (s.top.set_angle - s.angle[0]) +
                         c.top.proportional * (s.top.set_speed - s.rotary_speed[0]);
    l.torque = std::clamp(motor, -c.top.torque_limit, c.top.torque_limit);
  }
  return l;
}

double longest_step(const Chain& c, double end_mass, double end_inertia) {
  double longest = std::numeric_limits<double>::infinity();
  if (c.directions != Directions::torsion) {
    Held top;
    if (c.top.axial == Top::Axial::hook_load) top.mass = c.elements.mass[0];
    longest = longest_with(largest_rate(c.elements.axial, c.elements.mass, top, end_mass),
                           c.axial_loss_time);
  }
  if (c.directions != Directions::axial) {
    Held top;
    if (c.top.torsion == Top::Torsion::pi)
      top = {c.elements.inertia[0] + c.top.inertia, c.top.integral};
    const double rate = largest_rate(c.elements.torsional, c.elements.inertia, top, end_inertia);
    longest = std::min(longest, longest_with(rate, c.torsional_loss_time));
  }
  return longest;
}

}  // namespace tdbd::string
