#pragma once

#include <functional>
#include <string>

namespace tdbd::reference {

/// A root in an interval at whose ends a function has different signs.
struct BracketedRoot {
  double x = 0.0;
  int evaluations = 0;
};

/// Parameters of a search: the interval, the accuracy, and the name of the root for messages.
struct RootSearch {
  double low = 0.0, high = 0.0;
  double relative = 1e-15;  ///< width of the last bracket relative to the root
  int at_most = 200;        ///< number of iterations
  std::string what;         ///< "Sheppard and Lesage: the cone's speed (rad/s)"
};

/// Finds a root by Brent's method (GSL). Throws InputError that begins with `what` if the function
/// has the same sign at both ends.
BracketedRoot bracketed_root(const std::function<double(double)>& f, const RootSearch& search);

}  // namespace tdbd::reference
