#include "rock/cut/wide_paths.hpp"

namespace tdbd::rock {
namespace {

/// See mapped_direction_W.
TDBD_INLINE void map_direction(const CuttingGroup& g, const GroupMotion& m, const WideVec3& x_W,
                               WideVec3& u_W) {
  WideVec3 x_D;
  transform(m.X_DW1, x_W, x_D);
  Wide rho;
  square_root(x_D.x * x_D.x + x_D.y * x_D.y, rho);
  const WideMask is_off_axis = rho > 0.0;
  const Wide safe = is_off_axis ? rho : Wide{} + 1.0;
  const Wide c = is_off_axis ? x_D.x / safe : Wide{} + 1.0, s = is_off_axis ? x_D.y / safe : Wide{};
  const Vec3& U = g.update_direction_B;
  const WideVec3 u_D{c * U.x() - s * U.y(), s * U.x() + c * U.y(), Wide{} + U.z()};
  rotate(m.R_WD1, u_D, u_W);
}

TDBD_WIDE void find_wide_paths(const CuttingGroup& g, const GroupMotion& m, const WideVec3& x_W,
                               WidePaths& p) {
  map_direction(g, m, x_W, p.u_W);
  transform(m.X_PW0, x_W, p.q0);
  transform(m.X_PW1, x_W, p.q1);
  rotate(m.X_PW0.R, p.u_W, p.u0);
  rotate(m.X_PW1.R, p.u_W, p.u1);
}

}  // namespace

void find_paths(const CuttingGroup& g, const GroupMotion& m,
                const std::array<const Vec3*, lanes>& x_W, WidePaths& paths) {
  const WideVec3 places_W{{x_W[0]->x(), x_W[1]->x(), x_W[2]->x(), x_W[3]->x()},
                          {x_W[0]->y(), x_W[1]->y(), x_W[2]->y(), x_W[3]->y()},
                          {x_W[0]->z(), x_W[1]->z(), x_W[2]->z(), x_W[3]->z()}};
  find_wide_paths(g, m, places_W, paths);
}

}  // namespace tdbd::rock
