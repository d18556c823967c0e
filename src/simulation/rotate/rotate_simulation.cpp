#include "simulation/rotate/rotate_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "rotation/quaternion.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::RotationState;

void raise(double& largest, double value) { largest = std::max(largest, value); }

void watch(const RotateCase& c, const RotationState& s, Invariants& v) {
  const Vec3 change = s.momentum_W - v.momentum_W;
  raise(v.momentum_drift_squared, change.squaredNorm());
  raise(v.vertical_drift, std::abs(change.z()));
  for (std::size_t k = 0; k < v.cone_momenta.size(); ++k)
    raise(v.cone_momentum_drift, std::abs(s.cone_momenta[k] - v.cone_momenta[k]));
  raise(v.quaternion_defect, std::abs(s.q_WB.squaredNorm() - 1.0));
  raise(v.energy_drift, std::abs(total_energy(c, s) - v.energy));
  raise(v.largest_speed, dynamics::angular_velocity(c.body, s).norm());
}

bool conserves_energy(const dynamics::Loads& loads) {
  const auto acts = [](const dynamics::ConeLoad& cone) {
    return cone.internal != 0.0 || cone.external != 0.0 || cone.damping != 0.0;
  };
  return loads.body_torque_B.isZero(0.0) && loads.space_torque_W.isZero(0.0) &&
         loads.damping_W.isZero(0.0) && loads.harmonics.empty() && loads.samples.empty() &&
         std::ranges::none_of(loads.cones, acts);
}

bool is_finite(const RotationState& s) {
  double sum = s.momentum_W.sum() + s.q_WB.coeffs().sum();
  for (std::size_t k = 0; k < s.cone_angles.size(); ++k)
    sum += s.cone_angles[k] + s.cone_momenta[k];
  return std::isfinite(sum);
}

}  // namespace

std::vector<CaseWarning> end_warnings(const RotateCase& c, const RotateSimulation& s) {
  constexpr double largest_drift = 0.01;
  std::vector<CaseWarning> warnings;
  const Invariants& v = s.invariants;
  const std::string key = "time.step";
  const double drift = v.energy_drift / v.energy_scale;
  if (conserves_energy(c.loads) && drift > largest_drift)
    warnings.push_back(
        {c.place_of_step, key,
         fmt::format("the energy of this conservative motion has changed by {:.2g} % of "
                     "its scale; for meaningful results use a shorter step than "
                     "{:.3g} s, so that it changes by less than {:.2g} %",
                     100.0 * drift, c.time.step, 100.0 * largest_drift)});
  const double turn = v.largest_speed * c.time.step;
  const bool warned = std::ranges::count(c.warnings, key, &CaseWarning::key) > 0;
  if (turn > largest_turn_in_step && !warned)
    warnings.push_back(
        {c.place_of_step, key,
         fmt::format("the body has turned by up to {:.3g} rad in a step of {:.3g} s; "
                     "for meaningful results use at most {} rad: {:.2g} s",
                     turn, c.time.step, largest_turn_in_step,
                     largest_turn_in_step / v.largest_speed)});
  return warnings;
}

double total_energy(const RotateCase& c, const RotationState& s) {
  return dynamics::kinetic_energy(c.body, s) + dynamics::potential_energy(c.loads, s);
}

double twist(const RotationState& s) { return rotation::twist_angle(s.q_WB, s.turns); }

RotateSimulation start(const RotateCase& c) {
  RotateSimulation s;
  s.rotating = dynamics::start(c.body, c.loads, c.start);
  const RotationState& state = s.rotating.state;
  Invariants& v = s.invariants;
  v.momentum_W = state.momentum_W;
  v.cone_momenta = state.cone_momenta;
  v.energy = total_energy(c, state);
  v.energy_scale = dynamics::kinetic_energy(c.body, state) +
                   std::abs(dynamics::potential_energy(c.loads, state)) +
                   std::abs(c.loads.gravity_moment);
  if (v.energy_scale == 0.0) v.energy_scale = 1.0;
  if (!is_finite(state) || !std::isfinite(v.energy))
    throw InputError(c.path +
                     ": found a start whose energy is not finite, expected smaller numbers");
  watch(c, state, v);
  return s;
}

void advance(const RotateCase& c, RotateSimulation& s, long steps) {
  RotationState& state = s.rotating.state;
  for (long i = 0; i < steps; ++i) {
    dynamics::step(c.body, c.loads, c.integrator, c.time.step, s.rotating);
    ++s.steps_done;
    state.time = c.time.step * static_cast<double>(s.steps_done);  // a sum would round each step
    watch(c, state, s.invariants);
  }
  if (!is_finite(state))
    throw RunError("the state is no longer finite: the step is too long for these loads");
}

}  // namespace tdbd::simulation
