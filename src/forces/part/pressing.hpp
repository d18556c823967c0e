#pragma once

#include "forces/part/directions.hpp"

namespace tdbd::forces {

/// A surface that presses on rock, forces (4) (reconstructed). Crushing is rigid-plastic: the
/// normal force is `limit` if the surface moves into the rock (v_n > 0), 0 if it lifts (v_n < 0),
/// and any value in between if it does neither. Friction opposes the slip v_t with at most mu times
/// the normal force. The force therefore never pulls, does no positive work, and satisfies
/// Coulomb's law for every motion.
///
/// With `ramp` > 0 the normal force rises from 0 at v_n = 0 to `limit` at v_n = ramp |v_t|.
struct Pressing {
  double limit = 0.0;  ///< N, normal force at full contact stress
  double ramp = 0.0;   ///< tangent of the angle of motion into the rock at which the stress is full
  Sliding sliding;
  double slip_speed = 0.0;  ///< m/s, for slip_share of the friction of a known motion
};

/// The force of a pressing surface with known motion, which is prescribed or that of an explicit
/// step. If the surface slides without moving in or out, up to rounding, a law without a ramp has
/// its full force (a wear flat in prescribed motion). At rest there is no force. Friction fades
/// below slip_speed. A step that solves for force and velocity together (simulation (13)) needs
/// neither convention.
PartForce pressing_force(const PartCut& cut, const Pressing& pressing);

/// The velocity of the cut along its surface, m/s; 0 if only rounding is left.
Vec3 slip_velocity(const Vec3& velocity, const Vec3& normal);

}  // namespace tdbd::forces
