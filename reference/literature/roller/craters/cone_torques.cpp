#include "reference/literature/roller/craters/cone_torques.hpp"

#include <cmath>

namespace tdbd::reference {
namespace {

/// Axes of a cone in space.
struct ConeInSpace {
  Vec3 foot, along;  ///< m; unit, s
};

ConeInSpace cone_in_space(const RollerCone& cone, double turn) {
  const double angle = cone.azimuth + turn, c = std::cos(angle), s = std::sin(angle);
  const Vec3 along = journal_axes(cone).s;
  return {{-cone.offset * s, cone.offset * c, cone.elevation},
          {c * along.x() - s * along.y(), s * along.x() + c * along.y(), along.z()}};
}

}  // namespace

RollerLoads teeth_loads(const RollerBit& bit, double turn, const std::vector<ToothState>& teeth_W,
                        const std::vector<double>& vertical, const std::vector<double>& cone_speeds,
                        const SlidingOptions& options, std::vector<ConeTorque>& cones) {
  RollerLoads loads;
  const double fade = options.slip_speed * options.slip_speed;
  std::size_t i = 0;
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    const ConeInSpace cone = cone_in_space(bit.cones[k], turn);
    ConeTorque& sum = cones[k];
    sum = {};
    for (const RollerRow& row : bit.cones[k].rows)
      for (std::size_t tooth = 0; tooth < row.angles.size(); ++tooth, ++i) {
        const double normal = vertical[i];
        if (normal <= 0.0) continue;
        const Vec3& p = teeth_W[i].place;
        const Vec3& v = teeth_W[i].velocity;
        const Vec3 arm = cone.along.cross(p - cone.foot);  // the velocity for a cone speed of 1
        const double per_speed =
            options.friction * normal / std::sqrt(v.x() * v.x() + v.y() * v.y() + fade);
        const Vec3 force(-per_speed * v.x(), -per_speed * v.y(), -normal);
        loads.force += force;
        loads.torque -= p.x() * force.y() - p.y() * force.x();
        const double drag = per_speed * (arm.x() * arm.x() + arm.y() * arm.y());
        sum.pull += force.dot(arm) + drag * cone_speeds[k];
        sum.drag += drag;
      }
    if (options.bearing > 0.0)
      sum.drag += options.bearing / std::hypot(cone_speeds[k], options.bearing_speed);
  }
  return loads;
}

double torque_of_step(const ConeTorque& torque, double speed, double inertia, double step,
                      const SlidingOptions& options) {
  const double now = torque.pull - torque.drag * speed;
  if (options.slip == SlipTime::beginning) return now;
  return now / (1.0 + step * torque.drag / inertia);
}

}  // namespace tdbd::reference
