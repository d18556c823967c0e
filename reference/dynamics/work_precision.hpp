#pragma once

#include <string>
#include <vector>

#include "reference/dynamics/runge_kutta.hpp"

namespace tdbd::reference {

/// The rivals of the program's step: GSL's adaptive methods, whose accuracy is the tolerance, and
/// the classical fixed step, whose accuracy is the number of steps.
enum class Rival { rk8pd, rkf45, rk4 };

struct WorkPrecision {
  double accuracy = 0.0;        ///< requested
  long evaluations = 0;         ///< of the right-hand side, hence of the torque
  double attitude_error = 0.0;  ///< rad, angle to the attitude at a tolerance of rounding
  GyrostatState end;
};

/// Angle between two attitudes, rad; A need not be quite orthogonal.
double angle_between(const Mat3& A, const Mat3& B);

/// What each accuracy costs and reaches at t_end (s). Without torque samples: a fixed step would
/// have to know them. Throws RunError when a tolerance is out of reach, and InputError when there
/// are samples or a number of steps is not positive and whole.
std::vector<WorkPrecision> work_precision(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                                          const GyrostatState& start, double t_end, Rival rival,
                                          const std::vector<double>& accuracies);

}  // namespace tdbd::reference
