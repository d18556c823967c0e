#include "reference/dynamics/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// With more steps, rk4 would run for minutes.
constexpr double most_fixed_steps = 1e7;

RungeKuttaRun fixed_steps(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                          const GyrostatState& start, double t_end, double steps) {
  if (!(steps >= 1.0 && steps <= most_fixed_steps && steps == std::floor(steps)))
    throw InputError(fmt::format("rk4: found {} steps, expected a whole number from 1 to {}", steps,
                                 most_fixed_steps));
  std::vector<double> y = unknowns(start, loads);
  const long evaluations =
      integrate_rk4(gyrostat_equations(g, loads), static_cast<int>(steps), start.time, t_end, y);
  return {state_of(y, g.cones.size(), t_end), evaluations};
}

RungeKuttaRun run(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                  const GyrostatState& start, double t_end, ComparisonMethod rival,
                  double accuracy) {
  if (rival == ComparisonMethod::rk4) return fixed_steps(g, loads, start, t_end, accuracy);
  if (!(accuracy > 0.0))
    throw InputError(fmt::format("found a tolerance of {}, expected a positive one", accuracy));
  const OdeMethod method = rival == ComparisonMethod::rk8pd ? OdeMethod::rk8pd : OdeMethod::rkf45;
  return runge_kutta(g, loads, start, t_end, method, {accuracy, accuracy});
}

}  // namespace

double angle_between(const Mat3& A, const Mat3& B) {
  const double chord = (A - B).norm() / (2.0 * std::sqrt(2.0));  // sin(angle / 2)
  return 2.0 * std::asin(std::min(1.0, chord));
}

std::vector<WorkPrecision> work_precision(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                                          const GyrostatState& start, double t_end,
                                          ComparisonMethod rival,
                                          const std::vector<double>& accuracies) {
  if (!loads.samples.empty())
    throw InputError("found torque samples, expected loads without corners");
  const Mat3 exact_WB = runge_kutta(g, loads, start, t_end).state.R_WB;
  std::vector<WorkPrecision> points;
  for (const double accuracy : accuracies) {
    const RungeKuttaRun r = run(g, loads, start, t_end, rival, accuracy);
    points.push_back({accuracy, r.evaluations, angle_between(r.state.R_WB, exact_WB), r.state});
  }
  return points;
}

}  // namespace tdbd::reference
