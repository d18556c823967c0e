#include "reference/bit/radial_plane_engagement.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/types.hpp"
#include "reference/bit/radial_columns.hpp"

namespace tdbd::reference {
namespace {

constexpr int revolutions = 5;

/// The pass of one cutter through the half-plane in one revolution.
struct Pass {
  double theta;  ///< rad, by which the bit has turned
  double depth;  ///< m
  std::size_t cutter;
  int revolution;
};

/// All passes at one radius, in order of time.
std::vector<Pass> passes(const std::vector<Deepest>& column, double advance) {
  std::vector<Pass> all;
  for (std::size_t c = 0; c < column.size(); ++c)
    if (column[c].depth != Deepest::never)
      for (int k = 0; k < revolutions; ++k)
        all.push_back({full_turn * k - column[c].phi, column[c].depth + advance * k, c, k});
  std::sort(all.begin(), all.end(), [](const Pass& a, const Pass& b) { return a.theta < b.theta; });
  return all;
}

/// Thickness that each cutter removes at one radius in one revolution, m.
std::vector<double> removed(const std::vector<Deepest>& column, double advance, int revolution) {
  std::vector<double> thickness(column.size(), 0.0);
  double height = Deepest::never;
  for (const Pass& pass : passes(column, advance)) {
    const double cut = std::max(0.0, pass.depth - height);
    if (pass.revolution == revolution) thickness[pass.cutter] += cut;
    height = std::max(height, pass.depth);
  }
  return thickness;
}

void check_steady(const std::vector<double>& before, const std::vector<double>& last,
                  double advance) {
  for (std::size_t c = 0; c < last.size(); ++c)
    if (std::abs(last[c] - before[c]) > 1e-9 * advance)
      throw RunError("radial_plane_engagement: the cut is not steady after five revolutions");
}

}  // namespace

Engagement radial_plane_engagement(const bit::Bit& bit, double advance, double radial_spacing) {
  const RadialColumns columns = radial_columns(bit, advance, radial_spacing);
  const std::size_t cutters = bit.cutters.size();
  Engagement e{std::vector<double>(cutters), std::vector<double>(cutters), 0.0, columns.reach};
  for (std::size_t i = 0; i < columns.deepest.size(); ++i) {
    const std::vector<Deepest>& column = columns.deepest[i];
    const std::vector<double> thickness = removed(column, advance, revolutions - 1);
    check_steady(removed(column, advance, revolutions - 2), thickness, advance);
    for (std::size_t c = 0; c < cutters; ++c) {
      const double area = thickness[c] * columns.width;
      e.mean_area[c] += area;
      e.volume_per_revolution[c] += full_turn * columns.centre(i) * area;
      e.total += full_turn * columns.centre(i) * area;
    }
  }
  return e;
}

}  // namespace tdbd::reference
