#pragma once

#include <Eigen/Core>

#include "dynamics/drilling/configuration.hpp"

/// Velocities, momenta and forces as columns, in one order: along space x, y, z, about them, each
/// cone about its axis, and rock that may move.
namespace tdbd::dynamics {

/// How many cones the bit has.
inline int cones_of(const DrillingSystem& system) {
  return static_cast<int>(system.gyrostat.cones.size());
}

/// How many velocities bit, cones and rock have.
int freedoms(const DrillingSystem& system);

void to_column(const DrillingSystem& system, const DrillingVelocity& v, Eigen::VectorXd& u);
void from_column(const DrillingSystem& system, const Eigen::VectorXd& u, DrillingVelocity& v);

void momenta_column(const DrillingSystem& system, const DrillingState& state, Eigen::VectorXd& p);
void add_impulse_column(const DrillingSystem& system, const Eigen::VectorXd& impulse,
                        DrillingState& state);

/// Conservative forces and wrench, N and N m; `cone_share` scales the wrench's torques on cones.
void force_column(const DrillingSystem& system, const Wrench& conservative, const Wrench& wrench,
                  double cone_share, Eigen::VectorXd& force);

/// M^-1 p: velocities of momenta, without forming the matrix.
void velocities_of(const DrillingSystem& system, const Configuration& at,
                   const Eigen::Ref<const Eigen::VectorXd>& p, Eigen::Ref<Eigen::VectorXd> u);

}  // namespace tdbd::dynamics
