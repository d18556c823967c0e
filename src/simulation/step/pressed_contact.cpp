#include "simulation/step/pressed_contact.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::simulation {
namespace {

/// The augmented normal force and its slope with respect to v_n.
struct Normal {
  double p, slope;  // N, N s/m
};

Normal normal_force(const PressedContact& c, double into, double along) {
  const double compliance = c.law.ramp > 0.0 ? c.law.ramp * along / c.law.limit : 0.0;
  const double slope = c.k_n / (1.0 + c.k_n * compliance);
  const double p = (c.p + c.k_n * (into - c.free_speed)) / (1.0 + c.k_n * compliance);
  if (p <= 0.0) return {0.0, 0.0};
  return p < c.law.limit ? Normal{p, slope} : Normal{c.law.limit, 0.0};
}

/// d mu/d speed, s/m.
double friction_slope(const forces::Sliding& s, double speed) {
  return -s.mu * s.weakening / s.weakening_speed * std::exp(-speed / s.weakening_speed);
}

}  // namespace

PartDrag drag_of(const PressedContact& c, const Vec3& v_W) {
  const Vec3& n = c.normal_W;
  const double into = v_W.dot(n);
  const Vec3 slip = v_W - into * n;
  const double along = slip.norm();
  const double at_slip = c.slip.value_or(along);
  const Normal normal = normal_force(c, into, at_slip);
  const double mu = forces::friction_at(c.law.sliding, at_slip), most = mu * normal.p;
  Vec3 t = c.friction_W + c.k_t * slip;
  const double wanted = t.norm();
  const Mat3 across = Mat3::Identity() - n * n.transpose();
  PartDrag drag;
  drag.resistance = normal.slope * n * n.transpose();
  if (wanted <= most) {
    drag.resistance += c.k_t * across;
  } else {
    const Vec3 e = t / wanted;
    t = most * e;
    drag.resistance += most / wanted * c.k_t * (across - e * e.transpose()) +
                       mu * normal.slope * e * n.transpose();
    if (along > 0.0 && !c.slip)
      drag.resistance +=
          normal.p * friction_slope(c.law.sliding, along) / along * e * slip.transpose();
  }
  drag.force.normal = normal.p;
  drag.force.tangential = t.norm();
  drag.force.force = -normal.p * n - t;
  return drag;
}

void update_estimate(PressedContact& c, const Vec3& v_W) {
  const PartDrag now = drag_of(c, v_W);
  c.p = now.force.normal;
  c.friction_W = -now.force.force - c.p * c.normal_W;
}

}  // namespace tdbd::simulation
