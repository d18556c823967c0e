#include "bit/profile/exposure.hpp"

#include <cmath>
#include <limits>

#include "bit/cutter/rim_reach.hpp"
#include "bit/profile/engagement.hpp"

namespace tdbd::bit {
namespace {

/// The largest s at which a cutter's line, r = tip_r + s sin, z = tip_z + s cos, meets a rim within
/// `range` of the tip; -infinity if it does not.
double farthest_crossing(const Cutter& c, const std::vector<Vec3>& rim, double range) {
  const double n_r = std::sin(c.profile_angle), n_z = std::cos(c.profile_angle);
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Vec3 &a = rim[k], &b = rim[(k + 1) % rim.size()];
    const double ar = a.x() - c.tip_radius, az = a.z() + c.tip_height;
    const double br = b.x() - c.tip_radius, bz = b.z() + c.tip_height;
    const double beside_a = ar * n_z - az * n_r, beside_b = br * n_z - bz * n_r;
    if ((beside_a < 0.0) == (beside_b < 0.0)) continue;
    const double w = beside_a / (beside_a - beside_b);
    const double s = std::lerp(ar * n_r + az * n_z, br * n_r + bz * n_z, w);
    if (std::abs(s) <= range) farthest = std::max(farthest, s);
  }
  return farthest;
}

}  // namespace

std::vector<double> exposures(const std::vector<Cutter>& cutters) {
  std::vector<std::vector<Vec3>> rims;
  rims.reserve(cutters.size());
  for (const Cutter& c : cutters) rims.push_back(turned_outline(c, rim_points));
  std::vector<double> exposure(cutters.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < cutters.size(); ++k) {
    double envelope = -std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < rims.size(); ++other)
      if (other != k)
        envelope =
            std::max(envelope, farthest_crossing(cutters[k], rims[other], cutters[k].diameter));
    if (std::isfinite(envelope)) exposure[k] = -envelope;
  }
  return exposure;
}

}  // namespace tdbd::bit
