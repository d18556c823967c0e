#pragma once

#include <vector>

#include "dynamics/gyrostat.hpp"
#include "dynamics/loads.hpp"
#include "reference/dynamics/ode.hpp"

namespace tdbd::reference {

/// The bit with its cones as separate rigid bodies, connected by bearings. Frame B: the bit, whose
/// origin is the fixed point if it is pinned.
struct RigidBody {
  double mass = 1.0;                  ///< kg
  Vec3 centre_B = Vec3::Zero();       ///< m
  Mat3 inertia_B = Mat3::Identity();  ///< kg m2, about its own centre
};

struct JointedCone {
  double mass = 1.0;                ///< kg
  Vec3 bearing_B = Vec3::Zero();    ///< m, a point of the cone's axis at the bearing
  Vec3 axis_B = Vec3::UnitZ();      ///< unit
  double offset = 0.0;              ///< m, from the bearing to the cone's centre along the axis
  double axial_inertia = 0.0;       ///< kg m2
  double transverse_inertia = 0.0;  ///< kg m2, about the centre, at least half the axial
  /// Deviations that the program neglects, at the angle 0: the offset of the centre from the axis
  /// (m) and an addition to the inertia about the centre (kg m2).
  Vec3 off_axis_B = Vec3::Zero();
  Mat3 asymmetry_B = Mat3::Zero();
};

enum class Mount { free, pinned };

struct JointedBit {
  RigidBody body;  ///< without the cones
  std::vector<JointedCone> cones;
  Mount mount = Mount::free;
  double gravity = 0.0;                   ///< m/s2, along +ez, on every body
  Vec3 torque_B = Vec3::Zero();           ///< N m, on the body, constant in its frame
  std::vector<dynamics::ConeLoad> loads;  ///< one for each cone
};

/// The gyrostat with the same motion as the jointed bit: the locked inertia of all bodies about the
/// common centre of mass or the fixed point, and gravity as a moment about the fixed point (none if
/// free). The transverse inertias, masses and offsets enter the locked inertia only; the twin tests
/// this.
struct EquivalentGyrostat {
  dynamics::Gyrostat gyrostat;
  dynamics::Loads loads;
};
EquivalentGyrostat equivalent(const JointedBit& bit);

/// Position and motion of the jointed bit. Frames: W space, B bit.
struct JointedState {
  Mat3 R_WB = Mat3::Identity();      ///< of the body
  Vec3 w_B = Vec3::Zero();           ///< rad/s, of the body
  std::vector<double> cone_angles;   ///< rad, of the cones relative to the body, unwrapped
  std::vector<double> spins;         ///< rad/s, of the cones relative to the body
  Vec3 momentum_W = Vec3::Zero();    ///< N m s, about the common centre of mass or the pin
  std::vector<double> cone_momenta;  ///< N m s, of each cone about its axis
  double energy = 0.0;               ///< J, kinetic and gravitational, 0 at the origin's height
};

struct JointedRun {
  JointedState state;
  double largest_gap = 0.0;   ///< m, separation at bearings and pin due to drift
  double largest_tilt = 0.0;  ///< rad, between a cone's axis in the body and in the cone
  long evaluations = 0;       ///< of the right-hand side
};

/// Integrates a formulation that differs from that of a gyrostat, dynamics (3). Every body has position,
/// quaternion, velocity and angular velocity. Each bearing gives five equations for accelerations,
/// a pin three. The constraint forces are Lagrange multipliers of one dense linear system, which is
/// solved at every evaluation; GSL's rk8pd integrates. Constraints are not stabilized; their drift
/// is measured instead. Starts at t = 0 with cone angles 0 and the centre of mass at rest. Only
/// R_WB, w_B and spins of `start` are read. Throws RunError as integrate() does.
JointedRun jointed_run(const JointedBit& bit, const JointedState& start, double t_end,
                       const OdeTolerance& tolerance = {});

}  // namespace tdbd::reference
