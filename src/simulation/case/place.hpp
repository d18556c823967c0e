#pragma once

#include "core/pose.hpp"
#include "simulation/case/motion.hpp"

namespace tdbd::simulation {

/// Where the bit is at an instant.
struct Place {
  Pose X_WB;            ///< bit in space
  double turned = 0.0;  ///< rad about the bit's axis since the start
  double rock_z = 0.0;  ///< m that the rock has moved along +z (eq. 2.2)
};

/// The bit in the frame of the rock, in which its surface is kept.
inline Pose over_rock(const Place& place) {
  Pose X_RB = place.X_WB;
  X_RB.p.z() -= place.rock_z;
  return X_RB;
}

/// The place at time t (s) along a prescribed motion.
inline Place place_at(const Motion& motion, double t) {
  return {pose_at(motion, t), angle_turned(motion, t), 0.0};
}

}  // namespace tdbd::simulation
