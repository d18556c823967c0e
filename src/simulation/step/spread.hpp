#pragma once

namespace tdbd::simulation {

/// Running mean of a number over steps, and the sum of its squared distances from the mean
/// (Welford's recurrence).
struct Spread {
  long count = 0;
  double mean = 0.0, squares = 0.0;
};

void add(Spread& spread, double x);

/// Root mean square of the distances from the mean; 0 of nothing.
double deviation(const Spread& spread);

/// The same over the mean; 0 where the mean is.
double relative_deviation(const Spread& spread);

}  // namespace tdbd::simulation
