#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/drilling/configuration.hpp"

namespace tdbd::dynamics {

/// Stored energy at one instant, J.
struct StoredEnergy {
  double translation = 0.0;  ///< M |c'|^2 / 2
  double rotation = 0.0;     ///< W . It W / 2
  double cones = 0.0;        ///< sum_k pi_k^2 / (2 Ic_k): the cones about their axes, in space
  double rock = 0.0;         ///< kinetic
  double string = 0.0;       ///< elastic
  double wall = 0.0;
  double rock_mount = 0.0;
  double chain = 0.0;  ///< of a chained string, without the springs at the bit
};
StoredEnergy stored_energy(const DrillingSystem& system, const Configuration& at,
                           const DrillingState& state);
double total(const StoredEnergy& e);

/// Work and losses since the start, J. The losses of dampers and friction are the exact change of
/// kinetic energy, and so is the work of the cutting wrench: impulse times the mean of the
/// velocities before and after. The work of the top is its mean force times its displacement.
struct EnergyLedger {
  double start = 0.0;     ///< stored at the start
  double top = 0.0;       ///< work of the top on the string
  double gravity = 0.0;   ///< work of gravity
  double cut_bit = 0.0;   ///< work of the cutting wrench on the bit: negative while it drills
  double cut_rock = 0.0;  ///< work of the cutting wrench on the moving rock
  double damped_string = 0.0;
  double damped_bearings = 0.0;
  double damped_rock = 0.0;
  double wall_loss = 0.0;      ///< loss of the inelastic wall
  double wall_friction = 0.0;  ///< loss by friction along the wall
  // For a chained string (string::ChainLedger).
  double chain_gravity = 0.0;   ///< work of gravity on the chain
  double chain_friction = 0.0;  ///< loss by friction in the hole
  double chain_damping = 0.0;   ///< loss in the mud
  double chain_loss = 0.0;      ///< loss in the Kelvin-Voigt dampers
  double top_damping = 0.0;     ///< loss in the damper of a top drive

  template <class Archive>
  void serialize(Archive& a) {
    a(start, top, gravity, cut_bit, cut_rock, damped_string, damped_bearings, damped_rock,
      wall_loss, wall_friction, chain_gravity, chain_friction, chain_damping, chain_loss,
      top_damping);
  }
};

/// Sum of all losses, J.
double lost(const EnergyLedger& ledger);

/// Energy stored now plus losses, minus energy stored at the start and work done on the system, J:
/// dynamics (17). It would be zero if the step were exact. It results from the time integration of
/// springs, a moving top and rotation, is of second order and bounded.
double residual(const StoredEnergy& now, const EnergyLedger& ledger);

/// Sum of the magnitudes of the initial energy and of the work of the top, gravity and cutting, J.
/// It is the scale for rounding errors of the ledger.
double throughput(const EnergyLedger& ledger);

/// Number of refinement levels: steps of h, h/2 and h/4.
inline constexpr int residual_levels = 3;

/// Residuals of one refinement level of a window, J, at the ends of its steps of h. All levels use
/// the same instants.
struct WindowResiduals {
  std::vector<double> at_instants;
  double scale = 0.0;  ///< J, throughput of energy: the scale of rounding
};

/// Recomputes the window with every step of h divided into `parts` equal steps.
using Window = std::function<WindowResiduals(int parts)>;

/// Observed order of the residual of the energy ledger, dynamics (17), in the time step.
struct ResidualOrder {
  std::optional<double> order;    ///< empty: see `reason`
  std::string reason;             ///< why there is no order; empty if there is one
  std::vector<double> steps;      ///< s, longest first
  std::vector<double> residuals;  ///< J, root mean square over the instants

  template <class Archive>
  void serialize(Archive& a) {
    a(order, reason, steps, residuals);
  }
};

/// Runs the window at h (s), h/2 and h/4 and fits the least-squares slope of log residual over log
/// step. It uses root mean squares over many common instants, because an oscillating residual may
/// be small at a single one by chance. There is no order if a residual is at rounding level
/// (order_rounding_per_step per step).
ResidualOrder residual_order(double h, const Window& window);

}  // namespace tdbd::dynamics
