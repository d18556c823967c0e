#include "reference/literature/roller/craters/line_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::reference {

std::vector<double> line_spectrum(std::span<const double> series, double step,
                                  std::span<const double> frequencies) {
  const double n = static_cast<double>(series.size());
  double mean = 0.0;
  for (const double x : series) mean += x / n;
  std::vector<double> amplitudes;
  amplitudes.reserve(frequencies.size());
  for (const double f : frequencies) {
    const double c = 2.0 * std::cos(2.0 * std::numbers::pi * f * step);
    double last = 0.0, before = 0.0;
    for (const double x : series) {
      const double now = x - mean + c * last - before;
      before = last;
      last = now;
    }
    const double power = last * last + before * before - c * last * before;
    amplitudes.push_back(2.0 / n * std::sqrt(std::max(power, 0.0)));
  }
  return amplitudes;
}

}  // namespace tdbd::reference
