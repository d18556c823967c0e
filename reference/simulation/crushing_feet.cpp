#include "reference/simulation/crushing_feet.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {
namespace {

Vec3 arm_of(const dynamics::DrillingSystem& system, const Foot& foot, const Mat3& R_WB) {
  return R_WB * (foot.place_B - system.centre_B);
}

void add(LumpedEnergy& sum, const LumpedEnergy& e) {
  sum.top += e.top;
  sum.gravity += e.gravity;
  sum.cut_bit += e.cut_bit;
  sum.damped_string += e.damped_string;
  sum.wall_loss += e.wall_loss;
  sum.wall_friction += e.wall_friction;
}

}  // namespace

Vec3 foot_force(const Foot& foot, const SmoothContact& contact, const Vec3& v_W) {
  const double normal = foot.limit * std::clamp(v_W.z() / contact.crushing_speed, 0.0, 1.0);
  const Vec3 slip(v_W.x(), v_W.y(), 0.0);
  return -normal * Vec3::UnitZ() -
         contact.mu * normal * slip / std::hypot(slip.norm(), contact.slip_speed);
}

LumpedLaw law_of_feet(const std::vector<Foot>& feet, const SmoothContact& contact,
                      const std::vector<double>& crushed) {
  return [&feet, contact, &crushed](const dynamics::DrillingSystem& system,
                                    const dynamics::DrillingState& s,
                                    const dynamics::DrillingVelocity& v, dynamics::Wrench& w) {
    const Mat3 R_WB = s.rotation.q_WB.toRotationMatrix();
    for (std::size_t i = 0; i < feet.size(); ++i) {
      constexpr double rounding = 1e-12;  // m
      const Vec3 arm_W = arm_of(system, feet[i], R_WB);
      if ((s.c_W + arm_W).z() < crushed[i] - rounding) continue;
      const Vec3 force_W = foot_force(feet[i], contact, v.v_W + v.w_W.cross(arm_W));
      w.force_W += force_W;
      w.torque_W += arm_W.cross(force_W);
    }
  };
}

LumpedRun move_on_feet(const dynamics::DrillingSystem& system, const std::vector<Foot>& feet,
                       const SmoothContact& contact, const LumpedState& start, double duration,
                       int steps) {
  std::vector<double> crushed;
  LumpedRun run;
  run.state = start;
  const auto height = [&](const Foot& foot) {
    return (run.state.c_W + arm_of(system, foot, run.state.bit.R_WB)).z();
  };
  for (const Foot& foot : feet) crushed.push_back(height(foot));
  const LumpedLaw law = law_of_feet(feet, contact, crushed);
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const LumpedRun next = lumped_drilling_rk4(system, law, run.state, run.state.bit.time + h, 1);
    run.state = next.state;
    add(run.energy, next.energy);
    run.evaluations += next.evaluations;
    for (std::size_t k = 0; k < feet.size(); ++k)
      crushed[k] = std::max(crushed[k], height(feet[k]));
  }
  return run;
}

}  // namespace tdbd::reference
