#include "reference/literature/drag/plane/planar_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/drag/plane/cutter_rim.hpp"

namespace tdbd::reference {
namespace {

/// Heights of two revolutions agree if they differ by at most this, m.
constexpr double agreement = 1e-12;

/// One pass of a cutter, deeper by `sunk`. Returns the change of its removed heights since its last
/// pass, m.
double pass(const CutterColumns& cutter, double sunk, std::vector<double>& bottom,
            std::vector<double>& height) {
  double change = 0.0;
  for (std::size_t k = 0; k < cutter.depth.size(); ++k) {
    double& below = bottom[cutter.first + k];
    const double depth = cutter.depth[k] + sunk, h = depth > below ? depth - below : 0.0;
    if (h > 0.0) below = depth;
    if (h != height[k]) change = std::max(change, std::abs(h - height[k]));
    height[k] = h;
  }
  return change;
}

void shape(const RadialOutlines& outlines, PlanarCut& cut) {
  const std::size_t cutters = outlines.of_cutter.size();
  cut.area.assign(cutters, 0.0);
  cut.volume.assign(cutters, 0.0);
  cut.bottom.assign(outlines.columns, no_depth);
  cut.height.resize(cutters);
  for (std::size_t i = 0; i < cutters; ++i)
    cut.height[i].assign(outlines.of_cutter[i].depth.size(), 0.0);
}

void sum_heights(const RadialOutlines& outlines, PlanarCut& cut) {
  const double width = outlines.width;
  for (std::size_t i = 0; i < cut.height.size(); ++i) {
    double area = 0.0, moment = 0.0;
    for (std::size_t k = 0; k < cut.height[i].size(); ++k) {
      area += cut.height[i][k];
      moment += cut.height[i][k] * (static_cast<double>(outlines.of_cutter[i].first + k) + 0.5);
    }
    cut.area[i] = area * width;
    cut.volume[i] = 2 * std::numbers::pi * moment * width * width;
  }
}

}  // namespace

double PlanarCut::arm(std::size_t cutter) const {
  return area[cutter] > 0.0 ? volume[cutter] / (2 * std::numbers::pi * area[cutter]) : 0.0;
}

void planar_cut(const RadialOutlines& outlines, double advance, PlanarCut& cut) {
  shape(outlines, cut);
  constexpr int most = 20;  // two or three are sufficient for any bit
  for (cut.revolutions = 1; cut.revolutions <= most; ++cut.revolutions) {
    double change = 0.0;
    for (const std::size_t i : outlines.order) {
      const CutterColumns& cutter = outlines.of_cutter[i];
      change = std::max(change, pass(cutter, advance * (cut.revolutions - cutter.share), cut.bottom,
                                     cut.height[i]));
    }
    if (change <= agreement) return sum_heights(outlines, cut);
  }
  throw RunError("Warren and Sinor: the cuts of two revolutions never agreed");
}

PlanarCut planar_cut(const RadialOutlines& outlines, double advance) {
  PlanarCut cut;
  planar_cut(outlines, advance, cut);
  return cut;
}

PlanarCut planar_cut(const std::vector<bit::Cutter>& cutters, double advance, double column) {
  return planar_cut(radial_outlines(cutters, OutlineForm::planar, column), advance);
}

}  // namespace tdbd::reference
