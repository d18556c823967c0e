#include "reference/dynamics/ode.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "core/error.hpp"
#include "reference/dynamics/quiet_gsl.hpp"

namespace tdbd::reference {
namespace {

constexpr double first_step = 1e-3, smallest_step = 1e-14;  // relative to the whole time
constexpr int most_steps = 200'000;

const gsl_odeiv2_step_type* step_type(OdeMethod method) {
  return method == OdeMethod::rk8pd ? gsl_odeiv2_step_rk8pd : gsl_odeiv2_step_rkf45;
}

/// The context that GSL passes to evaluate(): the equations, and the time at the start of the step.
struct Context {
  const RightHandSide& f;
  std::size_t size;
  double step_start = 0.0;
  long evaluations = 0;
};

int evaluate(double since_start, const double* y, double* dydt, void* context) {
  auto& c = *static_cast<Context*>(context);
  c.f(c.step_start + since_start, {y, c.size}, {dydt, c.size});
  ++c.evaluations;
  return GSL_SUCCESS;
}

/// GSL's stepper, step control and memory for n unknowns.
struct Stepper {
  Stepper(OdeMethod method, const OdeTolerance& tolerance, std::size_t n)
      : step(gsl_odeiv2_step_alloc(step_type(method), n)),
        control(gsl_odeiv2_control_y_new(tolerance.absolute, tolerance.relative)),
        evolve(gsl_odeiv2_evolve_alloc(n)) {}
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  ~Stepper() {
    gsl_odeiv2_evolve_free(evolve);
    gsl_odeiv2_control_free(control);
    gsl_odeiv2_step_free(step);
  }
  gsl_odeiv2_step* step;
  gsl_odeiv2_control* control;
  gsl_odeiv2_evolve* evolve;
};

}  // namespace

long integrate(const RightHandSide& f, OdeMethod method, const OdeTolerance& tolerance, double t0,
               double t1, std::vector<double>& y) {
  const QuietGsl quiet;
  const Stepper s(method, tolerance, y.size());
  Context context{f, y.size()};
  const gsl_odeiv2_system system{evaluate, nullptr, y.size(), &context};
  double h = first_step * (t1 - t0);  // the step control adapts it
  double elapsed = 0.0, lost = 0.0;
  // The time of each step starts at 0, and the steps are summed with compensation (Kahan). GSL's
  // own sum accumulates a rounding error in equal steps: 1e-12 s after 5000 steps.
  int steps = 0;
  for (double left = t1 - t0; left > 0.0; left = (t1 - t0 - elapsed) + lost) {
    context.step_start = t0 + elapsed;
    double taken = 0.0;
    const int status =
        gsl_odeiv2_evolve_apply(s.evolve, s.control, s.step, &system, &taken, left, &h, y.data());
    const bool moved = taken > smallest_step * (t1 - t0) || taken == left;
    if (status != GSL_SUCCESS || !moved || ++steps > most_steps)
      throw RunError(fmt::format("GSL stopped at t = {} s, step {}, with h = {} s: {}",
                                 context.step_start, steps, h, gsl_strerror(status)));
    const double corrected = taken - lost, sum = elapsed + corrected;
    lost = (sum - elapsed) - corrected;
    elapsed = sum;
  }
  return context.evaluations;
}

long integrate_rk4(const RightHandSide& f, int steps, double t0, double t1,
                   std::vector<double>& y) {
  const double h = (t1 - t0) / steps;
  const std::size_t n = y.size();
  std::vector<double> k1(n), k2(n), k3(n), k4(n), z(n);
  const auto shifted = [&](const std::vector<double>& k, double by) {
    for (std::size_t i = 0; i < n; ++i) z[i] = y[i] + by * k[i];
    return std::span<const double>(z);
  };
  for (int step = 0; step < steps; ++step) {
    const double t = t0 + step * h;
    f(t, y, k1);
    f(t + 0.5 * h, shifted(k1, 0.5 * h), k2);
    f(t + 0.5 * h, shifted(k2, 0.5 * h), k3);
    f(t + h, shifted(k3, h), k4);
    for (std::size_t i = 0; i < n; ++i) y[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
  }
  return 4L * steps;
}

}  // namespace tdbd::reference
