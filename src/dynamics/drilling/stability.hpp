#pragma once

#include <string>

#include "dynamics/drilling/drilling_step.hpp"
#include "dynamics/drilling/drilling_system.hpp"

namespace tdbd::dynamics {

/// Derivatives of the cutting forces with respect to the position and velocity of the bit, summed
/// over all parts. The axial ones act between bit and rock along z.
struct ContactSlopes {
  double lateral_stiffness = 0.0;  ///< N/m, along x and along y
  double axial_stiffness = 0.0;    ///< N/m: dWOB/dz
  double twist_stiffness = 0.0;    ///< N m/rad
  double lateral_damping = 0.0;    ///< N s/m
  double axial_damping = 0.0;      ///< N s/m
  double twist_damping = 0.0;      ///< N m s/rad: slope of a torque that changes sign with velocity
};

/// Limit of the time step, dynamics (16). Kicks and drift are stable if h times the highest angular
/// frequency of string, wall in contact and rock contact is below 2. The exact dampers do not
/// change that. If a law depends on velocity, evaluated at the predicted momenta, h times its
/// largest rate (slope over mass) must also be below 1.
struct StabilityLimit {
  double frequency = 0.0;  ///< rad/s, the highest over all attitudes about z
  double rate = 0.0;       ///< 1/s
  double step = 0.0;       ///< s, the smaller limit; infinite if there is none
  std::string mode;        ///< dominant motion: "along z", "turning about z", ...
};
StabilityLimit stability_limit(const DrillingSystem& system, const ContactSlopes& contact);

/// Why a step of h (s) is too long, with the limit and a suitable step; empty if it is not.
std::string stability_problem(const DrillingSystem& system, const ContactSlopes& contact, double h);

/// Bounds beyond which the results of a run are meaningless.
struct DivergenceBounds {
  double speed = 100.0;           ///< m/s, of bit and rock
  double angular_speed = 1e4;     ///< rad/s, of bit and cones
  double energy_residual = 10.0;  ///< relative to the throughput of the energy ledger
  double least_energy = 1.0;      ///< J, added to the bound, for a bit at rest
};

/// Checks a closed step for divergence. Returns the diverged quantity with its value and the time,
/// or an empty string. Speeds are means over the closing kick. Quantities that are not finite are
/// reported first, and the wrench before the state, because it is the cause.
std::string divergence(const DrillingSystem& system, const Drilling& d, const DrillingWork& work,
                       const DivergenceBounds& bounds = {});

}  // namespace tdbd::dynamics
