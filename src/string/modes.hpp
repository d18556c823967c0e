#pragma once

#include <vector>

namespace tdbd::string {

/// A free vibration of a chain whose top stands still.
struct Mode {
  double frequency = 0.0;     ///< Hz
  std::vector<double> shape;  ///< of nodes 0 to n, the largest 1 in size
};

/// The lowest `count` modes, ascending: `stiffness` of n elements, `mass` of nodes 0 to n, in one
/// direction. The last node is free. Exact to rounding: bisection on the number of frequencies below
/// one, which the signs of the pivots give (Sturm).
std::vector<Mode> lowest_modes(const std::vector<double>& stiffness,
                               const std::vector<double>& mass, int count);

}  // namespace tdbd::string
