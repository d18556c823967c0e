#pragma once

#include <string>

#include "dynamics/drilling/drilling_system.hpp"

namespace tdbd::dynamics {

/// How steeply the forces of cutting change with the bit's place and velocity, all parts together.
/// Along z between bit and rock.
struct ContactSlopes {
  double lateral_stiffness = 0.0;  ///< N/m, along x and along y
  double axial_stiffness = 0.0;    ///< N/m: dWOB/dz
  double twist_stiffness = 0.0;    ///< N m/rad
  double lateral_damping = 0.0;    ///< N s/m
  double axial_damping = 0.0;      ///< N s/m
  double twist_damping = 0.0;      ///< N m s/rad: a torque that falls from one sign to the other
};

/// What limits the step, dynamics (16). Kicks and drift are stable while h times the highest
/// angular frequency of string, pressed wall and contact stays below 2; the exact dampers do not
/// change that. A law of velocity at the predicted momenta adds: h times its largest rate (slope
/// over mass) below 1.
struct StabilityLimit {
  double frequency = 0.0;  ///< rad/s, the highest; of the worst attitude about z
  double rate = 0.0;       ///< 1/s
  double step = 0.0;       ///< s, the smaller limit; infinite where nothing limits
  std::string mode;        ///< what moves most: "along z", "turning about z", ...
};
StabilityLimit stability_limit(const DrillingSystem& system, const ContactSlopes& contact);

/// Why a step of h (s) is too long, with the limit and a step that would do; empty when it is not.
std::string stability_problem(const DrillingSystem& system, const ContactSlopes& contact, double h);

}  // namespace tdbd::dynamics
