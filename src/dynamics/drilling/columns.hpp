#pragma once

#include <Eigen/Core>

#include "dynamics/drilling/configuration.hpp"

/// Velocities, momenta and forces as columns in this order: translation along x, y, z in space,
/// rotation about x, y, z, each cone about its axis, and the rock along z if it can move.
namespace tdbd::dynamics {

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

}  // namespace tdbd::dynamics
