#pragma once

#include "dynamics/integrator.hpp"
#include "dynamics/torque.hpp"

namespace tdbd::dynamics {

/// A gyrostat on its way: its state, the torque of its last evaluation, which opens the next step,
/// and how many evaluations there were.
template <class S>
struct RotatingOf {
  RotationStateOf<S> state;
  TorqueOf<S> torque;
  long evaluations = 0;
};
using Rotating = RotatingOf<double>;

/// Evaluates the first torque.
template <class S>
RotatingOf<S> start(const Gyrostat& g, const Loads& loads, RotationStateOf<S> state);

/// One step of size h (thesis: 5.4, 5.5; formulation 5): kick(h/2), drifts, kick(h/2) with the
/// torque at the new attitude, for each stage of the composition. Throws RunError when a drift that
/// solves does not converge; the message names the step that would.
template <class S>
void step(const Gyrostat& g, const Loads& loads, const Integrator& integrator, double h,
          RotatingOf<S>& r);

}  // namespace tdbd::dynamics
