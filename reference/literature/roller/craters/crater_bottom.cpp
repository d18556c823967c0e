#include "reference/literature/roller/craters/crater_bottom.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::reference {
namespace {

struct CellsAround {
  int first, last;
};

CellsAround cells_around(const ZMap& bottom, double x, double radius) {
  const double cell = bottom.cell();
  const auto index = [&](double at) { return (at + bottom.half) / cell - 0.5; };
  return {std::max(static_cast<int>(std::ceil(index(x - radius))), 0),
          std::min(static_cast<int>(std::floor(index(x + radius))), bottom.cells - 1)};
}

/// Height of the crater's surface above its deepest point at a distance with this square, m.
double rise_of(const Crater& crater, double square) {
  if (crater.shape == CraterShape::cone) return crater.depth * std::sqrt(square) / crater.radius;
  return crater.radius - std::sqrt(crater.radius * crater.radius - square);
}

}  // namespace

double isolated_volume(const Crater& crater) {
  const double r = crater.radius, d = crater.depth;
  if (crater.shape == CraterShape::cone) return std::numbers::pi * r * r * d / 3.0;
  return std::numbers::pi * d * d * (r - d / 3.0);
}

double level_at(const ZMap& bottom, double x, double y) {
  const double most = bottom.cells - 1.0, cell = bottom.cell();
  const double u = std::clamp((x + bottom.half) / cell - 0.5, 0.0, most);
  const double v = std::clamp((y + bottom.half) / cell - 0.5, 0.0, most);
  const int i = std::min(static_cast<int>(u), bottom.cells - 2);
  const int j = std::min(static_cast<int>(v), bottom.cells - 2);
  const double* row = &bottom.height[at(j) * at(bottom.cells) + at(i)];
  const double* next = row + bottom.cells;
  const double s = u - i, t = v - j;
  return (1.0 - t) * ((1.0 - s) * row[0] + s * row[1]) + t * ((1.0 - s) * next[0] + s * next[1]);
}

double dig(ZMap& bottom, const Crater& crater) {
  if (!(crater.depth > 0.0 && crater.radius > 0.0)) return 0.0;
  const Vec3& tip = crater.tip_W;
  const CellsAround columns = cells_around(bottom, tip.x(), crater.radius);
  const CellsAround rows = cells_around(bottom, tip.y(), crater.radius);
  const double within = crater.radius * crater.radius;
  double change = 0.0;
  for (int j = rows.first; j <= rows.last; ++j) {
    const double dy = bottom.centre(j) - tip.y();
    double* height = &bottom.height[at(j) * at(bottom.cells)];
    for (int i = columns.first; i <= columns.last; ++i) {
      const double dx = bottom.centre(i) - tip.x(), square = dx * dx + dy * dy;
      if (square >= within) continue;
      const double lower = tip.z() - rise_of(crater, square);
      change += std::max(0.0, lower - height[i]);
      height[i] = std::max(height[i], lower);
    }
  }
  return change * bottom.cell() * bottom.cell();
}

}  // namespace tdbd::reference
