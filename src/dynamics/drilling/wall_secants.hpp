#pragma once

#include <complex>

#include "core/types.hpp"

/// The two coefficients with which a wall resists over a flow, as if it were two dampers: one
/// against the slip of the touching point, one along the radius. Each depends on the mean speeds
/// that it leads to.
namespace tdbd::dynamics {

/// Forces of the wall at a depth p.
struct WallLaw {
  double friction = 0.0;    ///< Coulomb's coefficient mu
  double slip_speed = 0.0;  ///< v0 of tanh(s / v0), m/s; 0: Coulomb's own law
  double spring = 0.0;      ///< k p (1 + e^2)/2, N
  double loss = 0.0;        ///< H = k p (1 - e^2)/2, N: the wall's bound along the radius
};

/// Coefficients of the wall, N s/m.
struct WallSecants {
  double slip = 0.0;    ///< g_t
  double radial = 0.0;  ///< g_r
};

/// How the mean speeds of the contact over a flow depend on the secants:
///   (1 + gain diag(g_t, g_t, g_r)) m = free,   Re m: slip around, slip along z, radial speed.
struct WallResponse {
  Eigen::Matrix3cd gain = Eigen::Matrix3cd::Zero();  ///< m/s for a N
  Eigen::Vector3cd free = Eigen::Vector3cd::Zero();  ///< m/s, without the wall's resistance
};

/// Complex speeds m of the contact; their real parts are the means over the flow, m/s.
Eigen::Vector3cd contact_speeds(const WallResponse& response, const WallSecants& secants);

/// Speed below which the wall's loss along the radius acts as a damper, m/s. Coulomb's law would
/// leave the force of a ring at rest undetermined.
inline constexpr double radial_creep = 1e-7;

/// The slip speed of Coulomb's own law, m/s: a ring that rests on the wall creeps no faster.
inline constexpr double coulomb_creep = 1e-9;

/// How a search for the secants went.
struct SecantSearch {
  int newton_steps = 0;
  bool bracketed = false;  ///< Newton's method failed; nested brackets found the secants
};

/// The secants that agree with the speeds they lead to:
///   g_t = mu N tanh(s/v0)/s,  N = spring + g_r r,  g_r = H min(1/|r|, 1/creep),
/// s the mean slip, r the mean radial speed. Newton's method on (ln g_t, ln g_r) from the speeds
/// `start` at the flow's beginning; nested brackets where it fails. Always ends; no allocation.
WallSecants find_wall_secants(const WallLaw& law, const WallResponse& response, const Vec3& start,
                              SecantSearch* search = nullptr);

}  // namespace tdbd::dynamics
