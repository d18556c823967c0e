#pragma once

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/loads.hpp"
#include "dynamics/momenta.hpp"
#include "dynamics/rotation/drift.hpp"

namespace tdbd::dynamics {

/// Torques on a gyrostat at one instant (T and T_k of dynamics (3); thesis: 5.2.2).
template <class S>
struct TorqueOf {
  Vec3Of<S> total_W = Vec3Of<S>::Zero();  ///< N m, external, on body and cones
  std::vector<S> cones;                   ///< N m, T_k . s_k: rates of change of the cone momenta

  template <class Archive>
  void serialize(Archive& a) {
    a(total_W, cones);
  }
};
using Torque = TorqueOf<double>;

/// Whether a load depends on velocity (dampers do).
inline bool depends_on_velocity(const Loads& loads) {
  if (!loads.damping_W.isZero(0.0)) return true;
  for (const ConeLoad& cone : loads.cones)
    if (cone.damping != 0.0) return true;
  return false;
}

/// Torque of the samples at a time, N m, in their frame.
Vec3 sampled_torque(const SampledTorque& samples, double time);

/// Sum of the loads that depend only on time, N m, separately for each frame.
struct TimedTorque {
  Vec3 body_B, space_W;
};
void add_timed_torque(const Loads& loads, double time, TimedTorque& sum);

/// Torque of gravity about the fixed point: minus the gradient of V. Its vertical component is
/// exactly zero.
template <class S>
Vec3Of<S> gravity_torque_W(const Loads& loads, const RotationStateOf<S>& s) {
  const Vec3Of<S> e = s.q_WB * Vec3Of<S>(loads.gravity_arm_B.cast<S>());
  return {-loads.gravity_moment * e[1], loads.gravity_moment * e[0], S(0)};
}

/// Adds the torques on the cones. The external part is also added to the total.
template <class S>
void add_cone_torques(const Gyrostat& g, const Loads& loads, const RotationStateOf<S>& s,
                      TorqueOf<S>& out) {
  for (std::size_t k = 0; k < loads.cones.size(); ++k) {
    const ConeLoad& load = loads.cones[k];
    out.cones[k] += load.internal + load.external;
    if (load.external != 0.0)
      out.total_W += s.q_WB * Vec3Of<S>((load.external * g.cones[k].axis_B).cast<S>());
  }
}

/// Torque of the loads that do not depend on velocity. Allocates nothing if `out` already has the
/// number of cones.
template <class S>
void evaluate_at_rest(const Gyrostat& g, const Loads& loads, const RotationStateOf<S>& s,
                      TorqueOf<S>& out) {
  TimedTorque timed{loads.body_torque_B, loads.space_torque_W};
  if (!loads.harmonics.empty() || !loads.samples.empty()) add_timed_torque(loads, s.time, timed);
  out.cones.resize(g.cones.size());
  for (S& torque : out.cones) torque = S(0);
  out.total_W = timed.space_W.cast<S>();
  if (!timed.body_B.isZero(0.0)) out.total_W += s.q_WB * Vec3Of<S>(timed.body_B.cast<S>());
  if (loads.gravity_moment != 0.0) out.total_W += gravity_torque_W(loads, s);
  if (!loads.stiffness_W.isZero(0.0)) out.total_W += spring_torque_W(loads.stiffness_W, s);
  add_cone_torques(g, loads, s, out);
}

/// Adds the torque of the dampers at the velocity of the state.
template <class S>
void add_damping(const Gyrostat& g, const Loads& loads, const RotationStateOf<S>& s,
                 TorqueOf<S>& out) {
  const Vec3Of<S> w_B = angular_velocity(g, s);
  out.total_W -= loads.damping_W.cast<S>().cwiseProduct(s.q_WB * w_B);
  for (std::size_t k = 0; k < loads.cones.size(); ++k)
    out.cones[k] -= loads.cones[k].damping * cone_rate<S>(g.cones[k], s.cone_momenta[k], w_B);
}

/// Torque of the loads at the time, attitude and momenta of the state.
template <class S>
void evaluate(const Gyrostat& g, const Loads& loads, const RotationStateOf<S>& s,
              TorqueOf<S>& out) {
  evaluate_at_rest(g, loads, s, out);
  if (depends_on_velocity(loads)) add_damping(g, loads, s, out);
}

/// Potential energy of gravity and springs, J.
double potential_energy(const Loads& loads, const RotationState& s);

/// Adds the impulse h times the torque. Momenta change, attitude and angles do not (thesis: 5.4.4).
template <class S>
void kick(double h, const TorqueOf<S>& torque, RotationStateOf<S>& s) {
  s.momentum_W += h * torque.total_W;
  for (std::size_t k = 0; k < s.cone_momenta.size(); ++k) s.cone_momenta[k] += h * torque.cones[k];
}

/// A gyrostat in motion: its state, the torque of its last evaluation, which is used again at the
/// start of the next step, and the number of evaluations.
template <class S>
struct RotatingOf {
  RotationStateOf<S> state;
  TorqueOf<S> torque;
  long evaluations = 0;

  // Work data of a step, reused so that later steps allocate nothing.
  RotationStateOf<S> predicted, kick_start, step_start;
  TorqueOf<S> step_torque;

  /// For checkpoints: without the buffers of a step.
  template <class Archive>
  void serialize(Archive& a) {
    a(state, torque, evaluations);
  }
};
using Rotating = RotatingOf<double>;

/// Largest difference of the momenta of two states, relative to those of the first.
template <class S>
S momentum_difference(const RotationStateOf<S>& a, const RotationStateOf<S>& b) {
  using std::abs;
  S difference = (a.momentum_W - b.momentum_W).squaredNorm(), scale = a.momentum_W.squaredNorm();
  for (std::size_t k = 0; k < a.cone_momenta.size(); ++k) {
    const S d = a.cone_momenta[k] - b.cone_momenta[k];
    difference += d * d;
    scale += a.cone_momenta[k] * a.cone_momenta[k];
  }
  return scale > S(0) ? S(difference / scale) : difference;
}

/// Closing kick whose torque is evaluated at the resulting momentum: the adjoint of the opening
/// kick, so that the step is symmetric. It is a fixed-point iteration; its contraction factor is
/// h/2 times the damping over the inertia. Throws RunError if it does not converge.
template <class S>
void implicit_kick(const Gyrostat& g, const Loads& loads, double h, RotatingOf<S>& r) {
  constexpr int iterations = 60;
  constexpr double settled = 1e-30;  // square of the relative change
  r.kick_start = r.state;
  for (int i = 0; i < iterations; ++i) {
    r.predicted = r.state;
    r.state = r.kick_start;
    kick(h, r.torque, r.state);
    evaluate(g, loads, r.state, r.torque);
    ++r.evaluations;
    if (i > 0 && momentum_difference(r.state, r.predicted) <= settled) return;
  }
  throw RunError(
      "the symmetric kick does not converge: the damping is too strong for the time step");
}

/// Closing kick with the torque at the new attitude. If the torque depends on velocity, it is
/// evaluated at the momentum predicted with the last torque; with the present momentum the step
/// would be first order.
template <class S>
void closing_kick(const Gyrostat& g, const Loads& loads, VelocityTorque rule, double h,
                  RotatingOf<S>& r) {
  if (!depends_on_velocity(loads)) {
    evaluate_at_rest(g, loads, r.state, r.torque);
  } else if (rule == VelocityTorque::symmetric) {
    return implicit_kick(g, loads, h, r);
  } else {
    r.predicted = r.state;
    kick(h, r.torque, r.predicted);
    evaluate(g, loads, r.predicted, r.torque);
  }
  ++r.evaluations;
  kick(h, r.torque, r.state);
}

/// Starts a rotation: evaluates the first torque.
template <class S>
RotatingOf<S> start(const Gyrostat& g, const Loads& loads, RotationStateOf<S> state) {
  RotatingOf<S> r;
  r.state = std::move(state);
  evaluate(g, loads, r.state, r.torque);
  r.evaluations = 1;
  return r;
}

/// One stage of a composition: kick(h/2), drifts over h, kick(h/2) with the torque at the new
/// attitude (dynamics (4); thesis: 5.4.4, 5.5, details reconstructed).
template <class S>
LieOutcome stage(const Gyrostat& g, const Loads& loads, const Integrator& integrator, double h,
                 RotatingOf<S>& r) {
  kick(0.5 * h, r.torque, r.state);
  if (coast(g, integrator.drift, integrator.drifts_per_step, h, r.state) == LieOutcome::too_long)
    return LieOutcome::too_long;
  r.state.time += h;
  closing_kick(g, loads, integrator.velocity_torque, 0.5 * h, r);
  return LieOutcome::solved;
}

/// Attempts a step of size h. If the result is `too_long`, the state is undefined.
template <class S>
LieOutcome try_step(const Gyrostat& g, const Loads& loads, const Integrator& integrator, double h,
                    RotatingOf<S>& r) {
  for (const double fraction : composition(integrator.order))
    if (stage(g, loads, integrator, fraction * h, r) == LieOutcome::too_long)
      return LieOutcome::too_long;
  return LieOutcome::solved;
}

/// Message for a step that is too long, with a step size that works. `r` is the state at the start
/// of the step.
std::string too_long_message(const Gyrostat& g, const Loads& loads, const Integrator& integrator,
                             double h, const Rotating& r);

/// One step of size h (s). The number of stages depends on the order; each evaluates the torque
/// once. Throws RunError if an implicit drift is too long.
template <class S>
void step(const Gyrostat& g, const Loads& loads, const Integrator& integrator, double h,
          RotatingOf<S>& r) {
  if (try_step(g, loads, integrator, h, r) == LieOutcome::too_long)
    throw RunError("the drift does not converge: too large a step");
}

/// Specialization for double: if it throws, the state is that before the step, and the message
/// states a step size that works.
template <>
void step<double>(const Gyrostat& g, const Loads& loads, const Integrator& integrator, double h,
                  Rotating& r);

}  // namespace tdbd::dynamics
