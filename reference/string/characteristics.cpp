#include "reference/string/characteristics.hpp"

#include <cmath>

namespace tdbd::reference {
namespace {

// In a cell the speed is down + up, and the load (torque transmitted downward, or minus tension) is
// Z (down - up). `down` travels downward, `up` upward.

/// Speed of the body at the end after one step: I w' = 2 Z down - Z w - friction, solved exactly,
/// piecewise where friction changes sign.
double end_after(const WaveRod& rod, double arriving, double speed) {
  const double z = rod.impedance.back(), drive = 2.0 * z * arriving;
  if (rod.end_inertia == 0.0) {  // massless: the load equals the friction
    const double wanted = std::abs(drive) - rod.sliding;
    if (speed == 0.0 && std::abs(drive) <= rod.resting) return 0.0;
    return wanted > 0.0 ? std::copysign(wanted / z, drive) : 0.0;
  }
  double left = rod.step;
  while (left > 0.0) {
    if (speed == 0.0 && std::abs(drive) <= rod.resting) return 0.0;
    const double sign = speed != 0.0 ? std::copysign(1.0, speed) : std::copysign(1.0, drive);
    const double final = (drive - sign * rod.sliding) / z, rate = z / rod.end_inertia;
    const double next = final + (speed - final) * std::exp(-rate * left);
    if (speed == 0.0 || next * speed > 0.0) return next;
    left -= std::log((speed - final) / -final) / rate;
    speed = 0.0;
  }
  return speed;
}

}  // namespace

WaveState uniform_waves(const WaveRod& rod, double speed, double load) {
  WaveState s;
  for (const double z : rod.impedance) {
    s.down.push_back(0.5 * (speed + load / z));
    s.up.push_back(0.5 * (speed - load / z));
  }
  s.end_speed = speed;
  return s;
}

void advance_waves(const WaveRod& rod, double top_speed, WaveState& s) {
  const std::size_t n = rod.impedance.size();
  std::vector<double> down(n), up(n);
  down[0] = top_speed - s.up[0];
  for (std::size_t k = 1; k < n; ++k) {  // between cells: equal speed, equal load
    const double above = rod.impedance[k - 1], below = rod.impedance[k];
    const double speed = 2.0 * (above * s.down[k - 1] + below * s.up[k]) / (above + below);
    down[k] = speed - s.up[k];
    up[k - 1] = speed - s.down[k - 1];
  }
  // A wave that arrives during the step has this speed; the reflected wave follows from the body's
  // mean speed.
  const double before = s.end_speed;
  s.end_speed = end_after(rod, s.down[n - 1], before);
  up[n - 1] = 0.5 * (before + s.end_speed) - s.down[n - 1];
  if (rod.end_inertia == 0.0) up[n - 1] = s.end_speed - s.down[n - 1];
  s.down = down;
  s.up = up;
  s.time += rod.step;
}

double node_speed(const WaveState& s, int node) {
  const auto k = static_cast<std::size_t>(node);
  return s.down[k] + s.up[k];
}

double cell_load(const WaveRod& rod, const WaveState& s, int cell) {
  const auto k = static_cast<std::size_t>(cell);
  return rod.impedance[k] * (s.down[k] - s.up[k]);
}

}  // namespace tdbd::reference
