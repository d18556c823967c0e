#pragma once

#include <vector>

#include "reference/dynamics/lumped_drilling.hpp"

namespace tdbd::reference {

/// A flat foot on horizontal rock, as one point of the bit.
struct Foot {
  Vec3 place_B = Vec3::Zero();  ///< m
  double limit = 0.0;           ///< N, normal force at which it crushes the rock
};

/// Regularized crushing and friction, forces (4): the normal force rises to its limit over
/// `crushing_speed`, friction to its bound over `slip_speed`. Both are errors of the twin that
/// vanish with these speeds.
struct SmoothContact {
  double mu = 0.0;              ///< 1
  double crushing_speed = 0.0;  ///< m/s
  double slip_speed = 0.0;      ///< m/s
};

/// The force on a foot that moves at v_W on horizontal rock, N.
Vec3 foot_force(const Foot& foot, const SmoothContact& contact, const Vec3& v_W);

/// The feet as the law of a lumped bit. Feet above the deepest place that they have reached are
/// free. `crushed` (m along z, one per foot) is that place and is owned by the caller.
LumpedLaw law_of_feet(const std::vector<Foot>& feet, const SmoothContact& contact,
                      const std::vector<double>& crushed);

/// Integrates the motion of a body on feet over `duration` in equal Runge-Kutta steps. The rock is
/// crushed after each step.
LumpedRun move_on_feet(const dynamics::DrillingSystem& system, const std::vector<Foot>& feet,
                       const SmoothContact& contact, const LumpedState& start, double duration,
                       int steps);

}  // namespace tdbd::reference
