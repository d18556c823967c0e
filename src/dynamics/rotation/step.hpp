#pragma once

#include "dynamics/integrator.hpp"
#include "dynamics/rotation/drift.hpp"
#include "dynamics/rotation/kick.hpp"

namespace tdbd::dynamics {

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
