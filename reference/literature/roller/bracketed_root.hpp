#pragma once

#include <functional>
#include <string>

namespace tdbd::reference {

/// A root between two places where a function has different signs.
struct BracketedRoot {
  double x = 0.0;
  int evaluations = 0;
};

/// Where to look, how narrow the bracket must become, and what to say if there is nothing.
struct RootSearch {
  double low = 0.0, high = 0.0;
  double relative = 1e-15;  ///< width of the last bracket over the root
  int at_most = 200;        ///< steps
  std::string what;         ///< "Sheppard and Lesage: the cone's speed (rad/s)"
};

/// By Brent's method (GSL's). Throws InputError that begins with `what` when the ends have the same
/// sign.
BracketedRoot bracketed_root(const std::function<double(double)>& f, const RootSearch& search);

}  // namespace tdbd::reference
