#pragma once

#include <functional>
#include <vector>

#include "core/observed_order.hpp"

namespace tdbd::reference {

/// Ma, Zhou and Deng (1995) as thesis 2.2 tells it: a cone on its journal obeys T = Ic d2phi/dt2, eq. (2.4),
/// and eq. (2.5) moves its angle by a step. The excerpt that we hold has lost the Greek letters of both, so
/// that what stands on the right of (2.5) cannot be read: three readings are here, side by side, and none of
/// them accuses the print. Only the last integrates (2.4); that it is meant is our reconstruction.
enum class ConeReading {
  as_printed,  ///< (i)   phi(t + dt) = phi(t) + T Ic dt2: not an angle on the right
  divided,     ///< (ii)  phi(t + dt) = phi(t) + (T/Ic) dt2: an angle, but without inertia
  increments,  ///< (iii) Dphi(t + dt) = Dphi(t) + (T/Ic) dt2: Stoermer's scheme
};

/// How reading (iii) begins: with the increment of the initial speed alone, or with that of a step from half
/// a step before the start, which keeps its second order.
enum class ConeStart { simple, half_step };

/// A cone between two steps.
struct ConeTurn {
  double angle = 0.0;      ///< phi, rad
  double increment = 0.0;  ///< Dphi of the step before, rad
  double change = 0.0;     ///< of that increment over the one before it, rad
};

/// Cone at the start: angle (rad), speed (rad/s), torque (N m) there, inertia (kg m2), step (s).
ConeTurn started_cone(double angle, double speed, double torque, double inertia, double step,
                      ConeStart start);

/// One step under the torque of its beginning.
void advance_cone(ConeTurn& cone, ConeReading reading, double torque, double inertia, double step);

/// The cone's speed now, rad/s, of second order: its last increment lies half a step back.
inline double cone_speed(const ConeTurn& cone, double step) {
  return (cone.increment + 0.5 * cone.change) / step;
}

/// A cone under a torque of its angle and speed.
struct ConeProblem {
  double inertia = 0.0;                                      ///< kg m2
  double speed = 0.0;                                        ///< rad/s, at the start, at angle 0
  double duration = 0.0;                                     ///< s
  std::function<double(double angle, double speed)> torque;  ///< N m
};

/// Angle at the end, rad, after so many steps.
double recursion_result(const ConeProblem& problem, ConeReading reading, ConeStart start,
                        long steps);

/// The same by a Runge-Kutta scheme of fourth order with so many steps: what the readings aim at.
double runge_kutta_result(const ConeProblem& problem, long steps);

/// A reading with a start, and what it makes of a problem.
struct RecursionRow {
  ConeReading reading = ConeReading::as_printed;
  ConeStart start = ConeStart::simple;
  double result = 0.0;       ///< rad, at the end
  double error = 0.0;        ///< rad, against Runge-Kutta
  ObservedOrder order = {};  ///< of the error, over `steps` and four times half the step
};

/// All readings, (iii) with both starts.
std::vector<RecursionRow> recursion_table(const ConeProblem& problem, long steps);

}  // namespace tdbd::reference
