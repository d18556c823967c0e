#include "dynamics/rotation/step.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tdbd::dynamics {
namespace {

bool solves(Drift drift) { return drift == Drift::lie_midpoint || drift == Drift::lie_mean; }

std::string drift_name(Drift drift) {
  return drift == Drift::lie_midpoint ? "lie-midpoint" : "lie-mean";
}

}  // namespace

std::string too_long_message(const Gyrostat& g, const Loads& loads, const Integrator& integrator,
                             double h, const Rotating& r) {
  constexpr int halvings = 60;
  std::string would = "no shorter step that converges was found";
  double shorter = h;
  for (int i = 0; i < halvings; ++i) {
    shorter *= 0.5;
    Rotating trial = r;
    if (try_step(g, loads, integrator, shorter, trial) == LieOutcome::too_long) continue;
    would = fmt::format("a step of {:.6g} s converges", shorter);
    break;
  }
  return fmt::format(
      "the {} drift does not converge at t = {:.9g} s with a step of {:.6g} s (|W| h = {:.3g} "
      "rad); "
      "{}",
      drift_name(integrator.drift), r.state.time, h,
      std::abs(h) * angular_velocity(g, r.state).norm(), would);
}

template <>
void step<double>(const Gyrostat& g, const Loads& loads, const Integrator& integrator, double h,
                  Rotating& r) {
  if (!solves(integrator.drift)) {
    try_step(g, loads, integrator, h, r);
    return;
  }
  r.step_start = r.state;
  r.step_torque = r.torque;
  if (try_step(g, loads, integrator, h, r) == LieOutcome::solved) return;
  r.state = r.step_start;
  r.torque = r.step_torque;
  throw RunError(too_long_message(g, loads, integrator, h, r));
}

Vec3 sampled_torque(const SampledTorque& samples, double time) {
  const std::vector<double>& t = samples.times;
  if (t.empty()) return Vec3::Zero();
  const auto after = std::upper_bound(t.begin(), t.end(), time);
  if (after == t.begin()) return samples.torques.front();
  if (after == t.end()) return samples.torques.back();
  const auto i = static_cast<std::size_t>(after - t.begin());
  const double f = (time - t[i - 1]) / (t[i] - t[i - 1]);
  return (1.0 - f) * samples.torques[i - 1] + f * samples.torques[i];
}

void add_timed_torque(const Loads& loads, double time, TimedTorque& sum) {
  const auto add = [&](TorqueFrame frame, const Vec3& torque) {
    (frame == TorqueFrame::body ? sum.body_B : sum.space_W) += torque;
  };
  for (const HarmonicTorque& h : loads.harmonics)
    add(h.frame, std::cos(h.angular_frequency * time + h.phase) * h.amplitude);
  for (const SampledTorque& s : loads.samples) add(s.frame, sampled_torque(s, time));
}

double potential_energy(const Loads& loads, const RotationState& s) {
  double energy = loads.gravity_moment * (s.q_WB * loads.gravity_arm_B).z();
  if (!loads.stiffness_W.isZero(0.0)) energy += spring_energy(loads.stiffness_W, s);
  return energy;
}

}  // namespace tdbd::dynamics
