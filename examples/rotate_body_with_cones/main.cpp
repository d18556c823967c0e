// A body with three spinning cones turns without torque. Its angular momentum in space must not change, and its energy
// must stay within what the step allows.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "dynamics/gyrostat.hpp"
#include "dynamics/momenta.hpp"
#include "dynamics/rotation/step.hpp"

using namespace tdbd;
using namespace tdbd::dynamics;

/// Three cones, 120 degrees apart, with axes 35 degrees above the plane across the bit.
Gyrostat body_with_cones() {
  constexpr double degree = std::numbers::pi / 180.0;
  std::vector<Cone> cones;
  for (const double azimuth : {0.0, 120.0 * degree, 240.0 * degree})
    cones.push_back({Vec3(std::cos(35.0 * degree) * std::cos(azimuth),
                          std::cos(35.0 * degree) * std::sin(azimuth), std::sin(35.0 * degree)),
                     0.1});
  const Vec3 principal(2.0, 2.6, 3.0);  // kg m2
  return make_gyrostat(principal.asDiagonal(), cones);
}

int main() {
  const Gyrostat body = body_with_cones();
  const double spins[] = {-7.0, 3.0, -9.0}, angles[] = {0.0, 0.0, 0.0};  // rad/s, rad
  const RotationState first =
      make_state(body, Mat3::Identity(), Vec3(0.7, -0.5, 2.0), spins, angles);
  const Loads free;       // nothing acts on it
  const double h = 0.01;  // s
  const double energy = kinetic_energy(body, first);
  auto rotating = start(body, free, first);
  double worst_energy = 0.0, worst_momentum = 0.0;
  for (int i = 0; i < 1000; ++i) {
    step(body, free, Integrator{}, h, rotating);
    const RotationState& now = rotating.state;
    worst_energy = std::fmax(worst_energy, std::fabs(kinetic_energy(body, now) / energy - 1.0));
    worst_momentum = std::fmax(
        worst_momentum, (now.momentum_W - first.momentum_W).norm() / first.momentum_W.norm());
  }
  const Vec3 w_B = angular_velocity(body, rotating.state);
  std::printf("after %.2f s: angular velocity (%.6f, %.6f, %.6f) rad/s in the body\n",
              rotating.state.time, w_B.x(), w_B.y(), w_B.z());
  for (std::size_t k = 0; k < body.cones.size(); ++k)
    std::printf("cone %zu turned by %.6f rad\n", k + 1, rotating.state.cone_angles[k]);
  std::printf("momentum changed by %.1e, energy by at most %.1e (relative)\n", worst_momentum,
              worst_energy);
  return worst_momentum <= 1e-15 && worst_energy < 1e-3 ? 0 : 1;
}
