#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/gyrostat.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/rotation_state.hpp"
#include "dynamics/schedule.hpp"
#include "string/chain.hpp"

/// A bit on a drill string in a borehole, as plain data: dynamics (9) to (12) (thesis: eqs.
/// 2.1-2.3). Frames: W space, z down; B the bit's own, at whose origin its parts are given.
namespace tdbd::dynamics {

/// What a damper of the string pulls back to.
enum class DamperEnd {
  space,  ///< rest, as in eqs. 2.1 and 2.3: mud and wall
  top,    ///< the motion of the top: losses inside the string; a bit that follows it feels none
};

/// The string as springs and dampers from the bit to the top (eqs. 2.1, 2.3). Matrices are
/// symmetric and not negative, frame W. Springs of translation act on the displacement of the
/// attachment, those of rotation on the angles (swing_x, swing_y, twist - top's angle).
struct DrillString {
  Vec3 attachment_B = Vec3::Zero();    ///< m, where the string holds the bit
  Vec3 rest_W = Vec3::Zero();          ///< m, the attachment's place where the string is slack
  Mat3 stiffness = Mat3::Zero();       ///< Kt, N/m
  Mat3 damping = Mat3::Zero();         ///< Dt, N s/m
  Mat3 turn_stiffness = Mat3::Zero();  ///< Kr, N m/rad
  Mat3 turn_damping = Mat3::Zero();    ///< Dr, N m s/rad
  DamperEnd damper_end = DamperEnd::space;
};

/// How the top moves along z.
enum class AxialMode {
  rate,  ///< lowered at a given rate: the axial spring pulls, the weight on bit is the result
  load,  ///< loaded with a given force in place of the axial spring: the penetration is the result
};

/// Top of the string.
struct TopDrive {
  Schedule speed;  ///< rad/s about +z
  AxialMode axial = AxialMode::rate;
  /// m/s along +z. Of a loaded top it is the penetration to expect, unless the top follows the bit:
  /// dampers that end at the top then resist what departs from it, not the drilling itself.
  Schedule rate;
  /// N: the weight on a bit at rest. The hook carries the weight of the bit's own mass, so that
  /// gravity does not come on top of it.
  Schedule load;
  double start_angle = 0.0;  ///< rad, at t = 0: a string that is wound up already
  /// tau, s: a loaded top goes down at DrillingState::top_rate r, with r' = (v_z - r) / tau after the
  /// attachment's velocity v_z. The mean of a damper's force is then that of D tau r': 0 in the long
  /// run. 0: it goes down at `rate`.
  double following_time = 0.0;
};

/// A circular wall around space z that a ring of the bit touches. Pressed in by p it pushes back
/// with k p, while p falls with e^2 k p: what comes back is e times as fast. Coulomb friction acts
/// where the ring touches, against its slip around the wall and along it.
struct Wall {
  double stiffness = 0.0;    ///< k, N/m; 0: no wall
  double clearance = 0.0;    ///< radius of the hole less that of the ring, m
  double ring_radius = 0.0;  ///< m
  double ring_z_B = 0.0;     ///< the ring's height in the bit's frame, m
  double restitution = 1.0;  ///< e, in [0, 1]
  double friction = 0.0;     ///< Coulomb's coefficient
  double slip_speed = 1e-3;  ///< v0 of friction N tanh(v / v0), m/s; 0: Coulomb's own law
};

/// Rock that may move along z (eq. 2.2), as in a laboratory. Mass 0: held.
struct RockMount {
  double mass = 0.0;       ///< kg
  double stiffness = 0.0;  ///< N/m
  double damping = 0.0;    ///< N s/m
};

/// A damper in one direction of space.
struct PrincipalDamper {
  Vec3 axis_W = Vec3::UnitX();
  double coefficient = 0.0;  ///< N s/m, or N m s/rad
};

/// A distributed string between the top and the springs of DrillString, whose axial and torsional
/// stiffnesses are those of the chain's last element: its upper end is the chain's last own node. The
/// chain turns with TopDrive::speed and is lowered at TopDrive::rate.
struct ChainedString {
  string::Chain chain;
  Schedule hook_load = {};      ///< N: string::Top::Axial::hook_load; its mean over each step
  double surface_weight = 0.0;  ///< N, to be kept: string::Top::Axial::autodriller
};

struct DrillingSystem {
  double mass = 0.0;             ///< M, kg: bit, cones and what of the string moves with them
  Vec3 centre_B = Vec3::Zero();  ///< centre of mass, m
  Gyrostat gyrostat;             ///< inertias about the centre of mass
  std::vector<double> bearing_damping;  ///< N m s/rad, one a cone; empty: none
  DrillString string;
  std::optional<ChainedString> chained;
  TopDrive top;
  Wall wall;
  RockMount rock;
  Integrator integrator;        ///< order 2
  double gravity = 0.0;         ///< m/s2 along +z, the hole's axis
  double gravity_across = 0.0;  ///< m/s2 along +x, the low side of an inclined hole

  // Derived by make_drilling_system.
  Mat3 spring = Mat3::Zero();  ///< the string's stiffness, without z when the top is loaded
  std::array<PrincipalDamper, 3> dampers, turn_dampers;
};

/// Why this is not a valid system, with the offending value; empty when it is.
std::string drilling_problem(const DrillingSystem& system);

/// Weight of bit and string, N. Across an inclined hole, x points to the low side.
inline Vec3 weight_W(const DrillingSystem& s) {
  return s.mass * Vec3(s.gravity_across, 0.0, s.gravity);
}

/// Derives the rest. Throws InputError with drilling_problem's reason.
DrillingSystem make_drilling_system(DrillingSystem system);

/// The upper end of the string's springs where it is a node of a chain: along and about z, from where the
/// slack string's end is. The rates are those of the drift under way.
struct UpperEnd {
  double z = 0.0, angle = 0.0;     ///< m, rad
  double rate = 0.0, speed = 0.0;  ///< m/s, rad/s
};

/// Where bit and rock are and how they move. The time is that of the rotation.
struct DrillingState {
  RotationState rotation;          ///< about the centre of mass
  Vec3 c_W = Vec3::Zero();         ///< centre of mass, m
  Vec3 momentum_W = Vec3::Zero();  ///< M c', N s
  double rock_z = 0.0;             ///< how far the rock has moved along +z, m
  double rock_momentum = 0.0;      ///< N s
  double top_rate = 0.0;           ///< m/s along +z, of a top that follows the bit
  UpperEnd upper;                  ///< of a string on a chain
};

/// When the impulses of a step h reach the cones' own spins.
enum class ConeImpulse {
  halves,  ///< h/2 at either end of the step, like every other impulse
  at_end,  ///< h at its end: for torques that were evaluated at the spins they lead to
};

/// What cutting does to bit and rock at one instant.
struct Wrench {
  Vec3 force_W = Vec3::Zero();   ///< N, on the bit, cones included
  Vec3 torque_W = Vec3::Zero();  ///< N m, the same forces about the centre of mass
  std::vector<double> cones;     ///< N m, T_k . s_k, of the forces on cone k; empty: none
  double rock_force = 0.0;       ///< N along +z, on the rock: -force_W.z by action and reaction
  ConeImpulse cone_impulse = ConeImpulse::halves;
};

/// Velocities that follow from a state's momenta.
struct DrillingVelocity {
  Vec3 v_W = Vec3::Zero();         ///< of the centre of mass, m/s
  Vec3 w_W = Vec3::Zero();         ///< angular, rad/s
  std::vector<double> cone_rates;  ///< phi_k', rad/s
  double rock = 0.0;               ///< m/s along +z
};

}  // namespace tdbd::dynamics
