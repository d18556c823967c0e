#include "reference/literature/drag/spokes/hanson_hansen_teeth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/drag/spokes/hanson_hansen.hpp"

namespace tdbd::reference {
namespace {

void check_cones(const RollerBit& bit) {
  const std::size_t n = bit.cones.size();
  if (n == 0 || n > most_cones)
    throw InputError("Hanson and Hansen: found a bit with " + std::to_string(n) +
                     " cones; teeth on cones need 1 to " + std::to_string(most_cones));
  for (const RollerCone& cone : bit.cones)
    if (!(cone.inertia > 0.0))
      throw InputError("Hanson and Hansen: found a cone without inertia; needs it above 0");
}

/// Rotates a vector from the frame of a cone (e_r, e_t, e_z) into that of the bit.
Vec3 of_azimuth(const Vec3& v, double azimuth) { return turned({Vec3::Zero(), azimuth}, v); }

SphereTooth sphere_tooth(const RollerCone& cone, std::size_t k, std::size_t i, double angle) {
  const RollerRow& row = cone.rows[i];
  const JournalAxes axes = journal_axes(cone);
  const auto in_B = [&](const Vec3& v) { return of_azimuth(v, cone.azimuth); };
  const Vec3 origin(0.0, cone.offset, cone.elevation);
  return {k,
          i,
          angle,
          row.radius,
          row.tooth_radius,
          in_B(axes.s),
          in_B(axes.u),
          in_B(Vec3::UnitY()),
          in_B(origin - row.along * axes.s),
          in_B(origin)};
}

}  // namespace

std::vector<SphereTooth> sphere_teeth(const RollerBit& bit) {
  check_cones(bit);
  std::vector<SphereTooth> teeth;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t i = 0; i < bit.cones[k].rows.size(); ++i)
      for (const double angle : bit.cones[k].rows[i].angles)
        teeth.push_back(sphere_tooth(bit.cones[k], k, i, angle));
  if (teeth.empty())
    throw InputError("Hanson and Hansen: found cones without teeth; needs at least one");
  return teeth;
}

double downwards(const SphereTooth& tooth, double cone_angle) {
  return std::cos(tooth.angle + cone_angle) * tooth.down_B.z();
}

PlacedTooth placed_tooth(const SphereTooth& tooth, const BitPlace& place, double cone_angle,
                         const Vec3& v_W, double bit_rate, double cone_rate) {
  const double gamma = tooth.angle + cone_angle, c = std::cos(place.angle),
               s = std::sin(place.angle);
  const auto in_W = [&](const Vec3& v) {
    return Vec3(c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z());
  };
  const Vec3 out_B = std::cos(gamma) * tooth.down_B + std::sin(gamma) * tooth.forward_B,
             tip_B = tooth.foot_B + tooth.radius * out_B;
  PlacedTooth t;
  t.out_W = in_W(out_B);
  t.journal_W = in_W(tooth.journal_B);
  t.arm_W = in_W(tip_B - tooth.origin_B);
  const Vec3 from_axis_W = in_W(tip_B);
  t.tip_W = place.p_WB + from_axis_W;
  t.centre_W = t.tip_W - tooth.size * t.out_W;
  t.v_W = v_W + bit_rate * Vec3(-from_axis_W.y(), from_axis_W.x(), 0.0) +
          cone_rate * t.journal_W.cross(t.arm_W);
  return t;
}

RimEllipse sphere_section(const Vec3& centre_W, double size, const SpokePlane& plane) {
  const double s = plane.beside(centre_W), squared = size * size - s * s;
  const Vec2 foot = plane.foot(centre_W);
  const double radius = squared > 0.0 ? std::sqrt(squared) : 0.0;
  return {foot.x(), foot.y(), radius, radius, 0.0};
}

double sphere_shadow(double size, double depth) {
  return std::numbers::pi * (2.0 * size * depth - depth * depth);
}

double sphere_surface(double size, double depth) { return 2.0 * std::numbers::pi * size * depth; }

double sphere_cap(double size, double depth) {
  return std::numbers::pi * depth * depth * (size - depth / 3.0);
}

Vec3 tooth_force(const ToothRock& rock, double size, double depth, double deepest,
                 const PlacedTooth& tooth) {
  if (depth <= 0.0) return Vec3::Zero();
  const double kept = std::max(0.0, 1.0 - std::max(0.0, deepest - depth) / rock.let_go);
  const double normal = kept * rock.pressure * sphere_shadow(size, std::min(depth, size));
  const Vec3 slip = tooth.v_W - tooth.v_W.dot(tooth.out_W) * tooth.out_W;
  const double speed = std::hypot(slip.norm(), rock.slip_speed);
  return -normal * tooth.out_W - rock.friction * normal / speed * slip;
}

}  // namespace tdbd::reference
