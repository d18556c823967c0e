#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <vector>

#include "dynamics/drilling/response.hpp"
#include "simulation/step/part_drag.hpp"

namespace tdbd::simulation {

/// The contacts of a step as they resist the motion u of bit, cones and rock (dynamics (18)):
/// what the impulse of the step is a function of.
struct ResistedMotion {
  const ForcePlan& plan;
  const bit::Bit& bit;
  const Pose& X_WB;  ///< over the rock, at the step's end
  Vec3 centre_W;     ///< m, of mass, over the rock
  double dt;         ///< s
  const std::vector<CutOfPart>& cuts;
  const dynamics::Response& response;
};

/// How the search for a velocity went.
struct Search {
  int rounds = 0;
  bool is_settled = true;
};

/// Room for it, kept from step to step: no allocation once warm.
struct ImplicitWork {
  std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> jacobians;  ///< of the cuts' points by u
  std::vector<PartDrag> drags;
  Eigen::VectorXd f;     ///< N, N m: sum of J^T F
  Eigen::MatrixXd C;     ///< sum of J^T C J
  Eigen::MatrixXd root;  ///< L, L L^T the symmetric part of A
  Eigen::VectorXd u, next, trial, rest;
  Eigen::Matrix<double, 3, Eigen::Dynamic> resisted;
  Eigen::MatrixXd matrix, product, steep, across, coupled;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu, cone_lu;
  Eigen::LLT<Eigen::MatrixXd> cholesky;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
};

/// Velocities of the cuts' points are J u. Also L: the symmetric part of A is positive, since all that
/// acts in a step loses energy; if it were not, steepness would be NaN and the step explicit.
void prepare(const ResistedMotion& m, ImplicitWork& work);

/// How steep the laws are at u beside what the step gives way: the largest singular value of
/// L^T C L, C the secants' sum; cones, which are light and follow, are eliminated. An explicit
/// impulse overshoots beyond 1.
double steepness(const ResistedMotion& m, const Eigen::VectorXd& u, ImplicitWork& work);

/// The velocity that the laws' own forces at it lead to, simulation (8): (I + A C(u)) u = free, from
/// `work.u`, to 1e-9 of `free` in the metric of A. Two rounds at the secants, then Newton's at the
/// slopes, shortened where they do not come nearer. The last is a solution at the secants of what
/// was found, so that the forces -C u take energy even if the search did not settle.
Search find_resisted_velocity(const ResistedMotion& m, ImplicitWork& work);

/// The forces -C_i v_i at the velocities work.u, by part and summed.
void take_loads(const ResistedMotion& m, const ImplicitWork& work, BitLoads& loads);

}  // namespace tdbd::simulation
