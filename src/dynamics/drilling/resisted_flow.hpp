#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <vector>

#include "dynamics/drilling/configuration.hpp"
#include "dynamics/drilling/energy_ledger.hpp"

namespace tdbd::dynamics {

/// Functions of z = c time that appear in the solution of u' = f - c u over a time (dynamics (20)).
struct FlowFunctions {
  double decay = 1.0;      ///< exp(-z)
  double mean = 1.0;       ///< (1 - exp(-z))/z: mean of the decay over the time
  double second = 0.5;     ///< (1 - mean)/z
  double third = 1.0 / 6;  ///< (1/2 - second)/z
};

inline FlowFunctions flow_functions(double z) {
  FlowFunctions f;
  if (std::abs(z) > 1.0) {
    f.decay = std::exp(-z);
    f.mean = -std::expm1(-z) / z;
    f.second = (1.0 - f.mean) / z;
    f.third = (0.5 - f.second) / z;
    return f;
  }
  constexpr int terms = 18;  // of the series of `third`, sum of (-z)^j / (j + 3)!
  f.third = 1.0;
  for (int j = terms; j > 0; --j) f.third = 1.0 - z / (j + 3) * f.third;
  f.third /= 6.0;
  f.second = 0.5 - z * f.third;
  f.mean = 1.0 - z * f.second;
  f.decay = 1.0 - z * f.mean;
  return f;
}

/// Mean of f over [0, 1] by the five-point Gauss rule.
template <class F>
double gauss_mean(const F& f) {
  constexpr std::array<double, 2> off{0.269234655052841545, 0.453089922969331996};
  constexpr std::array<double, 2> weight{0.239314335249683234, 0.118463442528094544};
  double sum = 64.0 / 225.0 * f(0.5);
  for (std::size_t i = 0; i < off.size(); ++i)
    sum += weight[i] * (f(0.5 - off[i]) + f(0.5 + off[i]));
  return sum;
}

// Flow of all forces and resistances together, at fixed positions:
//   M u' = F - C(ubar) u,   C = sum_i c_i a_i a_i^T,   ubar: mean of u over the time      (19)
// a_i are the directions of the dampers and, if the ring rubs on the wall, of its slip around and
// along the wall and of its radius; the coefficients of the wall are the secants of
// wall_secants.hpp. All computations use components along these directions, in the relative speeds
// v = A^T u - (speed of the top).

/// A direction of the bit in which a resistance acts: the force and the torque per unit of impulse.
struct Direction {
  Vec3 force_W = Vec3::Zero();
  Vec3 torque_W = Vec3::Zero();  ///< about the centre of mass
};

/// Work data of flows, reused so that later flows allocate nothing.
struct FlowWork {
  Eigen::VectorXd force;           ///< F, N and N m: input
  Eigen::VectorXd mean;            ///< ubar, m/s and rad/s: output
  Eigen::VectorXd momenta, start;  ///< p, and M^-1 p at the start
  Eigen::VectorXd pushed;          ///< M^-1 F
  Eigen::VectorXd change;          ///< of the momenta
  Eigen::MatrixXd directions;      ///< A, one direction per column: dampers first, the wall last
  Eigen::MatrixXd mobile;          ///< M^-1 A
  Eigen::MatrixXd mobility;        ///< A^T M^-1 A
  Eigen::VectorXd coefficients;    ///< c, N s/m and N m s/rad
  Eigen::VectorXd end_speeds;      ///< speeds of the other ends of the dampers, m/s and rad/s
  std::vector<double EnergyLedger::*> entries;  ///< ledger entry for the loss in each direction
  int dampers = 0;                              ///< number of dampers; they are the first columns
  int resisting = 0;                            ///< number of dampers, plus three if the wall rubs

  Eigen::VectorXd speeds, pushes;  ///< A^T M^-1 p - end_speeds, A^T M^-1 F
  Eigen::VectorXd impulses;        ///< j = -c (integral of v)
  Eigen::VectorXd lags;            ///< l: ubar = u + M^-1 (F time + A j - A l)/2
  Eigen::VectorXd losses;          ///< J, integral of c v^2

  // For the exponential.
  Eigen::VectorXd scales;  ///< square roots of the coefficients
  Eigen::MatrixXd scaled, products;
  Eigen::MatrixXd decomposed;  ///< the matrix `scaled` whose eigenvectors `modes` contains
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes;
  Eigen::VectorXd mode_start, mode_push, mode_end, mode_mean, mode_lag;
  // For the Lobatto method.
  Eigen::MatrixXcd damped, answers;
  Eigen::PartialPivLU<Eigen::MatrixXcd> solver;
  Eigen::VectorXcd stages;
};

/// The directions in which a wall resists: slip around it, slip along z, radius of the ring.
std::array<Direction, 3> contact_directions(const WallContact& contact);

/// Whether the wall has friction or loss.
bool wall_resists(const Wall& wall);

/// Relaxes the rate of a loaded top that follows the bit (TopDrive::following_time) towards the
/// velocity of the attachment over `time` (s), dynamics (12a). Exact if that velocity is constant.
/// No effect on other tops.
void follow_bit(const DrillingSystem& system, const Configuration& at, double time,
                DrillingState& state);

/// Advances the momenta of `state` by the flow (19) over `time` (s) under `work.force`. Writes the
/// mean velocity to `work.mean`. Writes losses and the work of the top on dampers to `ledger`,
/// which is null for a trial.
///
/// If the ring does not rub, the flow is the exponential. Otherwise it is the Lobatto IIIC method,
/// whose stability function 1/(1 + z + z^2/2) also decays for strong damping. A velocity with F =
/// C(u) u does not change. The change of kinetic energy equals the work of F and of the top minus
/// the losses, up to rounding. Losses at the wall are never negative.
void resisted_flow(const DrillingSystem& system, const Configuration& at, double time,
                   DrillingState& state, EnergyLedger* ledger, FlowWork& work);

}  // namespace tdbd::dynamics
