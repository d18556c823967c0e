#include "reference/dynamics/lumped_forces.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "reference/dynamics/applied_torque.hpp"

namespace tdbd::reference {
namespace {

using dynamics::AxialMode;
using dynamics::DamperEnd;
using dynamics::DrillingSystem;

/// Velocities of bit, cones and rock.
dynamics::DrillingVelocity velocities(const DrillingSystem& system, const LumpedState& s) {
  dynamics::DrillingVelocity v;
  const Vec3 w_B = bit_angular_velocity(system.gyrostat, s.bit);
  v.v_W = s.v_W;
  v.w_W = s.bit.R_WB * w_B;
  for (std::size_t k = 0; k < s.bit.cone_momenta.size(); ++k) {
    const dynamics::Cone& cone = system.gyrostat.cones[k];
    v.cone_rates.push_back(s.bit.cone_momenta[k] / cone.axial_inertia - cone.axis_B.dot(w_B));
  }
  v.rock = s.rock_v;
  return v;
}

/// Converts a state to the form that the law uses.
dynamics::DrillingState drilling_state(const DrillingSystem& system, const LumpedState& s) {
  dynamics::DrillingState d;
  d.rotation.q_WB = Eigen::Quaterniond(s.bit.R_WB).normalized();
  d.rotation.momentum_W = s.bit.R_WB * s.bit.body_momentum_B;
  d.rotation.cone_angles = s.bit.cone_angles;
  d.rotation.cone_momenta = s.bit.cone_momenta;
  d.rotation.time = s.bit.time;
  d.c_W = s.c_W;
  d.momentum_W = system.mass * s.v_W;
  d.rock_z = s.rock_z;
  d.rock_momentum = system.rock.mass * s.rock_v;
  return d;
}

/// dV/dx for a change of the state by x times a unit. V must be smooth on the scale `h`.
double slope(const std::function<double(double)>& V, double h) {
  constexpr double weights[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  double sum = 0.0;
  for (int i = 1; i <= 4; ++i) sum += weights[i - 1] * (V(i * h) - V(-i * h));
  return sum / h;
}

/// Minus the gradient of the string's energy: over c, and over rotations in space.
void add_springs(const DrillingSystem& system, const LumpedState& s, LumpedForces& f) {
  constexpr double length = 1e-3, angle = 0.02;
  for (int i = 0; i < 3; ++i) {
    LumpedState moved = s;
    f.force_W[i] -= slope(
        [&](double x) {
          moved.c_W[i] = s.c_W[i] + x;
          return string_energy(system, moved);
        },
        length);
    moved.c_W = s.c_W;
    f.torque_W[i] -= slope(
        [&](double x) {
          moved.bit.R_WB = Eigen::AngleAxisd(x, Vec3::Unit(i)) * s.bit.R_WB;
          return string_energy(system, moved);
        },
        angle);
  }
}

/// Work of the top on the springs (the change of their energy due to its own motion) and of its
/// load.
void add_top(const DrillingSystem& system, const LumpedState& s, LumpedForces& f,
             const dynamics::DrillingVelocity& v) {
  LumpedState moved = s;
  const double by_z = slope(
      [&](double x) {
        moved.top_z = s.top_z + x;
        return string_energy(system, moved);
      },
      1e-3);
  moved.top_z = s.top_z;
  const double by_angle = slope(
      [&](double x) {
        moved.top_angle = s.top_angle + x;
        return string_energy(system, moved);
      },
      0.02);
  f.power.top += by_angle * scheduled(system.top.speed, s.bit.time);
  if (system.top.axial == AxialMode::rate) {
    f.power.top += by_z * scheduled(system.top.rate, s.bit.time);
    return;
  }
  const Vec3 load_W =
      (scheduled(system.top.load, s.bit.time) - system.mass * system.gravity) * Vec3::UnitZ();
  const Vec3 arm_W = s.bit.R_WB * (system.string.attachment_B - system.centre_B);
  f.force_W += load_W;
  f.torque_W += arm_W.cross(load_W);
  f.power.top += load_W.dot(v.v_W + v.w_W.cross(arm_W));
}

/// -Dt and -Dr times the velocities relative to the damper's other end.
void add_dampers(const DrillingSystem& system, const LumpedState& s, LumpedForces& f,
                 const dynamics::DrillingVelocity& v) {
  const bool follows = system.string.damper_end == DamperEnd::top;
  const Vec3 top_v = (follows ? scheduled(system.top.rate, s.bit.time) : 0.0) * Vec3::UnitZ();
  const Vec3 top_w = (follows ? scheduled(system.top.speed, s.bit.time) : 0.0) * Vec3::UnitZ();
  const Vec3 arm_W = s.bit.R_WB * (system.string.attachment_B - system.centre_B);
  const Vec3 slip = v.v_W + v.w_W.cross(arm_W) - top_v, turn = v.w_W - top_w;
  const Vec3 force = -system.string.damping * slip, torque = -system.string.turn_damping * turn;
  f.force_W += force;
  f.torque_W += torque + arm_W.cross(force);
  f.power.top += force.dot(top_v) + torque.dot(top_w);
  f.power.damped_string -= force.dot(slip) + torque.dot(turn);
  for (std::size_t k = 0; k < f.cones.size(); ++k) {
    const double damping = system.bearing_damping.empty() ? 0.0 : system.bearing_damping[k];
    f.cones[k] -= damping * v.cone_rates[k];
    f.power.damped_bearings += damping * v.cone_rates[k] * v.cone_rates[k];
  }
}

void add_wall(const DrillingSystem& system, const LumpedState& s, LumpedForces& f,
              const dynamics::DrillingVelocity& v) {
  const dynamics::Wall& w = system.wall;
  const Vec3 ring_arm = s.bit.R_WB * (Vec3(0.0, 0.0, w.ring_z_B) - system.centre_B);
  Vec3 out = s.c_W + ring_arm;
  out.z() = 0.0;
  const double depth = out.norm() - w.clearance;
  if (w.stiffness == 0.0 || depth <= 0.0) return;
  out.normalize();
  const Vec3 touch_arm = ring_arm + w.ring_radius * out;
  const double pressing = (v.v_W + v.w_W.cross(ring_arm)).dot(out);
  const double e2 = w.restitution * w.restitution;
  const double stiffness = w.stiffness * (pressing > 0.0 ? 1.0 : e2);
  const Vec3 touching = v.v_W + v.w_W.cross(touch_arm), slip = touching - touching.dot(out) * out;
  const double speed = slip.norm();
  const double rubbing = w.friction * stiffness * depth * std::tanh(speed / w.slip_speed);
  const Vec3 force = -stiffness * depth * out - (speed > 0.0 ? rubbing / speed : 0.0) * slip;
  f.force_W += force;
  f.torque_W += touch_arm.cross(force);
  f.power.wall_friction += rubbing * speed;
  f.power.wall_loss += (stiffness - 0.5 * w.stiffness * (1.0 + e2)) * depth * pressing;
}

void add_cutting(const DrillingSystem& system, const LumpedLaw& law, const LumpedState& s,
                 LumpedForces& f, const dynamics::DrillingVelocity& v) {
  if (!law) return;
  dynamics::Wrench w;
  w.cones.resize(f.cones.size(), 0.0);
  law(system, drilling_state(system, s), v, w);
  f.force_W += w.force_W;
  f.torque_W += w.torque_W;
  f.power.cut_bit += w.force_W.dot(v.v_W) + w.torque_W.dot(v.w_W);
  for (std::size_t k = 0; k < f.cones.size(); ++k) {
    f.cones[k] += w.cones[k];
    f.power.cut_bit += w.cones[k] * v.cone_rates[k];
  }
  f.rock_force += w.rock_force;
  f.power.cut_rock += w.rock_force * v.rock;
}

}  // namespace

double scheduled(const dynamics::Schedule& s, double t) {
  if (s.times.empty()) return 0.0;
  if (t < s.times.front()) return s.values.front();
  for (std::size_t i = 0; i + 1 < s.times.size(); ++i) {
    if (t >= s.times[i + 1]) continue;
    if (s.interpolation == dynamics::Interpolation::stepwise) return s.values[i];
    return s.values[i] +
           (s.values[i + 1] - s.values[i]) * (t - s.times[i]) / (s.times[i + 1] - s.times[i]);
  }
  return s.values.back();
}

double string_energy(const DrillingSystem& system, const LumpedState& s) {
  const dynamics::DrillString& string = system.string;
  Vec3 stretch = s.c_W + s.bit.R_WB * (string.attachment_B - system.centre_B) - string.rest_W -
                 s.top_z * Vec3::UnitZ();
  if (system.top.axial == AxialMode::load) stretch.z() = 0.0;
  const SwingTwist a = swing_twist(s.bit.R_WB, s.bit.twist);
  const Vec3 angles(a.swing_x_W, a.swing_y_W, a.twist - s.top_angle);
  return 0.5 * stretch.dot(string.stiffness * stretch) +
         0.5 * angles.dot(string.turn_stiffness * angles);
}

LumpedForces lumped_forces(const DrillingSystem& system, const LumpedLaw& law,
                           const LumpedState& s) {
  const dynamics::DrillingVelocity v = velocities(system, s);
  LumpedForces f;
  f.cones.resize(system.gyrostat.cones.size(), 0.0);
  const Vec3 weight_W = system.mass * system.gravity * Vec3::UnitZ();
  f.force_W = weight_W;
  f.power.gravity = weight_W.dot(v.v_W);
  add_springs(system, s, f);
  add_top(system, s, f, v);
  add_dampers(system, s, f, v);
  add_wall(system, s, f, v);
  add_cutting(system, law, s, f, v);
  f.rock_force -= system.rock.stiffness * s.rock_z + system.rock.damping * s.rock_v;
  f.power.damped_rock = system.rock.damping * s.rock_v * s.rock_v;
  return f;
}

}  // namespace tdbd::reference
