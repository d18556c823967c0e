#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <optional>
#include <vector>

#include "dynamics/drilling/stability.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::simulation {

/// The contacts of a step as a function of the motion u of bit, cones and rock (dynamics (18)): the
/// inputs of the implicit impulse of the step.
struct ResistedMotion {
  const ForcePlan& plan;
  const bit::Bit& bit;
  const Pose& X_WB;  ///< relative to the rock, at the end of the step
  Vec3 centre_W;     ///< m, centre of mass, relative to the rock
  double dt;         ///< s
  const std::vector<CutOfPart>& cuts;
  const dynamics::Response& response;
};

/// Statistics of the search for a velocity.
struct Search {
  int rounds = 0;
  bool has_converged = true;
};

/// Change of velocity of a contact in a step per unit of force on it, m/(N s): along its normal,
/// and the largest in any direction.
struct ContactCompliance {
  double normal = 0.0, along = 0.0;
};

/// Work data, reused so that later steps allocate nothing.
struct ImplicitWork {
  std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> jacobians;  ///< of the cuts' points with
                                                                    ///< respect to u
  std::vector<PartDrag> drags;
  std::vector<std::optional<PressedContact>> pressed;  ///< per cut, if its surface presses
  std::vector<ContactCompliance> compliances;          ///< of the pressing cuts
  Eigen::VectorXd f;                                   ///< N, N m: sum of J^T F
  Eigen::MatrixXd C;                                   ///< sum of J^T C J
  Eigen::MatrixXd root;                                ///< L: the metric of A is L L^T (prepare)
  Eigen::VectorXd u, next, trial, nearest, rest;
  Eigen::Matrix<double, 3, Eigen::Dynamic> resisted, yields;
  Eigen::MatrixXd matrix, product, steep;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
  Eigen::LLT<Eigen::MatrixXd> cholesky;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
};

/// The pressing law of this cut; nothing if its surface does not press.
std::optional<forces::Pressing> pressing_of(const ForcePlan& plan, const CutOfPart& cut);

/// Prepares the search. Computes the Jacobians J (velocities of the cuts' points are J u) and L,
/// the Cholesky factor of the symmetric part of A. That part is positive semidefinite, since
/// everything that acts in a step dissipates energy. It is singular if a damper or the wall stops a
/// motion within the step; then L is diagonal and L L^T is a bound.
void prepare(const ResistedMotion& m, ImplicitWork& work);

/// Whether any of the cuts is made by a pressing surface.
bool any_presses(const ImplicitWork& work);

/// Steepness of the laws of velocity at u relative to the compliance of the step: the largest
/// singular value of L^T C L, where C is the sum of the secants. If it exceeds 1, an explicit
/// impulse overshoots.
double steepness(const ResistedMotion& m, const Eigen::VectorXd& u, ImplicitWork& work);

/// Solves for the velocity that is consistent with the forces at that velocity, simulation (8) and
/// (13): u = free + A f(u), starting from `work.u`, to 1e-9 of `free` in the metric of A. Two
/// rounds use the secants of the laws of velocity, later rounds Newton's method with their slopes;
/// a Newton step that does not decrease the residual is shortened. In an outer loop the estimates
/// of the pressing surfaces are updated until they converge, with penalties that increase tenfold.
/// If friction weakens with speed, or if this loop fails, the slip is fixed and updated in a
/// further outer loop. The last round is a solution with the secants found, so that the forces -C u
/// dissipate energy even if the search did not converge.
Search find_resisted_velocity(const ResistedMotion& m, ImplicitWork& work);

/// The forces -C_i v_i at the velocities work.u, for each part and in total.
void take_loads(const ResistedMotion& m, const ImplicitWork& work, BitLoads& loads);

}  // namespace tdbd::simulation
