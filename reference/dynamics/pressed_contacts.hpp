#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// A surface that presses on rock in a time step: rigid-plastic crushing and Coulomb friction.
struct PressedSurface {
  Eigen::Matrix<double, 3, Eigen::Dynamic> J;  ///< velocity of its point as a function of u
  Vec3 normal = Vec3::Zero();                  ///< unit, into the rock
  double limit = 0.0;                          ///< N, normal force of full crushing
  double ramp = 0.0;                           ///< 1, v_n/|v_t| of full crushing; 0: rigid
  double free_speed = 0.0;                     ///< m/s, v_n at which it reaches the rock
  double mu = 0.0;                             ///< 1, friction
};

/// Finds u = free + A sum J^T F, F = -p n - t, by projecting p and t of one surface after another
/// (projected Gauss-Seidel after Moreau and Jean) until no force changes by more than 1e-13 of the
/// largest limit. Slow twin of simulation::find_resisted_velocity. `free`: velocities without
/// contact; A: their change per force. Throws RunError after a million iterations.
Eigen::VectorXd pressed_velocity(const Eigen::VectorXd& free, const Eigen::MatrixXd& A,
                                 const std::vector<PressedSurface>& surfaces);

}  // namespace tdbd::reference
