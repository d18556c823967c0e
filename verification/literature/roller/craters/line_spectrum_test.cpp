#include "reference/literature/roller/craters/line_spectrum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace tdbd::reference::line_spectrum_test {
namespace {

/// Rounding of a recursion over 2000 readings; scale: the largest amplitude.
constexpr double of_recursion = 1e-9;

TEST(LineSpectrum, finds_the_amplitudes_of_sines_and_nothing_between_them) {
  constexpr double step = 1e-3, pi = std::numbers::pi;
  std::vector<double> series;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * step;
    series.push_back(7.0 + 3.0 * std::sin(2 * pi * 60.0 * t + 0.4) +
                     0.5 * std::cos(2 * pi * 150.5 * t));
  }
  constexpr std::array frequencies{60.0, 100.0, 150.5};
  const std::vector<double> a = line_spectrum(series, step, frequencies);
  EXPECT_NEAR(a[0], 3.0, of_recursion);
  EXPECT_NEAR(a[1], 0.0, of_recursion);
  EXPECT_NEAR(a[2], 0.5, of_recursion);
}

}  // namespace
}  // namespace tdbd::reference::line_spectrum_test
