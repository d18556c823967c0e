#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/gyrostat.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/schedule.hpp"
#include "string/chain.hpp"

/// A bit on a drill string in a borehole, as plain data: dynamics (9) to (12) (thesis: eqs.
/// 2.1-2.3). Frames: W is space, z down; B is the bit, whose parts are given relative to its
/// origin.
namespace tdbd::dynamics {

/// What the dampers of the string are connected to.
enum class DamperEnd {
  space,  ///< a fixed point, as in eqs. 2.1 and 2.3: mud and wall
  top,    ///< the moving top: losses inside the string; no force on a bit that moves like the top
};

/// The string as springs and dampers between bit and top (eqs. 2.1, 2.3). Matrices are symmetric
/// and positive semidefinite, frame W. Translational springs act on the displacement of the
/// attachment, rotational springs on the angles (swing_x, swing_y, twist - angle of the top).
struct DrillString {
  Vec3 attachment_B = Vec3::Zero();    ///< m, where the string is attached to the bit
  Vec3 rest_W = Vec3::Zero();          ///< m, position of the attachment if the string is slack
  Mat3 stiffness = Mat3::Zero();       ///< Kt, N/m
  Mat3 damping = Mat3::Zero();         ///< Dt, N s/m
  Mat3 turn_stiffness = Mat3::Zero();  ///< Kr, N m/rad
  Mat3 turn_damping = Mat3::Zero();    ///< Dr, N m s/rad
  DamperEnd damper_end = DamperEnd::space;
};

/// Control of the top along z.
enum class AxialMode {
  rate,  ///< lowered at a given rate; the weight on bit results from the axial spring
  load,  ///< loaded with a given force instead of the axial spring; the penetration results
};

/// The top of the string.
struct TopDrive {
  Schedule speed;  ///< rad/s about +z
  AxialMode axial = AxialMode::rate;
  /// Lowering rate, m/s along +z. For a loaded top that does not follow the bit, this is the
  /// expected rate of penetration: dampers that end at the top then resist only deviations from it.
  Schedule rate;
  /// N: the weight on a bit at rest. The hook carries the weight of the bit's own mass, so gravity
  /// does not add to it.
  Schedule load;
  double start_angle = 0.0;  ///< rad, at t = 0; nonzero for a string that is already wound up
  /// Time constant tau, s. A loaded top moves down at the rate r = DrillingState::top_rate, with
  /// r' = (v_z - r) / tau, where v_z is the velocity of the attachment. The mean force of a damper
  /// is then the mean of D tau r', which tends to 0 in the long run. With tau = 0 the top moves at
  /// `rate`.
  double following_time = 0.0;
};

/// A circular wall around the z axis of space that a ring of the bit touches. At penetration p it
/// pushes back with the force k p while p grows, and with e^2 k p while p decreases, so the rebound
/// speed is e times the impact speed. Coulomb friction acts at the contact point, against slip
/// around the wall and along it.
struct Wall {
  double stiffness = 0.0;    ///< k, N/m; 0: no wall
  double clearance = 0.0;    ///< radius of the hole minus that of the ring, m
  double ring_radius = 0.0;  ///< m
  double ring_z_B = 0.0;     ///< height of the ring in the bit's frame, m
  double restitution = 1.0;  ///< e, in [0, 1]
  double friction = 0.0;     ///< Coulomb friction coefficient
  double slip_speed = 1e-3;  ///< v0 of the friction force N tanh(v / v0), m/s; 0: Coulomb's law
};

/// Rock that can move along z (eq. 2.2), as in a laboratory. Mass 0 means fixed rock.
struct RockMount {
  double mass = 0.0;       ///< kg
  double stiffness = 0.0;  ///< N/m
  double damping = 0.0;    ///< N s/m
};

/// A damper along one direction of space.
struct PrincipalDamper {
  Vec3 axis_W = Vec3::UnitX();
  double coefficient = 0.0;  ///< N s/m, or N m s/rad
};

/// A distributed string between the top and the springs of DrillString. The axial and torsional
/// stiffnesses of these springs are those of the last element of the chain, and their upper end is
/// the last own node of the chain. The chain rotates at TopDrive::speed and is lowered at
/// TopDrive::rate.
struct ChainedString {
  string::Chain chain;
  Schedule hook_load = {};      ///< N: string::Top::Axial::hook_load, averaged over each step
  double surface_weight = 0.0;  ///< N, set point: string::Top::Axial::autodriller
};

struct DrillingSystem {
  double mass = 0.0;                    ///< M, kg: bit, cones and the moving part of the string
  Vec3 centre_B = Vec3::Zero();         ///< centre of mass, m
  Gyrostat gyrostat;                    ///< inertias about the centre of mass
  std::vector<double> bearing_damping;  ///< N m s/rad, one per cone; empty: none
  DrillString string;
  std::optional<ChainedString> chained;
  TopDrive top;
  Wall wall;
  RockMount rock;
  Integrator integrator;        ///< order must be 2
  double gravity = 0.0;         ///< m/s2 along +z, the axis of the hole
  double gravity_across = 0.0;  ///< m/s2 along +x, the low side of an inclined hole

  // Derived by make_drilling_system.
  Mat3 spring = Mat3::Zero();  ///< stiffness of the string, without z if the top is loaded
  std::array<PrincipalDamper, 3> dampers, turn_dampers;
};

/// Why this is not a valid system, with the invalid value; empty if it is valid.
std::string drilling_problem(const DrillingSystem& system);

/// Weight of bit and string, N. In an inclined hole, x points to the low side.
inline Vec3 weight_W(const DrillingSystem& s) {
  return s.mass * Vec3(s.gravity_across, 0.0, s.gravity);
}

/// Computes the derived members. Throws InputError with the result of drilling_problem.
DrillingSystem make_drilling_system(DrillingSystem system);

/// The upper end of the string's springs if it is a node of a chain: position along z and angle
/// about z, relative to the end of the slack string. The rates are those of the current drift.
struct UpperEnd {
  double z = 0.0, angle = 0.0;     ///< m, rad
  double rate = 0.0, speed = 0.0;  ///< m/s, rad/s

  template <class Archive>
  void serialize(Archive& a) {
    a(z, angle, rate, speed);
  }
};

/// Positions and momenta of bit and rock. The time is RotationState::time.
struct DrillingState {
  RotationState rotation;          ///< about the centre of mass
  Vec3 c_W = Vec3::Zero();         ///< centre of mass, m
  Vec3 momentum_W = Vec3::Zero();  ///< M c', N s
  double rock_z = 0.0;             ///< displacement of the rock along +z, m
  double rock_momentum = 0.0;      ///< N s
  double top_rate = 0.0;           ///< m/s along +z, rate of a top that follows the bit
  UpperEnd upper;                  ///< used if the string is a chain

  template <class Archive>
  void serialize(Archive& a) {
    a(rotation, c_W, momentum_W, rock_z, rock_momentum, top_rate, upper);
  }
};

/// When the torques on the cones' own spins act during a step h.
enum class ConeImpulse {
  halves,  ///< over h/2 in each half of the step, like all other impulses
  at_end,  ///< over h at the end: for torques evaluated at the resulting spins
};

/// Forces of cutting on bit and rock at one instant.
struct Wrench {
  Vec3 force_W = Vec3::Zero();   ///< N, on the bit including the cones
  Vec3 torque_W = Vec3::Zero();  ///< N m, the same forces about the centre of mass
  std::vector<double> cones;     ///< N m, T_k . s_k, of the forces on cone k; empty: none
  double rock_force = 0.0;       ///< N along +z, on the rock: -force_W.z (action and reaction)
  ConeImpulse cone_impulse = ConeImpulse::halves;

  template <class Archive>
  void serialize(Archive& a) {
    a(force_W, torque_W, cones, rock_force, cone_impulse);
  }
};

/// Velocities computed from the momenta of a state.
struct DrillingVelocity {
  Vec3 v_W = Vec3::Zero();         ///< of the centre of mass, m/s
  Vec3 w_W = Vec3::Zero();         ///< angular, rad/s
  std::vector<double> cone_rates;  ///< phi_k', rad/s
  double rock = 0.0;               ///< m/s along +z
};

}  // namespace tdbd::dynamics
