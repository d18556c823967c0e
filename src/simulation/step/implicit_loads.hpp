#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <optional>
#include <vector>

#include "dynamics/drilling/response.hpp"
#include "simulation/step/pressed_contact.hpp"

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

/// How fast a contact moves in a step for a force on it, m/(N s): along its normal, and at most.
struct Yield {
  double normal = 0.0, along = 0.0;
};

/// Room for it, kept from step to step: no allocation once warm.
struct ImplicitWork {
  std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> jacobians;  ///< of the cuts' points by u
  std::vector<PartDrag> drags;
  std::vector<std::optional<PressedContact>> pressed;  ///< per cut, if its surface presses
  std::vector<Yield> yields_of;                        ///< of these
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

/// Whether a pressing surface made this cut, and with which force at most.
std::optional<forces::Pressing> pressing_of(const ForcePlan& plan, const CutOfPart& cut);

/// Velocities of the cuts' points are J u. Also L, from Cholesky's factorisation of the symmetric part
/// of A. That part is not negative, since all that acts in a step loses energy. It is singular where
/// a damper or the wall stops a motion within the step; then L is diagonal and L L^T bounds it.
void prepare(const ResistedMotion& m, ImplicitWork& work);

/// Whether one of the cuts is of a pressing surface.
bool any_presses(const ImplicitWork& work);

/// How steep the laws of the velocity are at u, compared with the compliance of the step: the
/// largest singular value of L^T C L, C the secants' sum. An explicit impulse overshoots beyond 1.
double steepness(const ResistedMotion& m, const Eigen::VectorXd& u, ImplicitWork& work);

/// Finds the velocity to which the forces of the laws at that velocity lead, simulation (8) and (13):
/// u = free + A f(u), from `work.u`, to 1e-9 of `free` in the metric of A. Two rounds use the secants
/// of laws of the velocity, then Newton's method uses the slopes; a Newton step that comes no nearer
/// is shortened. Around these rounds the estimates of the pressing surfaces are updated until they
/// repeat themselves, with penalties that increase tenfold. Where friction weakens, or where that
/// fails, the slip is held and updated outside of these rounds. The last round is a solution at the
/// secants of what was found, so that the forces -C u take energy even if the search did not settle.
Search find_resisted_velocity(const ResistedMotion& m, ImplicitWork& work);

/// The forces -C_i v_i at the velocities work.u, by part and summed.
void take_loads(const ResistedMotion& m, const ImplicitWork& work, BitLoads& loads);

}  // namespace tdbd::simulation
