#include "reference/literature/surface/spoke_plane.hpp"

#include <cmath>
#include <numbers>

namespace tdbd::reference {

double spoke_azimuth(int spoke, int spokes) { return 2.0 * std::numbers::pi * spoke / spokes; }

SpokePlane spoke_plane(int spoke, int spokes) {
  const double azimuth = spoke_azimuth(spoke, spokes);
  return {std::cos(azimuth), std::sin(azimuth)};
}

std::optional<Vec2> crossing(const SpokePlane& plane, const Vec3& a, const Vec3& b) {
  const double beside_a = plane.beside(a), beside_b = plane.beside(b);
  if ((beside_a < 0.0) == (beside_b < 0.0)) return std::nullopt;
  return plane.foot(a + beside_a / (beside_a - beside_b) * (b - a));
}

}  // namespace tdbd::reference
