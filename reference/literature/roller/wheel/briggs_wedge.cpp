#include "reference/literature/roller/wheel/briggs_wedge.hpp"

#include <cmath>
#include <numbers>

namespace tdbd::reference {
namespace {

constexpr double frictionless = 1e-9;  // rad: below, the limit is more accurate than the formula

/// Pressure over cohesion.
double bearing_factor(double friction_angle, double half_angle) {
  if (friction_angle < frictionless) return 2.0 * (1.0 + half_angle);
  const double sine = std::sin(friction_angle), tangent = std::tan(friction_angle);
  // Kp exp(2b tan phi) - 1, computed without cancellation.
  const double growth = std::log1p(sine) - std::log1p(-sine) + 2.0 * half_angle * tangent;
  return std::expm1(growth) / tangent;
}

}  // namespace

double wedge_pressure(const CoulombRock& rock, double half_angle) {
  return rock.cohesion * bearing_factor(rock.friction_angle, half_angle);
}

double wedge_cohesion(double pressure, double friction_angle, double half_angle) {
  return pressure / bearing_factor(friction_angle, half_angle);
}

double wedge_load(const WedgeTooth& tooth, double pressure, double depth) {
  return 2.0 * pressure * tooth.width * depth * std::tan(tooth.half_angle);
}

double wedge_depth(const WedgeTooth& tooth, double pressure, double load) {
  return load / (2.0 * pressure * tooth.width * std::tan(tooth.half_angle));
}

double wedge_work(const WedgeTooth& tooth, double pressure, double depth) {
  return pressure * tooth.width * depth * depth * std::tan(tooth.half_angle);
}

RigidSprocket rigid_sprocket(double radius, int teeth) {
  const double half = std::numbers::pi / teeth;
  return {.rise = radius * (1.0 - std::cos(half)),
          .pitch = 2.0 * radius * std::sin(half),
          .most_drag = std::tan(half),
          .mean_drag = 0.5 * std::tan(0.5 * half)};
}

double smooth_wheel_drag(double radius, double penetration) {
  return std::sqrt(penetration / (2.0 * radius - penetration));
}

}  // namespace tdbd::reference
