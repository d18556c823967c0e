#include "dynamics/drilling/configuration.hpp"

#include <cmath>

#include "dynamics/loads.hpp"
#include "dynamics/momenta.hpp"

namespace tdbd::dynamics {
namespace {

/// Forces of the translational springs and, if the top is loaded, of its load (eq. 2.1).
void apply_translational_springs(const DrillingSystem& s, const DrillingState& state,
                                 Configuration& at) {
  at.pull.arm_W = at.R_WB * (s.string.attachment_B - s.centre_B);
  const Vec3 stretch = state.c_W + at.pull.arm_W - at.top.point_W;
  at.pull.spring_W = -(s.spring * stretch);
  at.pull.load = s.top.axial == AxialMode::load
                     ? value_at(s.top.load, state.rotation.time) - s.mass * s.gravity
                     : 0.0;
  at.pull.energy = -0.5 * stretch.dot(at.pull.spring_W);
}

/// Torques of the rotational springs on swing and twist (eq. 2.3): minus the gradient of their
/// energy with respect to rotations in space.
void apply_rotational_springs(const DrillingSystem& s, const DrillingState& state,
                              Configuration& at) {
  const RotationState& r = state.rotation;
  const Mat3& K = s.string.turn_stiffness;
  at.pull.turn_W.setZero();
  at.pull.twist_moment = 0.0;
  if (K.isZero(0.0)) return;
  const rotation::Swing<double> swing = rotation::swing(r.q_WB);
  const double twist = rotation::twist_angle(r.q_WB, r.turns) - at.top.angle;
  const Vec3 angles(swing.b[0], swing.b[1], twist);
  const Vec3 moment = K * angles;
  at.pull.twist_moment = -moment[2];
  at.pull.turn_W = swing_torque_W<double>(moment[0], moment[1], swing) -
                   moment[2] * rotation::twist_gradient(r.q_WB);
  at.pull.energy += 0.5 * angles.dot(moment);
}

void find_wall_contact(const DrillingSystem& s, const DrillingState& state, Configuration& at) {
  WallContact& c = at.contact;
  c.depth = 0.0;
  if (s.wall.stiffness == 0.0) return;
  c.ring_arm_W = at.R_WB * (Vec3(0.0, 0.0, s.wall.ring_z_B) - s.centre_B);
  const Vec3 ring = state.c_W + c.ring_arm_W;
  const double eccentricity = std::hypot(ring.x(), ring.y());
  if (eccentricity <= s.wall.clearance || eccentricity == 0.0) return;
  c.depth = eccentricity - s.wall.clearance;
  c.outward_W = Vec3(ring.x(), ring.y(), 0.0) / eccentricity;
  c.tangent_W = Vec3(-c.outward_W.y(), c.outward_W.x(), 0.0);
  c.touch_arm_W = c.ring_arm_W + s.wall.ring_radius * c.outward_W;
}

}  // namespace

TopPosition top_position(const DrillingSystem& s, const DrillingState& state) {
  if (s.chained) return {s.string.rest_W + state.upper.z * Vec3::UnitZ(), state.upper.angle};
  const double t = state.rotation.time;
  TopPosition top{s.string.rest_W, s.top.start_angle + integral_to(s.top.speed, t)};
  if (s.top.axial == AxialMode::rate) top.point_W.z() += integral_to(s.top.rate, t);
  return top;
}

double mean_wall_stiffness(const Wall& w) {
  return 0.5 * w.stiffness * (1.0 + w.restitution * w.restitution);
}

void configure(const DrillingSystem& s, const DrillingState& state, Configuration& at) {
  at.R_WB = state.rotation.q_WB.toRotationMatrix();
  at.mobility_W = at.R_WB * s.gyrostat.carrier_inverse_B * at.R_WB.transpose();
  at.top = top_position(s, state);
  apply_translational_springs(s, state, at);
  apply_rotational_springs(s, state, at);
  find_wall_contact(s, state, at);
  const Vec3 pulled = at.pull.spring_W + at.pull.load * Vec3::UnitZ();
  const Vec3 pushed = -mean_wall_stiffness(s.wall) * at.contact.depth * at.contact.outward_W;
  Wrench& w = at.conservative;
  w.force_W = pulled + pushed + weight_W(s);
  w.torque_W = at.pull.turn_W + at.pull.arm_W.cross(pulled) + at.contact.ring_arm_W.cross(pushed);
  w.rock_force = -s.rock.stiffness * state.rock_z;
}

double wall_energy(const DrillingSystem& s, const Configuration& at) {
  return 0.5 * mean_wall_stiffness(s.wall) * at.contact.depth * at.contact.depth;
}

double rock_energy(const DrillingSystem& s, const DrillingState& state) {
  return 0.5 * s.rock.stiffness * state.rock_z * state.rock_z;
}

Pose bit_pose(const DrillingSystem& s, const DrillingState& state) {
  const Mat3 R_WB = state.rotation.q_WB.toRotationMatrix();
  return {R_WB, state.c_W - R_WB * s.centre_B};
}

void velocity(const DrillingSystem& s, const Configuration& at, const DrillingState& state,
              DrillingVelocity& out) {
  const RotationState& r = state.rotation;
  out.v_W = state.momentum_W / s.mass;
  out.w_W = at.mobility_W * (r.momentum_W - at.R_WB * cone_momentum_sum(s.gyrostat, r));
  const Vec3 w_B = at.R_WB.transpose() * out.w_W;
  out.cone_rates.resize(r.cone_momenta.size());
  for (std::size_t k = 0; k < r.cone_momenta.size(); ++k)
    out.cone_rates[k] = cone_rate<double>(s.gyrostat.cones[k], r.cone_momenta[k], w_B);
  out.rock = s.rock.mass > 0.0 ? state.rock_momentum / s.rock.mass : 0.0;
}

DrillingVelocity velocity(const DrillingSystem& s, const DrillingState& state) {
  Configuration at;
  configure(s, state, at);
  DrillingVelocity out;
  velocity(s, at, state, out);
  return out;
}

DrillingState make_drilling_state(const DrillingSystem& s, const Pose& X_WB,
                                  const DrillingVelocity& v, std::span<const double> cone_angles) {
  DrillingState state;
  state.rotation =
      make_state(s.gyrostat, X_WB.R, X_WB.R.transpose() * v.w_W, v.cone_rates, cone_angles);
  state.c_W = X_WB * s.centre_B;
  state.momentum_W = s.mass * v.v_W;
  state.rock_momentum = s.rock.mass * v.rock;
  return state;
}

Vec3 hanging_rest_W(const DrillingSystem& s, const DrillingState& state) {
  const Vec3 stretch = s.spring.completeOrthogonalDecomposition().solve(weight_W(s));
  return bit_pose(s, state) * s.string.attachment_B - stretch;
}

double power_on_bit(const Wrench& w, const DrillingVelocity& v, double cone_share) {
  double power = w.force_W.dot(v.v_W) + w.torque_W.dot(v.w_W);
  for (std::size_t k = 0; k < w.cones.size(); ++k)
    power += cone_share * w.cones[k] * v.cone_rates[k];
  return power;
}

double power_on_rock(const Wrench& w, const DrillingVelocity& v) { return w.rock_force * v.rock; }

}  // namespace tdbd::dynamics
