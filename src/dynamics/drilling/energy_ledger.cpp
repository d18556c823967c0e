#include "dynamics/drilling/energy_ledger.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/observed_order.hpp"
#include "dynamics/momenta.hpp"

namespace tdbd::dynamics {

StoredEnergy stored_energy(const DrillingSystem& s, const Configuration& at,
                           const DrillingState& state) {
  const RotationState& r = state.rotation;
  StoredEnergy e;
  e.translation = 0.5 * state.momentum_W.squaredNorm() / s.mass;
  for (std::size_t k = 0; k < r.cone_momenta.size(); ++k)
    e.cones += 0.5 * r.cone_momenta[k] * r.cone_momenta[k] / s.gyrostat.cones[k].axial_inertia;
  e.rotation = kinetic_energy(s.gyrostat, r) - e.cones;
  if (s.rock.mass > 0.0) e.rock = 0.5 * state.rock_momentum * state.rock_momentum / s.rock.mass;
  e.string = at.pull.energy;
  e.wall = wall_energy(s, at);
  e.rock_mount = rock_energy(s, state);
  e.chain = at.chain_energy;
  return e;
}

double total(const StoredEnergy& e) {
  return e.translation + e.rotation + e.cones + e.rock + e.string + e.wall + e.rock_mount + e.chain;
}

double lost(const EnergyLedger& l) {
  return l.damped_string + l.damped_bearings + l.damped_rock + l.wall_loss + l.wall_friction +
         l.chain_friction + l.chain_damping + l.chain_loss + l.top_damping;
}

double residual(const StoredEnergy& now, const EnergyLedger& l) {
  const double put_in = l.top + l.gravity + l.chain_gravity + l.cut_bit + l.cut_rock;
  return (total(now) - l.start) - put_in + lost(l);
}

double throughput(const EnergyLedger& l) {
  return std::abs(l.start) + std::abs(l.top) + std::abs(l.gravity) + std::abs(l.chain_gravity) +
         std::abs(l.cut_bit) + std::abs(l.cut_rock);
}

namespace {

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

ResidualOrder residual_order(double h, const Window& window) {
  ResidualOrder found;
  for (int level = 0, parts = 1; level < residual_levels; ++level, parts *= 2) {
    const WindowResiduals w = window(parts);
    const double size = root_mean_square(w.at_instants);
    const double steps = static_cast<double>(w.at_instants.size()) * parts;
    const double rounding = order_rounding_per_step * steps * w.scale;
    found.steps.push_back(h / parts);
    found.residuals.push_back(size);
    if (!(size > rounding) && found.reason.empty())
      found.reason = fmt::format(
          "the residual is at rounding level: {:.3g} J with a step of {:.4g} s and {:.3g} J of "
          "energy "
          "in and out",
          size, h / parts, w.scale);
  }
  if (found.reason.empty()) found.order = least_squares_order(found.steps, found.residuals);
  return found;
}

}  // namespace tdbd::dynamics
