#include "bit/body/rubbing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bit/cutter/rim_reach.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A rim at any radius, interpolated between the columns' centres; not reached where a neighbouring
/// column is not.
RimReach reach_at(const std::vector<RimReach>& columns, double width, double r) {
  const double place = std::max(0.0, r / width - 0.5);
  const auto i = static_cast<std::size_t>(place);
  if (i + 1 >= columns.size() || !columns[i].reached() || !columns[i + 1].reached()) return {};
  const double w = place - static_cast<double>(i);
  return {std::lerp(columns[i].z, columns[i + 1].z, w),
          std::lerp(columns[i].azimuth, columns[i + 1].azimuth, w)};
}

/// The rock that one vertex of the body faces.
struct Above {
  double rock = -infinity;      ///< m, depth at which the rock stands
  double touching = -infinity;  ///< m per revolution
};

Above above(const RimReaches& rims, const Vec3& x_B, double advance) {
  const double r = x_B.head<2>().norm(), azimuth = std::atan2(x_B.y(), x_B.x());
  Above a;
  for (const std::vector<RimReach>& columns : rims.of_cutter) {
    const RimReach c = reach_at(columns, rims.width, r);
    if (!c.reached()) continue;
    const double share = (c.azimuth - azimuth) / full_turn, before = share - std::floor(share);
    a.rock = std::max(a.rock, c.z - before * advance);
    const double gap = c.z - x_B.z();
    if (before > 0.0)
      a.touching = std::max(a.touching, gap / before);
    else if (gap > 0.0)
      a.touching = infinity;
  }
  return a;
}

}  // namespace

Rubbing rubbing(const std::vector<Cutter>& cutters, const Part& part, double advance,
                double column_width) {
  const RimReaches rims = rim_reaches(cutters, column_width);
  Rubbing least;
  least.clearance = least.touching_advance = infinity;
  for (const Vec3& x_P : part.mesh_P.positions) {
    const Vec3 x_B = part.X_BP * x_P;
    const Above a = above(rims, x_B, advance);
    if (a.rock == -infinity) {
      ++least.over_uncut;
      continue;
    }
    ++least.vertices;
    if (a.rock - x_B.z() < least.clearance) {
      least.clearance = a.rock - x_B.z();
      least.clearance_at_B = x_B;
    }
    if (std::max(0.0, a.touching) < least.touching_advance) {
      least.touching_advance = std::max(0.0, a.touching);
      least.touching_at_B = x_B;
    }
  }
  if (least.vertices == 0) least.clearance = least.touching_advance = 0.0;
  return least;
}

}  // namespace tdbd::bit
