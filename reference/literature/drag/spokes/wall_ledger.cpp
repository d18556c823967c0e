#include "reference/literature/drag/spokes/wall_ledger.hpp"

#include <array>
#include <cmath>

#include "reference/literature/drag/spokes/rk4.hpp"

namespace tdbd::reference {
namespace {

/// Horizontal position and velocity.
using LevelState = std::array<double, 4>;

double wall_depth(const WallLedgerCase& s, const LevelState& y) {
  return std::max(0.0, std::hypot(y[0], y[1]) - s.clearance);
}

/// Negated ratio of acceleration to position.
double pull(const WallLedgerCase& s, const LevelState& y) {
  const double distance = std::hypot(y[0], y[1]);
  const double wall = distance > 0.0 ? s.wall * wall_depth(s, y) / distance : 0.0;
  return (s.spring + wall) / s.mass;
}

double level_energy(const WallLedgerCase& s, const LevelState& y) {
  const double depth = wall_depth(s, y);
  return 0.5 * s.mass * (y[2] * y[2] + y[3] * y[3]) + 0.5 * s.spring * (y[0] * y[0] + y[1] * y[1]) +
         0.5 * s.wall * depth * depth;
}

void level_rates(const WallLedgerCase& s, const LevelState& y, LevelState& rates) {
  const double a = pull(s, y);
  rates = {y[2], y[3], -a * y[0], -a * y[1]};
}

void kick(const WallLedgerCase& s, LevelState& y, double h) {
  const double a = pull(s, y);
  y[2] -= h * a * y[0];
  y[3] -= h * a * y[1];
}

void verlet_step(const WallLedgerCase& s, LevelState& y) {
  kick(s, y, s.step / 2.0);
  y[0] += s.step * y[2];
  y[1] += s.step * y[3];
  kick(s, y, s.step / 2.0);
}

}  // namespace

double runge_kutta_energy_factor(double wh) {
  const double x = wh * wh;
  return 1.0 - x * x * x / 72.0 + x * x * x * x / 576.0;
}

WallLedger wall_ledger(const WallLedgerCase& s) {
  LevelState rk{s.c[0], s.c[1], s.v[0], s.v[1]}, verlet = rk;
  WallLedger ledger{{0.0}, {level_energy(s, rk)}, {level_energy(s, rk)}};
  const long steps = std::lround(s.duration / s.step);
  for (long i = 1; i <= steps; ++i) {
    rk4_step([&](double, const LevelState& y, LevelState& rates) { level_rates(s, y, rates); }, 0.0,
             s.step, rk);
    verlet_step(s, verlet);
    ledger.time.push_back(static_cast<double>(i) * s.step);
    ledger.runge_kutta.push_back(level_energy(s, rk));
    ledger.symplectic.push_back(level_energy(s, verlet));
  }
  return ledger;
}

}  // namespace tdbd::reference
