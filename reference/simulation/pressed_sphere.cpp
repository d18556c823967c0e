#include "reference/simulation/pressed_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::reference {

SphereContact sphere_contact(double radius, double depth, const Vec3& v_W, int rings) {
  SphereContact c;
  if (depth <= 0.0) return c;
  const double widest = std::acos(std::clamp(1.0 - depth / radius, -1.0, 1.0));
  const Vec3 across(v_W.x(), v_W.y(), 0.0);
  const double v_h = across.norm();
  const Vec3 ahead = v_h > 0.0 ? Vec3(across / v_h) : Vec3(Vec3::UnitX());
  Vec3 moment = Vec3::Zero();
  for (int i = 0; i < rings; ++i) {
    const double a = widest * (i + 0.5) / rings,
                 ring = radius * radius * std::sin(a) * widest / rings;
    const double rise = v_W.z() * std::cos(a), run = v_h * std::sin(a);
    // From 0 (no part of the ring moves in) to pi (all of it does).
    const double reach = run > std::abs(rise) ? std::acos(-rise / run)
                         : rise >= 0.0        ? std::numbers::pi
                                              : 0.0;
    c.area += 2.0 * reach * ring;
    moment +=
        2.0 * ring * (std::sin(a) * std::sin(reach) * ahead + std::cos(a) * reach * Vec3::UnitZ());
  }
  c.area_vector_W = moment;  // the normal of a sphere is along its radius
  if (c.area > 0.0) c.middle_W = radius * moment / c.area;
  return c;
}

LumpedLaw law_of_tooth(const SphericalTooth& tooth) {
  return [tooth](const dynamics::DrillingSystem& system, const dynamics::DrillingState& s,
                 const dynamics::DrillingVelocity& v, dynamics::Wrench& w) {
    const Vec3 arm_W = s.rotation.q_WB * (tooth.centre_B - system.centre_B);
    const double depth = (s.c_W + arm_W).z() + tooth.radius;
    const SphereContact c =
        sphere_contact(tooth.radius, depth, v.v_W + v.w_W.cross(arm_W), tooth.rings);
    const double size = c.area_vector_W.norm();
    if (size == 0.0) return;
    const Vec3 n_W = c.area_vector_W / size, at_W = arm_W + c.middle_W;
    const Vec3 v_W = v.v_W + v.w_W.cross(at_W), slip_W = v_W - v_W.dot(n_W) * n_W;
    const double pressed =
        tooth.pressure * size * std::clamp(v_W.dot(n_W) / tooth.contact.crushing_speed, 0.0, 1.0);
    const Vec3 force_W = -pressed * (n_W + tooth.contact.mu * slip_W /
                                               std::hypot(slip_W.norm(), tooth.contact.slip_speed));
    w.force_W += force_W;
    w.torque_W += at_W.cross(force_W);
  };
}

}  // namespace tdbd::reference
