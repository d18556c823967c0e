#pragma once

#include <string>
#include <vector>

#include "reference/dynamics/runge_kutta.hpp"

namespace tdbd::reference {

/// Methods to compare with the program's step: GSL's adaptive methods, whose accuracy is the
/// tolerance, and the classical method, whose accuracy is the number of equal steps.
enum class ComparisonMethod { rk8pd, rkf45, rk4 };

struct WorkPrecision {
  double accuracy = 0.0;        ///< requested
  long evaluations = 0;         ///< of the right-hand side, hence of the torque
  double attitude_error = 0.0;  ///< rad, relative to the attitude at a tolerance of rounding
  GyrostatState end;
};

/// Angle between two attitudes, rad. A need not be exactly orthogonal.
double angle_between(const Mat3& A, const Mat3& B);

/// Computes the evaluations and the error at t_end (s) for each accuracy. Torque samples are not
/// allowed, because fixed steps would have to meet them. Throws RunError if a tolerance cannot be
/// reached, and InputError if there are samples or if a number of steps is not a positive integer.
std::vector<WorkPrecision> work_precision(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                                          const GyrostatState& start, double t_end,
                                          ComparisonMethod rival,
                                          const std::vector<double>& accuracies);

}  // namespace tdbd::reference
