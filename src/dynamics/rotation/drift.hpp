#pragma once

#include "dynamics/integrator.hpp"
#include "dynamics/rotation/drift_lie.hpp"
#include "dynamics/rotation/drift_split.hpp"
#include "rotation/swing_twist.hpp"

namespace tdbd::dynamics {

/// One drift over h, free of torque. Only an implicit one can be too long; the state is then left
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

/// The time between two kicks: `drifts` drifts over h in all. Counts the windings of the twist.
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
