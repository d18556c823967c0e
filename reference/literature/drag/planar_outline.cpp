#include "reference/literature/drag/planar_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace tdbd::reference {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double never = -std::numeric_limits<double>::infinity();

/// Depth of the ellipse's lower branch at radius r.
double outline(const bit::Cutter& c, double r) {
  const double a = c.diameter / 2.0, b = a * std::cos(c.back_rake);
  const double sine = std::sin(c.profile_angle), cosine = std::cos(c.profile_angle);
  const double p = b * sine, q = a * cosine, size = std::hypot(p, q);
  const double x = (r - (c.tip_radius - b * sine)) / size;
  if (std::abs(x) > 1.0) return never;
  const auto z = [&](double s) {
    return -c.tip_height - b * cosine + b * cosine * std::cos(s) - a * sine * std::sin(s);
  };
  const double middle = std::atan2(q, p), half = std::acos(x);
  return std::max(z(middle - half), z(middle + half));
}

double azimuth(const bit::Cutter& c) {
  return c.azimuth - 2 * pi * std::floor(c.azimuth / (2 * pi));
}

}  // namespace

PlanarCut planar_cut(const std::vector<bit::Cutter>& cutters, double advance, double column) {
  std::vector<std::size_t> order(cutters.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return azimuth(cutters[i]) > azimuth(cutters[j]);
  });
  PlanarCut cut{std::vector<double>(cutters.size()), std::vector<double>(cutters.size())};
  double widest = 0.0;
  for (const bit::Cutter& c : cutters) widest = std::max(widest, c.tip_radius + c.diameter);
  constexpr int revolutions = 6;
  for (double r = column / 2; r < widest; r += column) {
    double bottom = never;
    for (int k = 0; k < revolutions; ++k)
      for (const std::size_t i : order) {
        const double depth =
            outline(cutters[i], r) + advance * (k + 1 - azimuth(cutters[i]) / (2 * pi));
        if (k == revolutions - 1 && depth > bottom) {
          cut.area[i] += (depth - bottom) * column;
          cut.volume[i] += 2 * pi * r * (depth - bottom) * column;
        }
        bottom = std::max(bottom, depth);
      }
  }
  return cut;
}

}  // namespace tdbd::reference
