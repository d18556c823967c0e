#include "dynamics/rotation/step.hpp"

#include <fmt/format.h>

namespace tdbd::dynamics {
namespace {

bool solves(Drift drift) { return drift == Drift::lie_midpoint || drift == Drift::lie_mean; }

std::string drift_name(Drift drift) {
  return drift == Drift::lie_midpoint ? "lie-midpoint" : "lie-mean";
}

}  // namespace

std::string too_long_message(const Gyrostat& g, const Loads& loads, const Integrator& integrator,
                             double h, const Rotating& r) {
  constexpr int halvings = 60;
  std::string would = "no shorter step that converges was found";
  double shorter = h;
  for (int i = 0; i < halvings; ++i) {
    shorter *= 0.5;
    Rotating trial = r;
    if (try_step(g, loads, integrator, shorter, trial) == LieOutcome::too_long) continue;
    would = fmt::format("a step of {:.6g} s converges", shorter);
    break;
  }
  return fmt::format(
      "the {} drift does not converge at t = {:.9g} s with a step of {:.6g} s (|W| h = {:.3g} "
      "rad); "
      "{}",
      drift_name(integrator.drift), r.state.time, h,
      std::abs(h) * angular_velocity(g, r.state).norm(), would);
}

template <>
void step<double>(const Gyrostat& g, const Loads& loads, const Integrator& integrator, double h,
                  Rotating& r) {
  if (!solves(integrator.drift)) {
    try_step(g, loads, integrator, h, r);
    return;
  }
  r.step_start = r.state;
  r.step_torque = r.torque;
  if (try_step(g, loads, integrator, h, r) == LieOutcome::solved) return;
  r.state = r.step_start;
  r.torque = r.step_torque;
  throw RunError(too_long_message(g, loads, integrator, h, r));
}

}  // namespace tdbd::dynamics
