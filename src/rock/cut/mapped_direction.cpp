#include "rock/cut/mapped_direction.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::rock {
namespace {

Vec3 from_segment(const bit::Segment& s, const Vec3& q) {
  const Vec3 along = s.to - s.from, from = q - s.from;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp(from.dot(along) / length2, 0.0, 1.0) : 0.0;
  return from - share * along;
}

/// U at azimuth 0. `radial_D`: unit vector from D's axis to x.
Vec3 normal_direction(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W,
                      const Vec3& radial_D) {
  const Vec3 q_P = 0.5 * (m.X_PW0 * x_W + m.X_PW1 * x_W);
  const Vec3 n_D = m.R_DB * (g.X_BP1.R * from_segment(*g.core_P, q_P));
  const Vec3 u(std::max(0.0, n_D.dot(radial_D)), 0.0, std::max(0.0, n_D.z()));
  const double length = u.norm();
  return length > 0.0 ? Vec3(u / length) : g.update_direction_B;
}

}  // namespace

Vec3 mapped_direction_W(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W) {
  const Vec3 x_D = m.X_DW1 * x_W;
  const double rho = std::sqrt(x_D.x() * x_D.x() + x_D.y() * x_D.y());
  const double c = rho > 0.0 ? x_D.x() / rho : 1.0, s = rho > 0.0 ? x_D.y() / rho : 0.0;
  const Vec3 U = g.core_P ? normal_direction(g, m, x_W, Vec3(c, s, 0.0)) : g.update_direction_B;
  return m.R_WD1 * Vec3(c * U.x() - s * U.y(), s * U.x() + c * U.y(), U.z());
}

}  // namespace tdbd::rock
