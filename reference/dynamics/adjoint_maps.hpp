#pragma once

#include "reference/dynamics/runge_kutta.hpp"

namespace tdbd::reference {

/// The two maps of first order whose composition the thesis's integrator is: "a composition of
/// adjoint first order integrators" (abstract; which two is reconstructed from 5.4.4). Each takes a
/// step of h (s, of either sign) with the whole impulse h T at one of its ends and coasts over h by
/// the thesis's drift, dynamics (5), which is solved by repetition here. One undoes the other taken
/// backward, which is what adjoint means: last(h) first(-h) = identity, and
///   last(h/2) first(h/2) = kick(h/2) drift(h/2) drift(h/2) kick(h/2), dynamics (4).
/// For torques that do not depend on velocity. Throws std::runtime_error where the repetition does
/// not settle.
GyrostatState impulse_first(const dynamics::Gyrostat& g, const dynamics::Loads& loads, double h,
                            const GyrostatState& s);
GyrostatState impulse_last(const dynamics::Gyrostat& g, const dynamics::Loads& loads, double h,
                           const GyrostatState& s);

}  // namespace tdbd::reference
