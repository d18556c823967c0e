#pragma once

namespace tdbd::simulation {

/// Running mean of a number over steps, and the sum of its squared deviations from the mean
/// (Welford's algorithm).
struct Spread {
  long count = 0;
  double mean = 0.0, squares = 0.0;

  template <class Archive>
  void serialize(Archive& a) {
    a(count, mean, squares);
  }
};

void add(Spread& spread, double x);

/// Standard deviation (divisor n); 0 without samples.
double deviation(const Spread& spread);

/// Standard deviation divided by the mean; 0 if the mean is 0.
double relative_deviation(const Spread& spread);

}  // namespace tdbd::simulation
