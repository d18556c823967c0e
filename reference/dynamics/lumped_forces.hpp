#pragma once

#include <functional>

#include "dynamics/drilling/drilling_system.hpp"
#include "reference/dynamics/runge_kutta.hpp"

/// Forces on a bit on a string (dynamics (9) to (12)), derived from the energies of the springs.
namespace tdbd::reference {

/// Bit, rock and top in other unknowns than the program's: velocities, and the top's position as an
/// unknown that follows its scheduled speeds. Frames: W space, B bit.
struct LumpedState {
  GyrostatState bit;
  Vec3 c_W = Vec3::Zero(), v_W = Vec3::Zero();  ///< centre of mass, m, m/s
  double rock_z = 0.0, rock_v = 0.0;            ///< m, m/s
  double top_z = 0.0, top_angle = 0.0;          ///< m from the rest; rad
};

/// Energy by destination, J, or power, W.
struct LumpedEnergy {
  double top = 0.0, gravity = 0.0, cut_bit = 0.0, cut_rock = 0.0;
  double damped_string = 0.0, damped_bearings = 0.0, damped_rock = 0.0;
  double wall_loss = 0.0, wall_friction = 0.0;
};

/// The wrench of cutting on the bit in a given state at a given velocity, for a constant cut.
using LumpedLaw =
    std::function<void(const dynamics::DrillingSystem&, const dynamics::DrillingState&,
                       const dynamics::DrillingVelocity&, dynamics::Wrench&)>;

/// All forces at one time, and the power of each.
struct LumpedForces {
  Vec3 force_W = Vec3::Zero(), torque_W = Vec3::Zero();  ///< N; N m about the centre of mass
  std::vector<double> cones;                             ///< N m about their axes
  double rock_force = 0.0;                               ///< N
  LumpedEnergy power;                                    ///< W
};

/// Linear interpolation between the entries, or a step function; constant outside.
double scheduled(const dynamics::Schedule& s, double t);

/// Energy of the string's springs, J: translation at the attachment, swing and twist.
double string_energy(const dynamics::DrillingSystem& system, const LumpedState& s);

/// Computes all forces. Springs by differences of order 8 of string_energy. The wall has its own
/// law: k p while pressing and e^2 k p while unloading.
LumpedForces lumped_forces(const dynamics::DrillingSystem& system, const LumpedLaw& law,
                           const LumpedState& s);

}  // namespace tdbd::reference
