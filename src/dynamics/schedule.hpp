#pragma once

#include <string>
#include <vector>

namespace tdbd::dynamics {

/// Values of a schedule between its times.
enum class Interpolation {
  stepwise,  ///< constant until the next time
  linear,    ///< linear
};

/// A quantity as a function of time (s): a constant, steps or ramps. Before the first time it has
/// the first value, after the last time the last value. Zero if empty.
struct Schedule {
  Interpolation interpolation = Interpolation::stepwise;
  std::vector<double> times;      ///< s, ascending
  std::vector<double> values;     ///< one per time
  std::vector<double> integrals;  ///< from the first time to each; derived by make_schedule
  double integral_at_zero = 0.0;  ///< integral from the first time to t = 0; derived
};

/// Why these are not a valid schedule, with the invalid entry; empty if they are.
std::string schedule_problem(const std::vector<double>& times, const std::vector<double>& values);

/// Creates a schedule. Throws InputError with the result of schedule_problem.
Schedule make_schedule(Interpolation interpolation, std::vector<double> times,
                       std::vector<double> values);

/// A constant schedule.
Schedule constant(double value);

/// The value at t. At a step, the value after it.
double value_at(const Schedule& s, double t);

/// Exact integral from 0 to t, for example the angle of a top that rotates at a scheduled speed.
double integral_to(const Schedule& s, double t);

}  // namespace tdbd::dynamics
