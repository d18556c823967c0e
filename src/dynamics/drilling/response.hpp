#pragma once

#include <Eigen/Core>

#include "dynamics/drilling/columns.hpp"
#include "dynamics/drilling/drilling_step.hpp"

namespace tdbd::dynamics {

/// Linear response of the velocity between the drifts of this step and the next one to the wrench
/// of this step:
///   u = free + A f                                                                            (18)
/// u: velocity of the centre of mass, angular velocity, cone rates, and velocity of the rock along
/// z if it can move; f: force, torque about the centre, T_k . s_k, force on the rock. An addition
/// of TDBD [+].
struct Response {
  Eigen::VectorXd free;  ///< m/s, rad/s
  Eigen::MatrixXd A;     ///< m/s and rad/s per N and per N m
};

/// Work data, reused so that later steps allocate nothing.
struct ResponseWork {
  Wrench wrench;
  DrillingVelocity velocity;
  Eigen::VectorXd column;
};

/// Evaluates velocity_after once per degree of freedom and once without a wrench. The result is
/// exact with dampers, whose flows are linear. Friction at the wall is nonlinear; the result is
/// then a secant over the probes. Torques on cones act at the end of an open step, and in halves
/// for a state between two steps.
void find_response(const DrillingSystem& system, double h, const Drilling& d, KicksLeft kicks,
                   DrillingWork& work, ResponseWork& room, Response& response);

}  // namespace tdbd::dynamics
