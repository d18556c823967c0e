#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tdbd::dynamics {

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
