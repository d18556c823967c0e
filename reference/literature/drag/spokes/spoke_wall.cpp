#include "reference/literature/drag/spokes/spoke_wall.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {

SpokeWall round_wall(int spokes, double radius) {
  SpokeWall wall;
  wall.radius.assign(at(spokes), radius);
  for (int k = 0; k < spokes; ++k) wall.planes.push_back(spoke_plane(k, spokes));
  return wall;
}

double spring_force(const WallSpring& spring, double depth, double depth_rate) {
  if (depth <= 0.0) return 0.0;
  const double share = depth_rate > 0.0 ? 1.0 : spring.restitution * spring.restitution;
  return share * spring.stiffness * depth;
}

Vec3 wall_force(const SpokeWall& wall, const WallSpring& spring, double gage, const Vec3& c_W,
                const Vec3& v_W) {
  Vec3 force_W = Vec3::Zero();
  if (spring.stiffness == 0.0) return force_W;
  const double share = 4.0 / static_cast<double>(wall.planes.size());
  for (std::size_t k = 0; k < wall.planes.size(); ++k) {
    const SpokePlane& e = wall.planes[k];
    const double along = e.foot(c_W).x(), beside = e.beside(c_W);
    const double depth =
        along + std::sqrt(std::max(0.0, gage * gage - beside * beside)) - wall.radius[k];
    if (depth <= 0.0) continue;
    const double push = share * spring_force(spring, depth, e.foot(v_W).x());
    force_W.x() -= push * e.cosine;
    force_W.y() -= push * e.sine;
  }
  return force_W;
}

}  // namespace tdbd::reference
