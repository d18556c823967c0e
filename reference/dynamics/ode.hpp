#pragma once

#include <functional>
#include <span>
#include <vector>

namespace tdbd::reference {

/// y' = f(t, y), written into the last argument.
using RightHandSide =
    std::function<void(double t, std::span<const double> y, std::span<double> dydt)>;

/// GSL's adaptive Runge-Kutta methods: Prince-Dormand 8(9), Fehlberg 4(5).
enum class OdeMethod { rk8pd, rkf45 };

/// Error of one step, per component: at most absolute + relative |y|.
struct OdeTolerance {
  double absolute = 1e-15;
  double relative = 1e-15;
};

/// Integrates y from t0 to t1 > t0. Returns the number of evaluations of f. Throws RunError if the
/// step becomes too small for the tolerance, and after 200 000 steps.
long integrate(const RightHandSide& f, OdeMethod method, const OdeTolerance& tolerance, double t0,
               double t1, std::vector<double>& y);

/// The classical Runge-Kutta method in `steps` equal steps, with four evaluations per step. (GSL's
/// own rk4 needs eleven, because it doubles each step for an error estimate, which a fixed step
/// does not use.)
long integrate_rk4(const RightHandSide& f, int steps, double t0, double t1, std::vector<double>& y);

}  // namespace tdbd::reference
