#include "string/statics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

namespace {

/// Number of frequencies below omega (square, 1/s2): the number of negative pivots if nodes are
/// eliminated from the end upwards.
int count_below(const std::vector<double>& k, const std::vector<double>& m, double square) {
  double below = 0.0;  // dynamic stiffness of the part below a node
  int negative = 0;
  for (std::size_t i = k.size(); i > 0; --i) {
    const double own = below - square * m[i];
    const double pivot = k[i - 1] + own;
    negative += pivot < 0.0;
    below = pivot == 0.0 ? -HUGE_VAL : k[i - 1] * (own / pivot);
  }
  return negative;
}

/// Mode shape below a fixed top, computed downwards from the force in the first element.
std::vector<double> shape_of(const std::vector<double>& k, const std::vector<double>& m,
                             double square) {
  std::vector<double> shape{0.0};
  double force = 1.0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    shape.push_back(shape.back() + force / k[i]);
    force -= square * m[i + 1] * shape.back();
  }
  const auto largest = *std::max_element(
      shape.begin(), shape.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (double& x : shape) x /= largest;
  return shape;
}

}  // namespace

std::vector<Mode> lowest_modes(const std::vector<double>& k, const std::vector<double>& m,
                               int count) {
  double bound = 0.0;
  for (std::size_t i = 1; i <= k.size(); ++i)
    bound = std::max(bound, 2.0 * (k[i - 1] + (i < k.size() ? k[i] : 0.0)) / m[i]);
  std::vector<Mode> modes;
  for (int j = 0; j < std::min(count, static_cast<int>(k.size())); ++j) {
    double lo = 0.0, hi = std::sqrt(bound) * 1.001;
    for (double mid = 0.5 * hi; mid > lo && mid < hi; mid = 0.5 * (lo + hi))
      (count_below(k, m, mid * mid) > j ? hi : lo) = mid;
    modes.push_back({lo / (2.0 * std::numbers::pi), shape_of(k, m, lo * lo)});
  }
  return modes;
}

}  // namespace tdbd::string
