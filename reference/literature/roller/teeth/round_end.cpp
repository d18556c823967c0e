#include "reference/literature/roller/teeth/round_end.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/literature/roller/craters/crater_bottom.hpp"

namespace tdbd::reference {

RoundEnd round_end(double sphere_radius, double spacing, double deepest) {
  const double a = sphere_radius;
  const auto rise = [&](double r) { return r >= a ? a : a - std::sqrt(a * a - r * r); };
  RoundEnd end;
  for (int ring = 0; rise(ring * spacing) < std::min(deepest, a); ++ring) {
    const double low = rise(ring * spacing), high = rise((ring + 1) * spacing);
    const double height = 0.5 * (low + high), r = std::sqrt(height * (2.0 * a - height));
    const int points = std::max(1, static_cast<int>(2.0 * std::numbers::pi * r / spacing));
    for (int i = 0; i < points; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.5 * (ring % 2)) / points;
      end.points.push_back(
          {r * std::cos(angle), r * std::sin(angle), height, (high - low) / points});
    }
  }
  return end;
}

double touch_round_end(const RoundEnd& end, const Vec3& tip, const ZMap& bottom, double* gaps) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < end.points.size(); ++i) {
    const RoundEnd::Point& p = end.points[i];
    gaps[i] = level_at(bottom, tip.x() + p.x, tip.y() + p.y) - tip.z() + p.rise;
    least = std::min(least, gaps[i]);
  }
  return least;
}

double round_end_force(const RoundEnd& end, const ToothLaw& law, const double* gaps, double z) {
  double sum = 0.0;
  for (std::size_t i = 0; i < end.points.size(); ++i)
    if (gaps[i] < z) sum += end.points[i].height * tooth_stiffness(law, z - gaps[i]);
  return sum;
}

}  // namespace tdbd::reference
