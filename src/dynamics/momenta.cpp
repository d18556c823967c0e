#include "dynamics/momenta.hpp"

#include "rotation/quaternion.hpp"

namespace tdbd::dynamics {

RotationState make_state(const Gyrostat& g, const Mat3& R_WB, const Vec3& w_B,
                         std::span<const double> spins, std::span<const double> angles) {
  RotationState s;
  s.q_WB = Eigen::Quaterniond(R_WB).normalized();
  rotation::renormalise(s.q_WB);
  Vec3 momentum_B = g.carrier_B * w_B;
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    const Cone& cone = g.cones[k];
    s.cone_angles.push_back(angles[k]);
    s.cone_momenta.push_back(cone.axial_inertia * (spins[k] + cone.axis_B.dot(w_B)));
    momentum_B += s.cone_momenta[k] * cone.axis_B;
  }
  s.momentum_W = s.q_WB * momentum_B;
  return s;
}

}  // namespace tdbd::dynamics
