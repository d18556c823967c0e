#include "reference/forces/chip_balance.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace tdbd::reference {
namespace {

using Vec2 = Eigen::Vector2d;

/// Unit vector at an angle above the direction of motion; x along the motion, y up.
Vec2 at(double angle) { return {std::cos(angle), std::sin(angle)}; }

Vec2 turned(const Vec2& v, double angle) { return Eigen::Rotation2Dd(angle) * v; }

constexpr double right_angle = 1.5707963267948966;

}  // namespace

BladeLoad chip_balance(const Chip& c) {
  // The shear plane rises ahead of the blade. Solid rock below it pushes the chip up and back. The
  // chip slides up the plane, so cohesion and friction act down along it.
  const Vec2 along_shear = at(c.shear_angle);
  const Vec2 from_rock = at(c.shear_angle + right_angle);
  const Vec2 rock_grains = turned(from_rock, c.friction_angle);
  const Vec2 rock_known =
      -c.width * c.shear_length * (c.pressure * from_rock + c.cohesion * along_shear);
  // The blade's front rises at the blade angle from the direction against the motion. The chip
  // slides up along it, so friction on the blade acts down.
  const Vec2 along_blade(-std::cos(c.blade_angle), std::sin(c.blade_angle));
  const Vec2 from_blade = turned(along_blade, -right_angle);
  const Vec2 blade_grains = turned(from_blade, -c.interface_angle);
  const Vec2 blade_known = -c.width * c.blade_length * c.pressure * from_blade;
  Eigen::Matrix2d directions;
  directions << rock_grains, blade_grains;
  const Vec2 grains = directions.partialPivLu().solve(-(rock_known + blade_known));
  const Vec2 on_blade = -(blade_known + grains.y() * blade_grains);
  return {.against_motion = -on_blade.x(), .up = on_blade.y()};
}

}  // namespace tdbd::reference
