#include "dynamics/drilling/exact_flow.hpp"

#include <cmath>

#include "dynamics/momenta.hpp"

namespace tdbd::dynamics {
namespace {

Vec3 angular_velocity_W(const DrillingSystem& s, const Configuration& at, const RotationState& r) {
  return at.mobility_W * (r.momentum_W - at.R_WB * cone_momentum_sum(s.gyrostat, r));
}

Along along_cone(const DrillingSystem& s, const Configuration& at, const RotationState& r, int k) {
  const auto i = static_cast<std::size_t>(k);
  const Cone& cone = s.gyrostat.cones[i];
  const Vec3 w_B = at.R_WB.transpose() * angular_velocity_W(s, at, r);
  const double through_bit = cone.axis_B.dot(s.gyrostat.carrier_inverse_B * cone.axis_B);
  return {cone_rate<double>(cone, r.cone_momenta[i], w_B), 1.0 / cone.axial_inertia + through_bit};
}

/// Whether the rate of the top is a part of the state.
bool top_follows_bit(const DrillingSystem& s) {
  return s.string.damper_end == DamperEnd::top && s.top.axial == AxialMode::load &&
         s.top.following_time > 0.0;
}

}  // namespace

Along along(const DrillingSystem& s, const Configuration& at, const DrillingState& state,
            const Direction& d) {
  if (d.cone >= 0) return along_cone(s, at, state.rotation, d.cone);
  if (d.rock != 0.0)
    return {d.rock * state.rock_momentum / s.rock.mass, d.rock * d.rock / s.rock.mass};
  Along a{d.force_W.dot(state.momentum_W) / s.mass, d.force_W.squaredNorm() / s.mass};
  if (d.torque_W.isZero(0.0)) return a;
  a.speed += d.torque_W.dot(angular_velocity_W(s, at, state.rotation));
  a.mobility += d.torque_W.dot(at.mobility_W * d.torque_W);
  return a;
}

void give_impulse(const Direction& d, double impulse, DrillingState& state) {
  state.momentum_W += impulse * d.force_W;
  state.rotation.momentum_W += impulse * d.torque_W;
  if (d.cone >= 0) state.rotation.cone_momenta[static_cast<std::size_t>(d.cone)] += impulse;
  state.rock_momentum += impulse * d.rock;
}

double damper_impulse(const Along& a, double coefficient, double other_end_speed, double time) {
  return (a.speed - other_end_speed) * std::expm1(-coefficient * a.mobility * time) / a.mobility;
}

double rate_of_damper_end(const DrillingSystem& s, const DrillingState& state) {
  if (s.string.damper_end == DamperEnd::space) return 0.0;
  return top_follows_bit(s) ? state.top_rate : value_at(s.top.rate, state.rotation.time);
}

void follow_bit(const DrillingSystem& s, const Configuration& at, double time,
                DrillingState& state) {
  if (!top_follows_bit(s)) return;
  const Direction down{Vec3::UnitZ(), at.pull.arm_W.cross(Vec3::UnitZ())};
  const double speed = along(s, at, state, down).speed;
  state.top_rate -= (speed - state.top_rate) * std::expm1(-time / s.top.following_time);
}

}  // namespace tdbd::dynamics
