#pragma once

#include <vector>

#include "string/chain.hpp"

namespace tdbd::string {

/// A chain that moves steadily: every node at the same two speeds.
struct SteadyMotion {
  double rate = 0.0;          ///< along the hole, downward, m/s
  double rotary_speed = 0.0;  ///< rad/s
  double pull = 0.0;          ///< of the last element on the bit, N
  double torque = 0.0;        ///< of the last element on the bit, N m
};

/// Static torque and drag: what the elements carry, N, N m, and the surface.
struct SteadyLoad {
  std::vector<double> tension, torque;  ///< of elements
  std::vector<double> side_force;       ///< of nodes, N
  SurfaceLoad surface;
};

/// Equilibrium of the chain, from the bit up: exactly that of its step, so that a run that starts with
/// it goes on with it. Where neither speed is positive nor negative, there is no friction.
SteadyLoad steady_load(const Chain& chain, const SteadyMotion& motion);

/// The chain in this motion under this load, the top at 0, and where the bit is then.
struct SteadyStart {
  ChainState chain;
  EndMotion end;
};
SteadyStart steady_start(const Chain& chain, const SteadyMotion& motion, const SteadyLoad& load);

}  // namespace tdbd::string
