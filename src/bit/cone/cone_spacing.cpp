#include "bit/cone/cone_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::bit {

std::vector<double> spaced_angles(int teeth, double first_angle,
                                  const std::vector<double>& pattern) {
  constexpr double two_pi = 2.0 * std::numbers::pi;
  const auto ratio = [&](int i) {
    return pattern.empty() ? 1.0 : pattern[static_cast<std::size_t>(i) % pattern.size()];
  };
  double sum = 0.0;
  for (int i = 0; i < teeth; ++i) sum += ratio(i);
  std::vector<double> angles;
  double passed = 0.0;
  for (int i = 0; i < teeth; ++i) {
    const double angle = first_angle + two_pi * passed / sum;
    const double turned = angle - two_pi * std::floor(angle / two_pi);
    angles.push_back(turned < two_pi ? turned : 0.0);
    passed += ratio(i);
  }
  std::ranges::sort(angles);
  return angles;
}

}  // namespace tdbd::bit
