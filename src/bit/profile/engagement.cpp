#include "bit/profile/engagement.hpp"

#include <algorithm>
#include <cmath>

#include "bit/cutter/rim_reach.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

/// The fraction of a revolution by which `earlier` passes before `c`. The bit turns about +z, so
/// larger azimuths pass first; cutters at the same azimuth pass in the order of the table.
double share_before(const RimReach& earlier, const RimReach& c, bool is_listed_before) {
  const double share = (earlier.azimuth - c.azimuth) / full_turn;
  const double fraction = share - std::floor(share);
  return fraction == 0.0 && !is_listed_before ? 1.0 : fraction;
}

/// Height that cutter c removes in column i.
double height(const std::vector<std::vector<RimReach>>& reach, std::size_t c, std::size_t i,
              double advance) {
  const RimReach& own = reach[c][i];
  if (!own.reached()) return 0.0;
  double h = advance;
  for (std::size_t k = 0; k < reach.size() && h > 0.0; ++k)
    if (k != c && reach[k][i].reached())
      h = std::min(h, own.z - reach[k][i].z + advance * share_before(reach[k][i], own, k < c));
  return std::max(0.0, h);
}

}  // namespace

Engagement engagement(const std::vector<Cutter>& cutters, double advance, double column_width) {
  if (cutters.empty()) return {};
  const RimReaches rims = rim_reaches(cutters, column_width);
  const auto& reach = rims.of_cutter;
  const double width = rims.width;
  const std::size_t columns = reach.front().size();
  Engagement e{std::vector<double>(cutters.size()), std::vector<double>(cutters.size()),
               std::vector<int>(columns), width};
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t c = 0; c < cutters.size(); ++c) {
      const double h = height(reach, c, i, advance);
      e.area[c] += h * width;
      e.volume[c] += h * width * full_turn * (static_cast<double>(i) + 0.5) * width;
      e.cutting[i] += h > 0.0;
    }
  return e;
}

}  // namespace tdbd::bit
