#include "reference/simulation/edge_laws.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {

EdgeLaw hanson_hansen_edges(const HansonHansenNumbers& n) {
  return [n](const EdgeCut& c) {
    if (!c.is_face) {
      const double normal = n.A5 * n.strength * c.area;
      return EdgeForce{n.A6 * normal, normal};
    }
    const double tangential =
        n.strength * (n.A1 * (1.0 + n.A2 * std::tan(c.rake)) * c.area + n.te_A4 * c.edge);
    return EdgeForce{tangential, std::tan(c.rake + n.A3) * tangential};
  };
}

EdgeLaw detournay_edges(const DetournayNumbers& n) {
  return [n](const EdgeCut& c) {
    const double depth = c.edge > 0.0 ? c.area / c.edge : 0.0;
    const double flat = c.is_face ? c.edge * std::min(n.kappa * depth, n.l) : c.area;
    const double cutting = c.is_face ? n.eps * c.area : 0.0, rubbing = n.sigma * flat;
    const double mu = n.mu * (1.0 - n.weakening * (1.0 - std::exp(-c.speed / n.weakening_speed)));
    return EdgeForce{cutting + mu * rubbing, n.zeta * cutting + rubbing};
  };
}

Vec3 directed(const EdgeForce& f, const Vec3& v, const Vec3& n) {
  constexpr double slip_speed = 1e-3;  // m/s, the program's default
  const double speed = v.norm();
  if (speed == 0.0) return Vec3::Zero();
  Vec3 along = v / speed;
  const double into = along.dot(n);
  const Vec3 across = n - into * along;
  const Vec3 aside = across / std::max(across.norm(), 0.5);
  if (into < 0.0) along -= into * n;
  return -speed / std::hypot(speed, slip_speed) * (f.tangential * along + f.normal * aside);
}

}  // namespace tdbd::reference
