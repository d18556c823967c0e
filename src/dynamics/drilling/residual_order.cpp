#include "dynamics/drilling/residual_order.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/observed_order.hpp"

namespace tdbd::dynamics {
namespace {

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

ResidualOrder residual_order(double h, const Window& window) {
  ResidualOrder found;
  for (int level = 0, parts = 1; level < residual_levels; ++level, parts *= 2) {
    const WindowResiduals w = window(parts);
    const double size = root_mean_square(w.at_instants);
    const double steps = static_cast<double>(w.at_instants.size()) * parts;
    const double rounding = order_rounding_per_step * steps * w.scale;
    found.steps.push_back(h / parts);
    found.residuals.push_back(size);
    if (!(size > rounding) && found.reason.empty())
      found.reason = fmt::format(
          "the residual is at rounding level: {:.3g} J with a step of {:.4g} s and {:.3g} J of "
          "energy "
          "in and out",
          size, h / parts, w.scale);
  }
  if (found.reason.empty()) found.order = least_squares_order(found.steps, found.residuals);
  return found;
}

}  // namespace tdbd::dynamics
