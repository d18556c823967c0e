#pragma once

#include "forces/part/directions.hpp"

namespace tdbd::forces {

/// A surface that presses on rock, forces (4) (reconstructed). Crushing is rigid-plastic: the normal
/// force is `limit` where the surface moves into the rock (v_n > 0), 0 where it lifts (v_n < 0), and
/// anything between where it does neither. Friction opposes the slip v_t with at most mu times the
/// normal force. So the force never pulls, does no positive work, and satisfies Coulomb's law for
/// every motion.
///
/// With a `ramp` above 0 the normal force rises from 0 at v_n = 0 to `limit` at v_n = ramp |v_t|.
struct Pressing {
  double limit = 0.0;  ///< N, normal force at the full contact stress
  double ramp = 0.0;   ///< tangent of the angle of motion into the rock at which the stress is full
  Sliding sliding;
  double slip_speed = 0.0;  ///< m/s, slip_share of friction where the motion is known
};

/// The force of a pressing surface whose motion is known: of a prescribed motion, or an explicit
/// step. Where the surface slides and moves neither in nor out, to within rounding, a law without a
/// ramp has its full force (a wear flat under a given motion); at rest there is no force. Friction
/// fades below slip_speed. A step that solves for force and velocity together (simulation (13)) needs
/// neither convention.
PartForce pressing_force(const PartCut& cut, const Pressing& pressing);

/// The velocity of the cut along its surface, m/s; 0 where only rounding is left of it.
Vec3 slip_velocity(const Vec3& velocity, const Vec3& normal);

}  // namespace tdbd::forces
