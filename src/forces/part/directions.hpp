#pragma once

#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Effective back rake of a face, rad, in [0, right angle], forces (2): the angle between its
/// outward normal X and its velocity v. It has no sign: a face that leans over the rock ahead of it
/// and one that leans back equally have the same value, and side rake counts. 0 at rest; a right
/// angle for a face that moves backwards. Thesis: nomenclature, Ebr ("effective back rake of
/// cutter, angle of attack"). The angle of attack of the section (rock/section) is the complement:
/// a right angle minus the rake.
double effective_back_rake(const Vec3& face_normal, const Vec3& velocity);

/// The directions of the force of a cut: F = -Ft e1 - Fn e2. Thesis: app. C, E1 and E2;
/// reconstructed.
struct CutFrame {
  Vec3 e1 = Vec3::Zero();  ///< along the velocity
  Vec3 e2 = Vec3::Zero();  ///< normal into the rock, made perpendicular to the velocity
};

/// e1 and e2 of forces (3), from a velocity v over the rock and a unit normal n into it. With a =
/// v.n / |v|, e1 = v/|v| and e2 = (n - a e1)/|n - a e1| for a part that drills. Other motions use
/// these rules of TDBD [+]:
/// - within 30 degrees of a plunge or a withdrawal along n, e2 decreases continuously to 0, so that
///   the force does not flip if the sideways motion does;
/// - if the part leaves the rock (a < 0), the component of e1 along n is removed;
/// - at rest e1 = 0 and e2 = n.
///
/// Therefore for any Ft, Fn >= 0 the force never pulls the bit into the rock (F.n <= 0) and does no
/// positive work on it (F.v <= 0). The frame is continuous in v except at rest.
CutFrame cut_frame(const Vec3& velocity, const Vec3& normal);

/// Factor on the force of a law at a speed u (m/s), u/sqrt(u^2 + slip_speed^2). It makes the force
/// a continuous function of the velocity that is zero at rest. A bit at rest on rock under load
/// therefore creeps, more slowly than slip_speed. An addition of TDBD [+].
double slip_share(double speed, double slip_speed);

/// Friction between two sliding surfaces.
struct Sliding {
  double mu = 0.0;               ///< 1, friction coefficient at low speed
  double weakening = 0.0;        ///< 1, share of mu that is lost at high speed
  double weakening_speed = 1.0;  ///< m/s, speed at which most of that share is lost
};

/// The friction of a law with these coefficients.
template <class L>
Sliding sliding_of(const L& law) {
  return {law.mu, law.weakening, law.weakening_speed};
}

/// mu (1 - weakening (1 - exp(-u/weakening_speed))): friction that decreases with the speed u
/// (m/s), one cause of stick-slip. The form is that of whole-bit codes, applied here to one
/// contact.
double friction_at(const Sliding& sliding, double speed);

/// The force of a cut for Fn and Ft of a law (N, >= 0): -share (Ft e1 + Fn e2), forces (3).
PartForce cutting_force(const PartCut& cut, double Ft, double Fn, double slip_speed);

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
