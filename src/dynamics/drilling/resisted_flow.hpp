#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <vector>

#include "dynamics/drilling/configuration.hpp"
#include "dynamics/drilling/energy_ledger.hpp"

/// All forces and all that resists motion, together, at positions that stand still:
///   M u' = F - C(ubar) u,   C = sum_i c_i a_i a_i^T,   ubar: mean of u over the time            (19)
/// a_i are the directions of the dampers and, where the ring rubs on the wall, of its slip around
/// and along the wall and of its radius, with the secants of wall_secants.hpp as coefficients.
/// Everything is computed along the directions, in the relative speeds v = A^T u - (top's speed).
namespace tdbd::dynamics {

/// A direction of the bit in which something resists: the force and the torque that act for a unit of
/// impulse.
struct Direction {
  Vec3 force_W = Vec3::Zero();
  Vec3 torque_W = Vec3::Zero();  ///< about the centre of mass
};

/// What is kept from flow to flow, so that nothing is allocated once warm.
struct FlowWork {
  Eigen::VectorXd force;           ///< F, N and N m: input
  Eigen::VectorXd mean;            ///< ubar, m/s and rad/s: output
  Eigen::VectorXd momenta, start;  ///< p, and M^-1 p at the start
  Eigen::VectorXd pushed;          ///< M^-1 F
  Eigen::VectorXd change;          ///< of the momenta
  Eigen::MatrixXd directions;      ///< A, a direction a column: dampers first, the wall last
  Eigen::MatrixXd mobile;          ///< M^-1 A
  Eigen::MatrixXd mobility;        ///< A^T M^-1 A
  Eigen::VectorXd coefficients;    ///< c, N s/m and N m s/rad
  Eigen::VectorXd end_speeds;      ///< of the dampers' other ends, m/s and rad/s
  std::vector<double EnergyLedger::*> entries;  ///< where each direction's loss is recorded
  int dampers = 0;                              ///< the first columns
  int resisting = 0;                            ///< dampers, and three of the wall where it rubs

  Eigen::VectorXd speeds, pushes;  ///< A^T M^-1 p - end_speeds, A^T M^-1 F
  Eigen::VectorXd impulses;        ///< j = -c (integral of v)
  Eigen::VectorXd lags;            ///< l: ubar = u + M^-1 (F time + A j - A l)/2
  Eigen::VectorXd losses;          ///< J, integral of c v^2

  // Of the exponential.
  Eigen::VectorXd scales;  ///< square roots of the coefficients
  Eigen::MatrixXd scaled, products;
  Eigen::MatrixXd decomposed;  ///< the matrix `scaled` of which `modes` has the eigenvectors
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes;
  Eigen::VectorXd mode_start, mode_push, mode_end, mode_mean, mode_lag;
  // Of the Lobatto method.
  Eigen::MatrixXcd damped, answers;
  Eigen::PartialPivLU<Eigen::MatrixXcd> solver;
  Eigen::VectorXcd stages;
};

/// The directions in which a wall resists: slip around it, slip along z, the ring's radius.
std::array<Direction, 3> contact_directions(const WallContact& contact);

/// Whether anything at the wall resists the motion of a ring that touches it.
bool wall_resists(const Wall& wall);

/// Relaxes the rate of a loaded top that follows the bit (TopDrive::following_time) towards the
/// attachment's velocity over `time` (s), exactly while that stands still, dynamics (12a). Without
/// effect on other tops.
void follow_bit(const DrillingSystem& system, const Configuration& at, double time,
                DrillingState& state);

/// Advances the momenta of `state` by the flow (19) over `time` (s) under `work.force`. Writes the
/// mean velocity to `work.mean`, and losses and the top's work on dampers to
/// the ledger; a trial has none (null).
///
/// Where the ring does not rub, the flow is the exponential. Where it does, it is the Lobatto IIIC
/// method, whose stability function 1/(1 + z + z^2/2) is that of a strongly damped exponential too:
/// a velocity with F = C(u) u stays. Kinetic energy changes by the work of F and of the top less
/// the losses, to rounding. No loss at the wall is negative.
void resisted_flow(const DrillingSystem& system, const Configuration& at, double time,
                   DrillingState& state, EnergyLedger* ledger, FlowWork& work);

}  // namespace tdbd::dynamics
