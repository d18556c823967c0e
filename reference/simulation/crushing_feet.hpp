#pragma once

#include <vector>

#include "reference/dynamics/lumped_drilling.hpp"

namespace tdbd::reference {

/// A flat foot on level rock, as one point of the bit.
struct Foot {
  Vec3 place_B = Vec3::Zero();  ///< m
  double limit = 0.0;           ///< N, normal force at which it crushes the rock
};

/// Crushing and friction, forces (4), made smooth: the normal force rises to its limit over
/// `crushing_speed`, friction to its bound over `slip_speed`. Both are errors of the twin, and vanish
/// with the speeds.
struct SmoothContact {
  double mu = 0.0;              ///< 1
  double crushing_speed = 0.0;  ///< m/s
  double slip_speed = 0.0;      ///< m/s
};

/// The force of a foot that moves at v_W on level rock, N.
Vec3 foot_force(const Foot& foot, const SmoothContact& contact, const Vec3& v_W);

/// The feet as the law of a lumped bit. Feet that have left the deepest place they were at are free;
/// `crushed` (m along z, one per foot) is that place, and belongs to the caller.
LumpedLaw law_of_feet(const std::vector<Foot>& feet, const SmoothContact& contact,
                      const std::vector<double>& crushed);

/// The motion of a body on feet over `duration` in equal steps of Runge-Kutta, the rock being
/// crushed after each of them.
LumpedRun move_on_feet(const dynamics::DrillingSystem& system, const std::vector<Foot>& feet,
                       const SmoothContact& contact, const LumpedState& start, double duration,
                       int steps);

}  // namespace tdbd::reference
