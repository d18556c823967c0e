#include "reference/string/chain_equations.hpp"

#include <cmath>

namespace tdbd::reference {
namespace {

using Column = std::vector<double>;

/// y: displacements, angles, velocities, rotary speeds, lost energy.
Column slopes(const SlidingChain& c, double time, const Column& y) {
  const std::size_t n = c.mass.size();
  Column pull(n), torque(n), side(n, 0.0), out(y.size());
  for (std::size_t k = 0; k < n; ++k) {
    const double u_above = k == 0 ? c.top_rate * time : y[k - 1];
    const double q_above = k == 0 ? c.top_speed * time : y[n + k - 1];
    pull[k] = c.axial[k] * (y[k] - u_above);
    torque[k] = c.torsional[k] * (q_above - y[n + k]);
  }
  for (std::size_t p = 0; p < c.node.size(); ++p) {
    const double t = pull[static_cast<std::size_t>(c.element[p])];
    side[static_cast<std::size_t>(c.node[p])] +=
        std::sqrt(c.bend[p] * t * t + 2.0 * c.mixed[p] * t + c.side[p]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const double v = y[2 * n + k], w = y[3 * n + k], r = c.radius[k];
    const double slip = std::hypot(v, r * w), drag = c.friction[k] * side[k];
    const double share = slip > 0.0 ? drag / slip : 0.0;
    const double below = k + 1 < n ? pull[k + 1] : 0.0,
                 torque_below = k + 1 < n ? torque[k + 1] : 0.0;
    out[k] = v;
    out[n + k] = w;
    out[2 * n + k] = (below - pull[k] + c.weight[k] - share * v) / c.mass[k] - c.axial_damping * v;
    out[3 * n + k] =
        (torque[k] - torque_below - share * r * r * w) / c.inertia[k] - c.torsional_damping * w;
    out[4 * n] += drag * slip;
  }
  return out;
}

Column plus(const Column& a, double x, const Column& b) {
  Column sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] = a[i] + x * b[i];
  return sum;
}

}  // namespace

void advance_sliding(const SlidingChain& c, double h, long steps, SlidingState& s) {
  Column y;
  for (const Column* part : {&s.displacement, &s.angle, &s.velocity, &s.rotary_speed})
    y.insert(y.end(), part->begin(), part->end());
  y.push_back(s.lost);
  for (long i = 0; i < steps; ++i) {
    const Column k1 = slopes(c, s.time, y), k2 = slopes(c, s.time + 0.5 * h, plus(y, 0.5 * h, k1));
    const Column k3 = slopes(c, s.time + 0.5 * h, plus(y, 0.5 * h, k2));
    const Column k4 = slopes(c, s.time + h, plus(y, h, k3));
    for (std::size_t j = 0; j < y.size(); ++j)
      y[j] += h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
    s.time += h;
  }
  const auto n = static_cast<std::ptrdiff_t>(c.mass.size());
  s.displacement.assign(y.begin(), y.begin() + n);
  s.angle.assign(y.begin() + n, y.begin() + 2 * n);
  s.velocity.assign(y.begin() + 2 * n, y.begin() + 3 * n);
  s.rotary_speed.assign(y.begin() + 3 * n, y.begin() + 4 * n);
  s.lost = y.back();
}

}  // namespace tdbd::reference
