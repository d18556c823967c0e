#include "dynamics/rotation/kick.hpp"

#include <algorithm>

namespace tdbd::dynamics {

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
