#pragma once

#include <functional>
#include <vector>

#include "core/observed_order.hpp"

namespace tdbd::reference {

/// Ma, Zhou and Deng (1995) as described in thesis 2.2: a cone on its journal obeys T = Ic
/// d2phi/dt2, eq. (2.4), and eq. (2.5) advances its angle by a step. In our excerpt the Greek
/// letters of both are missing, so the right-hand side of (2.5) cannot be read. Three readings are
/// implemented here; none of them implies a misprint. Only the last one integrates (2.4); that it
/// is the intended one is our reconstruction.
enum class ConeReading {
  as_printed,  ///< (i)   phi(t + dt) = phi(t) + T Ic dt2: the increment is not an angle
  divided,     ///< (ii)  phi(t + dt) = phi(t) + (T/Ic) dt2: an angle, but without inertia
  increments,  ///< (iii) Dphi(t + dt) = Dphi(t) + (T/Ic) dt2: Stoermer's scheme
};

/// Start of reading (iii). `simple`: with the increment of the initial speed alone. `half_step`:
/// with that of a step from half a step before the start, which preserves the second order.
enum class ConeStart { simple, half_step };

/// State of a cone between two steps.
struct ConeTurn {
  double angle = 0.0;      ///< phi, rad
  double increment = 0.0;  ///< Dphi of the previous step, rad
  double change = 0.0;     ///< of that increment from the one before it, rad
};

/// Initial state of a cone: angle (rad), speed (rad/s), torque (N m), inertia (kg m2), step (s).
ConeTurn started_cone(double angle, double speed, double torque, double inertia, double step,
                      ConeStart start);

/// Makes one step under the torque at its beginning.
void advance_cone(ConeTurn& cone, ConeReading reading, double torque, double inertia, double step);

/// The cone's present speed, rad/s, of second order. Its last increment is centred half a step
/// earlier.
inline double cone_speed(const ConeTurn& cone, double step) {
  return (cone.increment + 0.5 * cone.change) / step;
}

/// A cone under a torque that depends on its angle and speed.
struct ConeProblem {
  double inertia = 0.0;                                      ///< kg m2
  double speed = 0.0;                                        ///< rad/s, at the start, at angle 0
  double duration = 0.0;                                     ///< s
  std::function<double(double angle, double speed)> torque;  ///< N m
};

/// Angle at the end, rad, after `steps` steps.
double recursion_result(const ConeProblem& problem, ConeReading reading, ConeStart start,
                        long steps);

/// The same by a fourth-order Runge-Kutta method with `steps` steps: the target of the readings.
double runge_kutta_result(const ConeProblem& problem, long steps);

/// A reading with a start, and its result for a problem.
struct RecursionRow {
  ConeReading reading = ConeReading::as_printed;
  ConeStart start = ConeStart::simple;
  double result = 0.0;       ///< rad, at the end
  double error = 0.0;        ///< rad, relative to Runge-Kutta
  ObservedOrder order = {};  ///< of the error, from `steps` steps and four halvings of the step
};

/// All readings, (iii) with both starts.
std::vector<RecursionRow> recursion_table(const ConeProblem& problem, long steps);

}  // namespace tdbd::reference
