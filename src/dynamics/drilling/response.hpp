#pragma once

#include <Eigen/Core>

#include "dynamics/drilling/configuration.hpp"
#include "dynamics/drilling/drilling_step.hpp"

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

}  // namespace tdbd::dynamics
