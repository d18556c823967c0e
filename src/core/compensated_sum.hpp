#pragma once

#include <cmath>

namespace tdbd {

/// Compensated summation (Neumaier): the error does not grow with the number of terms.
struct CompensatedSum {
  double sum = 0.0;
  double correction = 0.0;

  void add(double x) {
    const double t = sum + x;
    correction += std::abs(sum) >= std::abs(x) ? (sum - t) + x : (x - t) + sum;
    sum = t;
  }
  double value() const { return sum + correction; }

  template <class Archive>
  void serialize(Archive& a) {
    a(sum, correction);
  }
};

}  // namespace tdbd
