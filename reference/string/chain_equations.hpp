#pragma once

#include <vector>

/// Slow twin of the step of src/string/chain: the same equations of motion, string (3) and (4), by
/// the classical Runge-Kutta method with very small steps.
namespace tdbd::reference {

/// A chain whose top is lowered and rotated at constant speeds and whose lower end is free. Coulomb
/// friction with a single level, for a slip that never vanishes. Node k of `mass` is below element
/// k. SI units.
struct SlidingChain {
  std::vector<double> axial, torsional;                 ///< stiffnesses of elements, N/m, N m/rad
  std::vector<double> mass, inertia;                    ///< of the nodes below them, kg, kg m2
  std::vector<double> weight, radius;                   ///< of these nodes, N, m
  std::vector<double> friction;                         ///< of these nodes
  std::vector<double> bend, mixed, side;                ///< a, b, c of pieces, string (4)
  std::vector<int> element, node;                       ///< of pieces; nodes as above
  double axial_damping = 0.0, torsional_damping = 0.0;  ///< by mass, by inertia, 1/s
  double top_rate = 0.0, top_speed = 0.0;               ///< m/s, rad/s
};

struct SlidingState {
  std::vector<double> displacement, angle, velocity, rotary_speed;  ///< of nodes
  double time = 0.0;
  double lost = 0.0;  ///< J, dissipated by friction
};

/// Makes `steps` steps of h (s).
void advance_sliding(const SlidingChain& chain, double h, long steps, SlidingState& state);

}  // namespace tdbd::reference
