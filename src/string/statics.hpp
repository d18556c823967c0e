#pragma once

#include <vector>

#include "string/chain.hpp"

namespace tdbd::string {

/// Steady motion of a chain: all nodes have the same two speeds.
struct SteadyMotion {
  double rate = 0.0;          ///< along the hole, downward, m/s
  double rotary_speed = 0.0;  ///< rad/s
  double pull = 0.0;          ///< of the last element on the bit, N
  double torque = 0.0;        ///< of the last element on the bit, N m
};

/// Static torque and drag: loads of the elements, N, N m, and at the surface.
struct SteadyLoad {
  std::vector<double> tension, torque;  ///< of elements
  std::vector<double> side_force;       ///< of nodes, N
  SurfaceLoad surface;
};

/// Equilibrium of the chain, computed from the bit upwards. It is exactly that of a time step, so a
/// run that starts with it remains steady. If both speeds are zero, there is no friction.
SteadyLoad steady_load(const Chain& chain, const SteadyMotion& motion);

/// The chain in this motion under this load with the top at 0, and the resulting position of the
/// bit.
struct SteadyStart {
  ChainState chain;
  EndMotion end;
};
SteadyStart steady_start(const Chain& chain, const SteadyMotion& motion, const SteadyLoad& load);

/// A free vibration of a chain with a fixed top.
struct Mode {
  double frequency = 0.0;     ///< Hz
  std::vector<double> shape;  ///< of nodes 0 to n, normalized to a largest magnitude of 1
};

/// The lowest `count` modes in one direction, ascending. `stiffness` has n elements, `mass` nodes 0
/// to n; the last node is free. Exact to rounding: bisection on the number of frequencies below a
/// given one, which is the number of negative pivots (Sturm).
std::vector<Mode> lowest_modes(const std::vector<double>& stiffness,
                               const std::vector<double>& mass, int count);

}  // namespace tdbd::string
