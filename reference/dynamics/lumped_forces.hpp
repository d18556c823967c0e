#pragma once

#include <functional>

#include "dynamics/drilling/drilling_system.hpp"
#include "reference/dynamics/runge_kutta.hpp"

/// What acts on a bit on a string (dynamics (9) to (12)), written from the energies of the springs.
namespace tdbd::reference {

/// Bit, rock and top in other unknowns than the program's: velocities, and the top's place as an
/// unknown that follows its scheduled speeds. Frames: W space, B bit.
struct LumpedState {
  GyrostatState bit;
  Vec3 c_W = Vec3::Zero(), v_W = Vec3::Zero();  ///< centre of mass, m, m/s
  double rock_z = 0.0, rock_v = 0.0;            ///< m, m/s
  double top_z = 0.0, top_angle = 0.0;          ///< m from the rest; rad
};

/// Where energy went, J (or what it does now, W).
struct LumpedEnergy {
  double top = 0.0, gravity = 0.0, cut_bit = 0.0, cut_rock = 0.0;
  double damped_string = 0.0, damped_bearings = 0.0, damped_rock = 0.0;
  double wall_loss = 0.0, wall_friction = 0.0;
};

/// What cutting does to the bit in a state at a velocity, on a cut that stays what it is.
using LumpedLaw =
    std::function<void(const dynamics::DrillingSystem&, const dynamics::DrillingState&,
                       const dynamics::DrillingVelocity&, dynamics::Wrench&)>;

/// Forces of everything at one instant, and the power of each.
struct LumpedForces {
  Vec3 force_W = Vec3::Zero(), torque_W = Vec3::Zero();  ///< N; N m about the centre of mass
  std::vector<double> cones;                             ///< N m about their axes
  double rock_force = 0.0;                               ///< N
  LumpedEnergy power;                                    ///< W
};

/// Linear between the entries, or a staircase; held outside.
double scheduled(const dynamics::Schedule& s, double t);

/// Energy of the string's springs, J: translation at the attachment, swing and twist.
double string_energy(const dynamics::DrillingSystem& system, const LumpedState& s);

/// Everything that acts. Springs by differences of order 8 of string_energy; the wall with its own
/// law, k p while pressing and e^2 k p while letting go.
LumpedForces lumped_forces(const dynamics::DrillingSystem& system, const LumpedLaw& law,
                           const LumpedState& s);

}  // namespace tdbd::reference
