#pragma once

#include "dynamics/integrator.hpp"
#include "dynamics/rotation/drift_lie.hpp"
#include "dynamics/rotation/drift_split.hpp"
#include "rotation/swing_twist.hpp"

namespace tdbd::dynamics {

/// One torque-free drift over h. Only an implicit drift can fail (`too_long`); the state is then
/// unchanged.
template <class S>
LieOutcome drift(const Gyrostat& g, Drift kind, double h, RotationStateOf<S>& s) {
  switch (kind) {
    case Drift::split:
      drift_split(g, h, s);
      return LieOutcome::solved;
    case Drift::three_axis:
      drift_three_axis(g, h, s);
      return LieOutcome::solved;
    case Drift::lie_midpoint:
      return drift_lie(g, LieMomentum::middle, h, LieSolve{}, s);
    case Drift::lie_mean:
      return drift_lie(g, LieMomentum::mean, h, LieSolve{}, s);
  }
  return LieOutcome::too_long;
}

/// Advances the state from one kick to the next by `drifts` drifts, over h in total. Counts the
/// turns of the twist.
template <class S>
LieOutcome coast(const Gyrostat& g, Drift kind, int drifts, double h, RotationStateOf<S>& s) {
  for (int i = 0; i < drifts; ++i) {
    const Eigen::Quaternion<S> before = s.q_WB;
    if (drift(g, kind, h / drifts, s) == LieOutcome::too_long) return LieOutcome::too_long;
    s.turns += rotation::turns_passed(before, s.q_WB);
  }
  return LieOutcome::solved;
}

}  // namespace tdbd::dynamics
