#pragma once

#include <Eigen/Core>
#include <string>

#include "dynamics/drilling/configuration.hpp"
#include "dynamics/drilling/drilling_step.hpp"
#include "dynamics/drilling/drilling_system.hpp"

namespace tdbd::dynamics {

// Velocities, momenta and forces as columns in this order: translation along x, y, z in space,
// rotation about x, y, z, each cone about its axis, and the rock along z if it can move.

/// Number of cones of the bit.
inline int cones_of(const DrillingSystem& system) {
  return static_cast<int>(system.gyrostat.cones.size());
}

/// Number of degrees of freedom of bit, cones and rock.
int freedoms(const DrillingSystem& system);

void to_column(const DrillingSystem& system, const DrillingVelocity& v, Eigen::VectorXd& u);
void from_column(const DrillingSystem& system, const Eigen::VectorXd& u, DrillingVelocity& v);

void momenta_column(const DrillingSystem& system, const DrillingState& state, Eigen::VectorXd& p);
void add_impulse_column(const DrillingSystem& system, const Eigen::VectorXd& impulse,
                        DrillingState& state);

/// Sum of conservative forces and wrench, N and N m. `cone_share` scales the torques of the wrench
/// on the cones.
void force_column(const DrillingSystem& system, const Wrench& conservative, const Wrench& wrench,
                  double cone_share, Eigen::VectorXd& force);

/// Velocities from momenta, M^-1 p, without forming the matrix.
void velocities_of(const DrillingSystem& system, const Configuration& at,
                   const Eigen::Ref<const Eigen::VectorXd>& p, Eigen::Ref<Eigen::VectorXd> u);

/// Linear response of the velocity between the drifts of this step and the next one to the wrench
/// of this step:
///   u = free + A f                                                                            (18)
/// u: velocity of the centre of mass, angular velocity, cone rates, and velocity of the rock along
/// z if it can move; f: force, torque about the centre, T_k . s_k, force on the rock. An addition
/// of TDBD [+].
struct Response {
  Eigen::VectorXd free;  ///< m/s, rad/s
  Eigen::MatrixXd A;     ///< m/s and rad/s per N and per N m
};

/// Work data, reused so that later steps allocate nothing.
struct ResponseWork {
  Wrench wrench;
  DrillingVelocity velocity;
  Eigen::VectorXd column;
};

/// Evaluates velocity_after_kicks once per degree of freedom and once without a wrench. The result is
/// exact with dampers, whose flows are linear. Friction at the wall is nonlinear; the result is
/// then a secant over the probes. Torques on cones act at the end of an open step, and in halves
/// for a state between two steps.
void find_response(const DrillingSystem& system, double h, const Drilling& d, RemainingKicks kicks,
                   DrillingWork& work, ResponseWork& scratch, Response& response);

/// Derivatives of the cutting forces with respect to the position and velocity of the bit, summed
/// over all parts. The axial ones act between bit and rock along z.
struct ContactSlopes {
  double lateral_stiffness = 0.0;  ///< N/m, along x and along y
  double axial_stiffness = 0.0;    ///< N/m: dWOB/dz
  double twist_stiffness = 0.0;    ///< N m/rad
  double lateral_damping = 0.0;    ///< N s/m
  double axial_damping = 0.0;      ///< N s/m
  double twist_damping = 0.0;      ///< N m s/rad: slope of a torque that changes sign with velocity
};

/// Limit of the time step, dynamics (16). Kicks and drift are stable if h times the highest angular
/// frequency of string, wall in contact and rock contact is below 2. The exact dampers do not
/// change that. If a law depends on velocity, evaluated at the predicted momenta, h times its
/// largest rate (slope over mass) must also be below 1.
struct StabilityLimit {
  double frequency = 0.0;  ///< rad/s, the highest over all attitudes about z
  double rate = 0.0;       ///< 1/s
  double step = 0.0;       ///< s, the smaller limit; infinite if there is none
  std::string mode;        ///< dominant motion: "along z", "turning about z", ...
};
StabilityLimit stability_limit(const DrillingSystem& system, const ContactSlopes& contact);

/// Why a step of h (s) is too long, with the limit and a suitable step; empty if it is not.
std::string stability_problem(const DrillingSystem& system, const ContactSlopes& contact, double h);

/// Bounds beyond which the results of a run are meaningless.
struct DivergenceBounds {
  double speed = 100.0;           ///< m/s, of bit and rock
  double angular_speed = 1e4;     ///< rad/s, of bit and cones
  double energy_residual = 10.0;  ///< relative to the throughput of the energy ledger
  double least_energy = 1.0;      ///< J, added to the bound, for a bit at rest
};

/// Checks a closed step for divergence. Returns the diverged quantity with its value and the time,
/// or an empty string. Speeds are means over the closing kick. Quantities that are not finite are
/// reported first, and the wrench before the state, because it is the cause.
std::string divergence(const DrillingSystem& system, const Drilling& d, const DrillingWork& work,
                       const DivergenceBounds& bounds = {});

}  // namespace tdbd::dynamics
