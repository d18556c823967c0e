#pragma once

namespace tdbd::simulation {

/// Mean of a number over steps, and of its squared distance from the mean.
struct Spread {
  long count = 0;
  double mean = 0.0, squares = 0.0;
};

void add(Spread& spread, double x);

/// Root mean square of the distances from the mean, over the mean; 0 where the mean is.
double relative_rms(const Spread& spread);

}  // namespace tdbd::simulation
