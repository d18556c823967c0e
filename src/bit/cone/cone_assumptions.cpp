#include "bit/cone/cone_assumptions.hpp"

#include <cmath>

#include "bit/cone/cone_measures.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

constexpr double standard_gravity = 9.80665;  ///< m/s2

double about_bit_axis(const MassProperties& m) {
  return m.inertia(2, 2) + m.mass * m.centre.head<2>().squaredNorm();
}

double over(double value, double whole) { return whole > 0.0 ? value / whole : 0.0; }

}  // namespace

ConeAssumptions cone_assumptions(const Bit& bit, int cone, double bit_speed, double cone_ratio) {
  const Pose& X_BK = bit.cones[static_cast<std::size_t>(cone)].X_BK;
  const ConeMass c = cone_mass(bit, cone);
  const MassProperties whole = mass_properties(bit);
  const double mass = c.body_K.mass, e = c.centre_off_axis;
  const Vec3 s_B = X_BK.R.col(2), centre_B = X_BK * Vec3(0.0, 0.0, c.body_K.centre.z());
  const double cosine = s_B.z(), sine = s_B.head<2>().norm();
  const Vec3 flat_B(centre_B.x(), centre_B.y(), 0.0);
  const double arm = (flat_B - s_B.dot(flat_B) * s_B).norm();
  const double tilt = std::hypot(c.body_K.inertia(0, 2), c.body_K.inertia(1, 2));
  const double once = 2.0 * tilt * std::abs(sine * cosine) + 2.0 * mass * e * arm;
  const double twice = 0.5 * (c.asymmetry * c.axial_inertia + mass * e * e) * sine * sine;
  ConeAssumptions a;
  a.cone_speed = bit_speed * cone_ratio;
  a.unbalance_force = mass * e * a.cone_speed * a.cone_speed;
  a.unbalance_share = over(a.unbalance_force, whole.mass * standard_gravity);
  a.gravity_torque = mass * standard_gravity * e;
  a.modulation_once = over(once, about_bit_axis(whole));
  a.modulation_twice = over(twice, about_bit_axis(whole));
  a.frequency = std::abs(a.cone_speed) / full_turn;
  a.torque_error = bit_speed * bit_speed * (0.5 * once + twice);
  a.torque_share = over(a.torque_error, c.axial_inertia * a.cone_speed * a.cone_speed);
  return a;
}

}  // namespace tdbd::bit
