#pragma once

#include <vector>

namespace tdbd::string {

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
