#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tdbd::dynamics {

/// Levels of a window: the step h, h/2 and h/4.
inline constexpr int residual_levels = 3;

/// What one level of a window left unexplained, J, at the ends of its steps of h: all levels at the
/// same instants.
struct WindowResiduals {
  std::vector<double> at_instants;
  double scale = 0.0;  ///< J that were stored, came and went: rounding is counted against it
};

/// The window again, with every step of h divided into so many equal parts.
using Window = std::function<WindowResiduals(int parts)>;

/// Observed order of the energy ledger's residual, dynamics (17), in the time step.
struct ResidualOrder {
  std::optional<double> order;    ///< none: `reason` says why
  std::string reason;             ///< empty where there is an order
  std::vector<double> steps;      ///< s, from the longest
  std::vector<double> residuals;  ///< J, root mean square over the instants
};

/// Runs the window at h (s), h/2 and h/4 and takes the least-squares slope of log residual over log
/// step. Root mean squares over many common instants are taken, since a residual that swings may
/// be small at a single one by chance. No order where a residual is at the level of rounding
/// (order_rounding_per_step a step).
ResidualOrder residual_order(double h, const Window& window);

}  // namespace tdbd::dynamics
