#include "reference/forces/groove_by_strips.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {

double groove_area_by_strips(double diameter, double back_rake, double depth, int strips) {
  const double across = diameter / 2.0, along = across * std::cos(back_rake);
  const double width = diameter / strips;
  double area = 0.0;
  for (int k = 0; k < strips; ++k) {
    const double x = (k + 0.5) * width / across - 1.0;
    const double half = along * std::sqrt(1.0 - x * x);
    // The strip reaches from -half to half about the centre; the rock's surface is depth - along.
    area += width * std::clamp(depth - along + half, 0.0, 2.0 * half);
  }
  return area;
}

}  // namespace tdbd::reference
