#include "dynamics/drilling/divergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tdbd::dynamics {
namespace {

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

/// Name of the first quantity that is not finite.
std::string not_finite(const Drilling& d) {
  const RotationState& r = d.state.rotation;
  const Wrench& w = d.wrench;
  if (!w.force_W.allFinite() || !std::isfinite(w.rock_force)) return "the force of cutting";
  if (!w.torque_W.allFinite()) return "the torque of cutting";
  if (!finite(w.cones)) return "a cone's torque of cutting";
  if (!d.state.c_W.allFinite() || !d.state.momentum_W.allFinite()) return "the bit's motion";
  if (!r.q_WB.coeffs().allFinite() || !r.momentum_W.allFinite()) return "the bit's rotation";
  if (!finite(r.cone_angles) || !finite(r.cone_momenta)) return "a cone's rotation";
  if (!std::isfinite(d.state.rock_z) || !std::isfinite(d.state.rock_momentum))
    return "the rock's motion";
  return "";
}

std::string beyond(const char* what, double value, double bound, const char* unit) {
  if (std::abs(value) <= bound) return "";
  return fmt::format("{}: {:.4g} {}, beyond {:.4g}", what, value, unit, bound);
}

std::string too_fast(const DrillingVelocity& v, const DivergenceBounds& b) {
  for (const std::string& why :
       {beyond("the bit's speed along x", v.v_W.x(), b.speed, "m/s"),
        beyond("the bit's speed along y", v.v_W.y(), b.speed, "m/s"),
        beyond("the bit's speed along z", v.v_W.z(), b.speed, "m/s"),
        beyond("the bit's tilt rate", v.w_W.head<2>().norm(), b.angular_speed, "rad/s"),
        beyond("the bit's rotary speed", v.w_W.z(), b.angular_speed, "rad/s"),
        beyond("the rock's speed", v.rock, b.speed, "m/s")})
    if (!why.empty()) return why;
  for (std::size_t k = 0; k < v.cone_rates.size(); ++k)
    if (std::abs(v.cone_rates[k]) > b.angular_speed)
      return fmt::format("cone {}'s speed: {:.4g} rad/s, beyond {:.4g}", k + 1, v.cone_rates[k],
                         b.angular_speed);
  return "";
}

/// Name of the largest energy contribution.
const char* largest_store(const StoredEnergy& e) {
  const std::array<std::pair<double, const char*>, 7> stores{
      {{e.translation, "the bit's translation"},
       {e.rotation, "the bit's rotation"},
       {e.cones, "the cones"},
       {e.rock, "the rock's motion"},
       {e.string, "the string"},
       {e.wall, "the wall"},
       {e.rock_mount, "the rock's mount"}}};
  return std::max_element(stores.begin(), stores.end())->second;
}

}  // namespace

std::string divergence(const DrillingSystem& system, const Drilling& d, const DrillingWork& work,
                       const DivergenceBounds& bounds) {
  const auto at = [&](const std::string& why) {
    return fmt::format("{} at t = {:.9g} s", why, d.state.rotation.time);
  };
  if (const std::string what = not_finite(d); !what.empty()) return at(what + " is not finite");
  if (const std::string why = too_fast(work.closing, bounds); !why.empty()) return at(why);
  const StoredEnergy now = stored_energy(system, work.at, d.state);
  const double left = residual(now, d.ledger);
  const double moved = throughput(d.ledger);
  if (std::abs(left) <= bounds.energy_residual * moved + bounds.least_energy) return "";
  return at(
      fmt::format("the energy residual: {:.4g} J with {:.4g} J of energy in and out, mostly in {}",
                  left, moved, largest_store(now)));
}

}  // namespace tdbd::dynamics
