#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// A bit's mass on a lateral spring in a round hole with an elastic wall: the change of energy by a
/// method of integration in a conservative system. The method of Langeveld and of Hanson and Hansen
/// is the classical Runge-Kutta method (stated in the thesis, 2.1, 2.2); the other is velocity
/// Verlet, which is symplectic.
struct WallLedgerCase {
  double mass = 500.0;               ///< kg
  double spring = 0.0;               ///< N/m, to the hole's axis
  double wall = 1e9;                 ///< N/m
  double clearance = 0.0;            ///< m; 0: the wall is in contact from the start
  double c[2] = {0.0, 0.0};          ///< m, horizontal, from the hole's axis
  double v[2] = {0.1, 0.0};          ///< m/s
  double step = 1e-3, duration = 1;  ///< s
};

/// Energies at the end of each step, J, starting with the initial energy.
struct WallLedger {
  std::vector<double> time, runge_kutta, symplectic;
};

WallLedger wall_ledger(const WallLedgerCase& setup);

/// The factor by which one step of the classical Runge-Kutta method changes the energy of a linear
/// oscillator, with `wh` the frequency times the step: 1 - wh^6/72 + wh^8/576.
double runge_kutta_energy_factor(double wh);

}  // namespace tdbd::reference
