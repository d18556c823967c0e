#pragma once

#include <string>
#include <vector>

namespace tdbd::dynamics {

/// What a schedule does between its times.
enum class Interpolation {
  stepwise,  ///< holds the last value: a staircase
  linear,    ///< a ramp
};

/// A quantity over time (s): a constant, a staircase or a ramp. Holds its first value before the
/// first time and its last after the last. Empty: zero.
struct Schedule {
  Interpolation interpolation = Interpolation::stepwise;
  std::vector<double> times;      ///< s, ascending
  std::vector<double> values;     ///< as many
  std::vector<double> integrals;  ///< from the first time on; derived by make_schedule
  double integral_at_zero = 0.0;  ///< the same at t = 0; derived
};

/// Why these are not a valid schedule, with the offending entry; empty when they are.
std::string schedule_problem(const std::vector<double>& times, const std::vector<double>& values);

/// Throws InputError with schedule_problem's reason.
Schedule make_schedule(Interpolation interpolation, std::vector<double> times,
                       std::vector<double> values);

/// The same value for ever.
Schedule constant(double value);

/// The value at t; at a stair's edge the value after it.
double value_at(const Schedule& s, double t);

/// Integral from 0 to t, exact: the angle of a top that turns at a scheduled speed.
double integral_to(const Schedule& s, double t);

}  // namespace tdbd::dynamics
