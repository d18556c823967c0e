#pragma once

#include "reference/dynamics/runge_kutta.hpp"

namespace tdbd::reference {

/// The two first-order maps whose composition is the thesis's integrator: "a composition of adjoint
/// first order integrators" (abstract; the choice of the two is reconstructed from 5.4.4). Each
/// makes a step of h (s, of either sign): it applies the whole impulse h T at one end and coasts
/// over h by the thesis's drift, dynamics (5), which is solved here by fixed-point iteration. Each
/// map undoes the other one with the opposite step, which is the meaning of adjoint: last(h)
/// first(-h) = identity, and
///   last(h/2) first(h/2) = kick(h/2) drift(h/2) drift(h/2) kick(h/2), dynamics (4).
/// For torques that do not depend on velocity. Throws std::runtime_error if the iteration does not
/// converge.
GyrostatState impulse_first(const dynamics::Gyrostat& g, const dynamics::Loads& loads, double h,
                            const GyrostatState& s);
GyrostatState impulse_last(const dynamics::Gyrostat& g, const dynamics::Loads& loads, double h,
                           const GyrostatState& s);

}  // namespace tdbd::reference
