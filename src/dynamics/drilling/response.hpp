#pragma once

#include <Eigen/Core>

#include "dynamics/drilling/columns.hpp"
#include "dynamics/drilling/drilling_step.hpp"

namespace tdbd::dynamics {

/// How the velocity between this step's drift and the next one's answers the wrench of this step:
///   u = free + A f                                                                            (18)
/// u: the centre's velocity, the angular velocity, cone rates, and the rock's along z where it may
/// move; f: force, torque about the centre, T_k . s_k, force on the rock. Ours.
struct Response {
  Eigen::VectorXd free;  ///< m/s, rad/s
  Eigen::MatrixXd A;     ///< m/s and rad/s for a N and a N m
};

/// Kept from step to step: no allocation once warm.
struct ResponseWork {
  Wrench wrench;
  DrillingVelocity velocity;
  Eigen::VectorXd column;
};

/// Evaluates velocity_after once for each freedom and once without a wrench. Exact with dampers,
/// whose flows are linear; friction at the wall, which is not linear, makes it a secant over the
/// probes. Torques on cones act at the end of an open step, and in halves on a state between two.
void find_response(const DrillingSystem& system, double h, const Drilling& d, KicksLeft kicks,
                   DrillingWork& work, ResponseWork& room, Response& response);

}  // namespace tdbd::dynamics
