#pragma once

#include <limits>

#include "core/error.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/rotation/torque.hpp"

namespace tdbd::dynamics {

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

}  // namespace tdbd::dynamics
