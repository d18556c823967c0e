#pragma once

#include <complex>

#include "core/types.hpp"

/// The two coefficients of the wall's resistance over a flow, as if it were two dampers: one
/// against slip of the contact point, one along the radius. Each depends on the resulting mean
/// speeds.
namespace tdbd::dynamics {

/// Forces of the wall at a penetration p.
struct WallLaw {
  double friction = 0.0;    ///< Coulomb friction coefficient mu
  double slip_speed = 0.0;  ///< v0 of tanh(s / v0), m/s; 0: Coulomb's law
  double spring = 0.0;      ///< k p (1 + e^2)/2, N
  double loss = 0.0;        ///< H = k p (1 - e^2)/2, N: bound of the loss along the radius
};

/// Coefficients of the wall, N s/m.
struct WallSecants {
  double slip = 0.0;    ///< g_t
  double radial = 0.0;  ///< g_r
};

/// Dependence of the mean speeds of the contact over a flow on the secants:
///   (1 + gain diag(g_t, g_t, g_r)) m = free,   Re m: slip around, slip along z, radial speed.
struct WallResponse {
  Eigen::Matrix3cd gain = Eigen::Matrix3cd::Zero();  ///< m/s per N
  Eigen::Vector3cd free = Eigen::Vector3cd::Zero();  ///< m/s, without resistance of the wall
};

/// Complex speeds m of the contact, m/s. Their real parts are the means over the flow.
Eigen::Vector3cd contact_speeds(const WallResponse& response, const WallSecants& secants);

/// Radial speed below which the loss of the wall acts as a damper, m/s. With Coulomb's law the
/// force on a ring at rest would be undetermined.
inline constexpr double radial_creep = 1e-7;

/// Slip speed v0 that replaces the 0 of Coulomb's law, m/s: a ring that rests on the wall creeps no
/// faster.
inline constexpr double coulomb_creep = 1e-9;

/// Statistics of a search for the secants.
struct SecantSearch {
  int newton_steps = 0;
  bool bracketed = false;  ///< Newton's method failed; nested brackets found the secants
};

/// Finds the secants that are consistent with the resulting speeds:
///   g_t = mu N tanh(s/v0)/s,  N = spring + g_r r,  g_r = H min(1/|r|, 1/creep),
/// where s is the mean slip and r the mean radial speed. Uses Newton's method on (ln g_t, ln g_r)
/// from the speeds `start` at the start of the flow, and nested brackets if it fails. Always
/// terminates; allocates nothing.
WallSecants find_wall_secants(const WallLaw& law, const WallResponse& response, const Vec3& start,
                              SecantSearch* search = nullptr);

}  // namespace tdbd::dynamics
